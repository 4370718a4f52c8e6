// The working mesh: records of vertices, tetrahedra and triangles with full adjacency, and free lists.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "base/sym3.hpp"
#include "base/trials.hpp"
#include "base/vec3.hpp"

namespace taut {

/// Position and metric in one record, because code that reads one also reads the other.
struct Vertex {
  Vec3 x{};
  Sym3 m{};
};

/// What the adaptation remembers of a vertex. The mesh itself does not depend on it.
struct VertexState {
  float drift = 0;       ///< how far the vertex moved, in the metric, since the swaps around it were last tried
  bool restless = true;  ///< whether relocation may still gain at the vertex
};

/// What the adaptation remembers of a tetrahedron. Kept in its record: who reads one reads the other.
struct TetState {
  float quality = 0;  ///< 1/Q
  Trials tried;       ///< since the tetrahedron was made or last moved
};

/// Positive, face f opposite to vertex f.
struct Tet {
  std::array<VertexId, 4> v{none, none, none, none};
  std::array<FaceLink, 4> n{};
  TetState state{};

  [[nodiscard]] bool alive() const { return v[0] != none; }
  [[nodiscard]] int index_of(VertexId vertex) const {
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }
  [[nodiscard]] bool has(VertexId vertex) const {
    return v[0] == vertex || v[1] == vertex || v[2] == vertex || v[3] == vertex;
  }
};

/// A face that is kept: on the boundary (one side) or between two tetrahedra (two sides). Seen from side 0, it points
/// outward.
struct Triangle {
  std::array<VertexId, 3> v{none, none, none};
  PatchId patch{};
  std::array<FaceLink, 2> side{};                ///< faces of tetrahedra, or `outside`
  std::array<LineId, 3> line{none, none, none};  ///< feature line on the edge opposite to each vertex

  [[nodiscard]] bool alive() const { return v[0] != none; }
};

/// Ids are recycled through free lists. A dead entity has `none` as its first vertex; a dead vertex has no tetrahedron.
class TetMesh {
public:
  /// A link packs 4 t + f beside one bit that tells triangles from tetrahedra.
  static constexpr std::size_t most_tets = std::size_t{1} << 29;

  std::vector<Vertex> vertices;
  std::vector<TetId> tet_of_vertex;  ///< some tetrahedron of each vertex; `none` for a dead one
  std::vector<Tag> tag_of_vertex;
  std::vector<CellId> host_of_vertex;           ///< where in the background mesh the vertex lies
  std::vector<SeatId> seat_of_vertex;           ///< where on the reference surface it was last found, or `none`
  std::vector<std::uint32_t> origin_of_vertex;  ///< index in the input, or `none`
  std::vector<VertexState> state_of_vertex;

  std::vector<Tet> tets;
  std::vector<RegionId> region_of_tet;

  std::vector<Triangle> triangles;

  // The one list of the arrays of each entity: whatever treats all of them walks it. visit(array, what a dead entity
  // has there).
  template <class Mesh, class Visit>
  static void for_each_vertex_array(Mesh& mesh, Visit visit) {
    visit(mesh.vertices, Vertex{});
    visit(mesh.tet_of_vertex, TetId{none});
    visit(mesh.tag_of_vertex, Tag{});
    visit(mesh.host_of_vertex, CellId{none});
    visit(mesh.seat_of_vertex, SeatId{none});
    visit(mesh.origin_of_vertex, std::uint32_t{none});
    visit(mesh.state_of_vertex, VertexState{});
  }
  template <class Mesh, class Visit>
  static void for_each_tet_array(Mesh& mesh, Visit visit) {
    visit(mesh.tets, Tet{});
    visit(mesh.region_of_tet, RegionId{});
  }
  template <class Mesh, class Visit>
  static void for_each_triangle_array(Mesh& mesh, Visit visit) {
    visit(mesh.triangles, Triangle{});
  }

  [[nodiscard]] auto vertex_ids() const { return ids<VertexId>(vertices.size()); }
  [[nodiscard]] auto tet_ids() const { return ids<TetId>(tets.size()); }
  [[nodiscard]] auto triangle_ids() const { return ids<TriangleId>(triangles.size()); }

  [[nodiscard]] std::size_t vertex_count() const { return vertices.size() - free_vertices_.size(); }
  [[nodiscard]] std::size_t tet_count() const { return tets.size() - free_tets_.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() - free_triangles_.size(); }

  [[nodiscard]] const Vec3& x(VertexId v) const { return vertices[v].x; }
  [[nodiscard]] bool is_vertex_alive(VertexId v) const { return tet_of_vertex[v] != none; }

  /// The vertices of face f of tetrahedron t, outward.
  [[nodiscard]] std::array<VertexId, 3> face(TetId t, int f) const {
    const auto& v = tets[t].v;
    const auto& k = face_vertices[f];
    return {v[k[0]], v[k[1]], v[k[2]]};
  }

  /// The face of a tetrahedron behind a link, also across a triangle; `outside` at the boundary.
  [[nodiscard]] FaceLink beyond(TetId t, int f) const {
    const FaceLink link = tets[t].n[f];
    return link.is_triangle() ? other_side(link.triangle(), FaceLink::to_face(t, f)) : link;
  }
  [[nodiscard]] FaceLink other_side(TriangleId triangle, FaceLink from) const {
    const auto& side = triangles[triangle].side;
    return side[0] == from ? side[1] : side[0];
  }

  /// Fills the record of a dead vertex. It becomes alive when it gets a tetrahedron.
  void put_vertex(VertexId v, const Vertex& vertex, Tag tag, CellId host, SeatId seat = none);

  /// All arrays of an entity at once; new ones are dead. Throws Failure beyond the id space.
  void resize_vertices(std::size_t count);
  void resize_tets(std::size_t count);
  void resize_triangles(std::size_t count);

  /// So many dead ids, free ones first; the arrays grow by the others. Until they are taken back the counts above
  /// include them.
  [[nodiscard]] std::vector<VertexId> lend_vertices(std::size_t count);
  [[nodiscard]] std::vector<TetId> lend_tets(std::size_t count);
  [[nodiscard]] std::vector<TriangleId> lend_triangles(std::size_t count);

  /// Dead ids go on top of the free lists, the last one uppermost.
  void take_back(std::span<const VertexId> dead);
  void take_back(std::span<const TetId> dead);
  void take_back(std::span<const TriangleId> dead);

  /// Clears the free lists. The arrays must contain no dead entities.
  void forget_free() {
    free_vertices_.clear();
    free_tets_.clear();
    free_triangles_.clear();
  }

private:
  std::vector<VertexId> free_vertices_;
  std::vector<TetId> free_tets_;
  std::vector<TriangleId> free_triangles_;
};

}  // namespace taut
