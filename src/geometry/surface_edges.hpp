// The edges of a surface mesh, with the triangles that meet there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// One triangle at an edge: the edge is opposite to the triangle's vertex `corner`.
struct EdgeUse {
  std::array<VertexId, 2> edge;  ///< ascending
  TriangleId triangle;
  int corner;
};

/// All uses, in ascending order of edge and triangle, so that those of one edge are adjacent.
[[nodiscard]] std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles);

/// Calls visit(span of the uses of one edge) for each edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeUse>& uses, Visit visit) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].edge == uses[i].edge) ++j;
    visit(std::span<const EdgeUse>(uses.data() + i, j - i));
    i = j;
  }
}

}  // namespace taut
