// Balls of vertices and shells of edges, gathered by walking from tetrahedron to tetrahedron.
#pragma once

#include <array>

#include "cavity/tet_set.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// All tetrahedra at v, those across interfaces too. False if there is no room for them.
[[nodiscard]] bool collect_ball(const TetMesh& mesh, VertexId v, TetSet& ball);

/// The tetrahedra round an edge ab. Tetrahedron i is positive as (a, b, ring[i], ring[i+1]), modulo the ring's size if
/// the shell is closed; an open one starts and ends at the boundary.
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

/// False if there is no room, or more triangles meet at the edge than a sound geometry has.
[[nodiscard]] bool collect_shell(const TetMesh& mesh, TetId t, int edge, Shell& shell);

}  // namespace taut
