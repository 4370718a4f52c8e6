// The edges of a surface mesh, with the triangles that meet there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// The vertices of a triangle.
using Corners = std::array<VertexId, 3>;

/// The corners of the triangles of a mesh, those of dead ones too, so that ids stay.
[[nodiscard]] std::vector<Corners> corners_of(std::span<const Triangle> triangles);

/// One triangle at an edge: the edge is opposite to the triangle's vertex `corner`.
struct EdgeUse {
  std::array<VertexId, 2> edge;  ///< ascending
  TriangleId triangle;
  int corner;
};

/// All uses, in ascending order of edge and triangle, so that those of one edge are adjacent.
[[nodiscard]] std::vector<EdgeUse> edge_uses(std::span<const Corners> triangles);

/// Calls visit(span of the uses of one edge) for each edge.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit visit) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].edge == uses[i].edge) ++j;
    visit(uses.subspan(i, j - i));
    i = j;
  }
}

/// An edge at which two triangles meet.
using EdgePair = std::array<EdgeUse, 2>;

/// Whether the triangle of the use passes the edge from its first vertex to its second.
[[nodiscard]] inline bool runs_forward(const Corners& triangle, const EdgeUse& use) {
  return triangle[(use.corner + 1) % 3] == use.edge[0];
}

}  // namespace taut
