// The part of a mesh that one worker may change during a round, without synchronisation.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.hpp"
#include "partition/id_pool.hpp"

namespace taut {

/// How many ids a block may need. Operations that find no id left are put off.
struct IdNeed {
  std::size_t vertices = 0, tets = 0, triangles = 0;

  IdNeed& operator+=(const IdNeed& other) {
    vertices += other.vertices;
    tets += other.tets;
    triangles += other.triangles;
    return *this;
  }
};

/// A block owns vertices, and the tetrahedra and triangles all of whose vertices it owns. A tetrahedron whose vertices
/// have several owners belongs to no block: it does not change while the blocks exist, and its vertices do not move. So
/// whether a block owns all tetrahedra at a vertex cannot change either.
class Block {
public:
  /// The whole mesh, for a single worker.
  Block() = default;
  /// `owner` and `at_seam` hold one entry per vertex and must outlive the block.
  Block(std::uint32_t number, const std::vector<std::uint16_t>& owner, const std::vector<std::uint8_t>& at_seam)
      : number_(number), owner_(&owner), at_seam_(&at_seam) {}

  IdPool<VertexId> vertices;
  IdPool<TetId> tets;
  IdPool<TriangleId> triangles;
  std::vector<TetId> shared_tets;  ///< with several owners, one of them this block; each is listed by only one block

  [[nodiscard]] bool owns(VertexId v) const { return owner_ == nullptr || (*owner_)[v] == number_; }
  /// Whether the block owns every tetrahedron at this vertex, which it owns.
  [[nodiscard]] bool owns_ball(VertexId v) const { return at_seam_ == nullptr || (*at_seam_)[v] == 0; }

  void borrow(TetMesh& mesh, const IdNeed& need) {
    vertices.add(mesh.lend_vertices(need.vertices));
    tets.add(mesh.lend_tets(need.tets));
    triangles.add(mesh.lend_triangles(need.triangles));
  }
  void give_back(TetMesh& mesh) {
    mesh.take_back(vertices.release());
    mesh.take_back(tets.release());
    mesh.take_back(triangles.release());
  }

  VertexId add_vertex(TetMesh& mesh, const Vertex& vertex, Tag tag, CellId host, SeatId seat = none) {
    const VertexId v = vertices.take();
    mesh.put_vertex(v, vertex, tag, host, seat);
    return v;
  }
  void remove_vertex(TetMesh& mesh, VertexId v) {
    mesh.tet_of_vertex[v] = none;
    vertices.recycle(v);
  }
  void remove_tet(TetMesh& mesh, TetId t) {
    mesh.tets[t].v[0] = none;
    tets.recycle(t);
  }
  void remove_triangle(TetMesh& mesh, TriangleId t) {
    mesh.triangles[t].v[0] = none;
    triangles.recycle(t);
  }

private:
  std::uint32_t number_ = 0;
  const std::vector<std::uint16_t>* owner_ = nullptr;
  const std::vector<std::uint8_t>* at_seam_ = nullptr;
};

}  // namespace taut
