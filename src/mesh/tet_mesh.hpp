// The mesh under work: records of vertices, tetrahedra and triangles with full adjacency, and free lists.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "base/sym3.hpp"
#include "base/vec3.hpp"
#include "mesh/id_pool.hpp"

namespace taut {

using PatchId = std::uint32_t;
using LineId = std::uint32_t;
using RegionId = std::uint16_t;

/// Where a vertex lives on the geometry, and so where it may go: in the volume, on a patch, on a line, at a corner.
struct Tag {
  std::uint32_t dimension : 2 = 3;
  std::uint32_t id : 30 = 0;  ///< of the patch, line or corner

  constexpr Tag() = default;
  constexpr Tag(std::uint32_t d, std::uint32_t i) : dimension(d & 3U), id(i & 0x3fffffffU) {}
  constexpr bool operator==(const Tag&) const = default;
};

/// Position and metric in one record: whoever reads one reads the other.
struct Vertex {
  Vec3 x{};
  Sym3 m{};
};

/// What has been tried on a tetrahedron since it was made or last moved: a bit an edge and kind, a bit a face.
/// Insertion counts as tried for edges that are not too long, collapse for those that are not too short; `not_unit`
/// marks the edges that are either.
enum class Trial : std::uint32_t { insertion = 0, collapse = 6, edge_swap = 12, face_swap = 18, not_unit = 22 };

/// Positive, face f opposite to vertex f. `quality` is 1/Q and `tried` the bits of Trial.
struct Tet {
  std::array<VertexId, 4> v{none, none, none, none};
  std::array<FaceLink, 4> n{};
  float quality = 0;
  std::uint32_t tried = 0;

  [[nodiscard]] bool alive() const { return v[0] != none; }
  /// Whether every edge (of 6) or face (of 4) was.
  [[nodiscard]] bool all_tried(Trial kind, std::uint32_t entities) const {
    const std::uint32_t mask = ((1U << entities) - 1U) << static_cast<std::uint32_t>(kind);
    return (tried & mask) == mask;
  }
  [[nodiscard]] bool was_tried(Trial kind, int entity) const {
    return ((tried >> (static_cast<std::uint32_t>(kind) + static_cast<std::uint32_t>(entity))) & 1U) != 0;
  }
  void set_tried(Trial kind, int entity) {
    tried |= 1U << (static_cast<std::uint32_t>(kind) + static_cast<std::uint32_t>(entity));
  }
  void forget(Trial kind, std::uint32_t entities) { tried &= ~(entities << static_cast<std::uint32_t>(kind)); }
  /// Swaps, of edges and of faces, may succeed now where they failed.
  void forget_swaps() {
    forget(Trial::edge_swap, 0x3fU);
    forget(Trial::face_swap, 0xfU);
  }
  /// Insertion and collapse may succeed now where they failed.
  void forget_lengths() {
    const std::uint32_t edges = (tried >> static_cast<std::uint32_t>(Trial::not_unit)) & 0x3fU;
    forget(Trial::insertion, edges);
    forget(Trial::collapse, edges);
  }
  /// Notes whether an edge was found too long, too short or (both false) unit: only what has a chance is left to try.
  void set_length(int edge, bool is_long, bool is_short) {
    const auto bit = [](Trial kind, bool set) { return (set ? 1U : 0U) << static_cast<std::uint32_t>(kind); };
    const std::uint32_t all = bit(Trial::insertion, true) | bit(Trial::collapse, true) | bit(Trial::not_unit, true);
    const std::uint32_t found =
        bit(Trial::insertion, !is_long) | bit(Trial::collapse, !is_short) | bit(Trial::not_unit, is_long || is_short);
    tried = (tried & ~(all << edge)) | (found << edge);
  }
  [[nodiscard]] int index_of(VertexId vertex) const {
    return v[0] == vertex ? 0 : v[1] == vertex ? 1 : v[2] == vertex ? 2 : 3;
  }
  [[nodiscard]] bool has(VertexId vertex) const {
    return v[0] == vertex || v[1] == vertex || v[2] == vertex || v[3] == vertex;
  }
};

/// A face that is kept: of the boundary (one side) or between two tetrahedra (two). Seen from side 0 it points outward.
struct Triangle {
  std::array<VertexId, 3> v{none, none, none};
  PatchId patch = 0;
  std::array<FaceLink, 2> side{};                ///< faces of tetrahedra, or `outside`
  std::array<LineId, 3> line{none, none, none};  ///< feature line on the edge opposite to each vertex

  [[nodiscard]] bool alive() const { return v[0] != none; }
};

/// Ids are recycled through free lists; a dead entity has `none` as its first vertex (a vertex: no tetrahedron).
class TetMesh {
public:
  std::vector<Vertex> vertices;
  std::vector<TetId> tet_of_vertex;  ///< some tetrahedron of each vertex; `none` for a dead one
  std::vector<Tag> tag_of_vertex;
  std::vector<std::uint32_t> host_of_vertex;    ///< where in the background mesh the vertex lies
  std::vector<std::uint32_t> origin_of_vertex;  ///< index in the input, or `none`
  std::vector<std::uint8_t> restless;           ///< set while relocation may still gain at the vertex
  std::vector<float> drift;  ///< how far it moved, in the metric, since the swaps around were last tried

  std::vector<Tet> tets;
  std::vector<RegionId> region_of_tet;

  std::vector<Triangle> triangles;

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

  /// The tetrahedron's face beyond a link, across a triangle if there is one; `outside` at the boundary.
  [[nodiscard]] FaceLink beyond(TetId t, int f) const {
    const FaceLink link = tets[t].n[f];
    return link.is_triangle() ? other_side(link.triangle(), FaceLink::to_face(t, f)) : link;
  }
  [[nodiscard]] FaceLink other_side(TriangleId triangle, FaceLink from) const {
    const auto& side = triangles[triangle].side;
    return side[0] == from ? side[1] : side[0];
  }

  /// Fills the record of a dead vertex, which becomes alive when a tetrahedron of it is known.
  void put_vertex(VertexId v, const Vertex& vertex, Tag tag, std::uint32_t host);

  /// All arrays of vertices at once; new ones are dead.
  void resize_vertices(std::size_t count);

  /// Adds so many dead ids to a pool, free ones first; the arrays grow by the others. Until take_back() the counts
  /// above include what the pools have not used.
  void lend_vertices(std::size_t count, IdPool& to);
  void lend_tets(std::size_t count, IdPool& to);
  void lend_triangles(std::size_t count, IdPool& to);
  void take_back(IdPool& vertex_ids, IdPool& tet_ids, IdPool& triangle_ids);

  /// Drops the free lists; the arrays must be without dead entities.
  void forget_free() {
    free_vertices_.clear();
    free_tets_.clear();
    free_triangles_.clear();
  }

private:
  void resize_tets(std::size_t count);

  std::vector<VertexId> free_vertices_;
  std::vector<TetId> free_tets_;
  std::vector<TriangleId> free_triangles_;
};

}  // namespace taut
