// Balls of vertices and shells of edges, collected by walking from tetrahedron to tetrahedron.
#pragma once

#include <array>

#include "cavity/outcome.hpp"
#include "cavity/tet_set.hpp"
#include "mesh/tet_mesh.hpp"
#include "partition/block.hpp"

namespace taut {

/// Collects all tetrahedra at v, also across interfaces. The block must own the ball of v. For each tetrahedron, calls
/// visit(tet, local number of v, the vertex that the neighbour through which it was reached does not have; `none` for
/// the first). False if there is no room.
template <class Visit>
[[nodiscard]] bool walk_ball(const TetMesh& mesh, VertexId v, TetSet& ball, Visit visit) {
  ball.clear();
  std::array<std::int8_t, TetSet::capacity> came_by;  // the face through which it was reached
  (void)ball.add(mesh.tet_of_vertex[v]);
  came_by[0] = -1;
  for (int i = 0; i < ball.size(); ++i) {
    const Tet& tet = mesh.tets[ball[i]];
    const int at = tet.index_of(v);
    visit(tet, at, i == 0 ? none : tet.v[came_by[i]]);
    for (int f = 0; f < 4; ++f) {
      if (f == at || f == came_by[i]) continue;
      const FaceLink link = mesh.beyond(ball[i], f);
      if (link == outside || ball.contains(link.tet())) continue;
      if (ball.size() == TetSet::capacity) return false;
      __builtin_prefetch(&mesh.tets[link.tet()]);  // it is read later
      came_by[ball.size()] = static_cast<std::int8_t>(link.face());
      (void)ball.add(link.tet());
    }
  }
  return true;
}

/// The same without a visit.
[[nodiscard]] bool collect_ball(const TetMesh& mesh, VertexId v, TetSet& ball);

/// The tetrahedra around an edge ab. Tetrahedron i is positive as (a, b, ring[i], ring[i+1]), modulo the ring's size if
/// the shell is closed. An open shell starts and ends at the boundary.
struct Shell {
  static constexpr int capacity = 64;

  VertexId a = none, b = none;
  bool closed = false;
  int size = 0;       ///< tetrahedra
  int ring_size = 0;  ///< vertices: size, plus 1 if open
  int triangle_count = 0;
  std::array<TetId, capacity> tets{};
  std::array<std::uint8_t, capacity> edges{};  ///< the edge's local number in each tetrahedron
  std::array<VertexId, capacity + 1> ring{};
  std::array<TriangleId, 8> triangles{};  ///< those that contain the edge

  [[nodiscard]] VertexId next(int i) const { return ring[i + 1 == ring_size ? 0 : i + 1]; }
};

/// The shell of an edge of t, a tetrahedron of the block. Put off if a part of the shell is not in the block; too large
/// if there is no room, or if more triangles meet at the edge than in a valid geometry.
[[nodiscard]] Outcome collect_shell(const TetMesh& mesh, const Block& block, TetId t, int edge, Shell& shell);

}  // namespace taut
