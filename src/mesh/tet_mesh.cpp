#include "mesh/tet_mesh.hpp"

#include "taut/error.hpp"

namespace taut {
namespace {

// A link packs 4 t + f beside one bit that tells triangles from tetrahedra.
constexpr std::size_t max_tets = std::size_t{1} << 29;

std::uint32_t pop(std::vector<std::uint32_t>& free) {
  const std::uint32_t id = free.back();
  free.pop_back();
  return id;
}

}  // namespace

VertexId TetMesh::add_vertex(const Vertex& vertex, Tag tag, std::uint32_t host) {
  if (free_vertices_.empty()) {
    free_vertices_.push_back(static_cast<VertexId>(vertices.size()));
    vertices.emplace_back();
    tet_of_vertex.push_back(none);
    tag_of_vertex.emplace_back();
    host_of_vertex.push_back(none);
    origin_of_vertex.push_back(none);
    restless.push_back(0);
    drift.push_back(0);
  }
  const VertexId v = pop(free_vertices_);
  vertices[v] = vertex;
  tag_of_vertex[v] = tag;
  host_of_vertex[v] = host;
  origin_of_vertex[v] = none;
  restless[v] = 1;
  drift[v] = 0;
  return v;
}

TetId TetMesh::add_tet() {
  if (!free_tets_.empty()) return pop(free_tets_);
  if (tets.size() == max_tets) throw Failure("more than 2^29 tetrahedra: beyond 32-bit ids");
  tets.emplace_back();
  region_of_tet.push_back(0);
  return static_cast<TetId>(tets.size() - 1);
}

TriangleId TetMesh::add_triangle() {
  if (!free_triangles_.empty()) return pop(free_triangles_);
  triangles.emplace_back();
  return static_cast<TriangleId>(triangles.size() - 1);
}

void TetMesh::remove_vertex(VertexId v) {
  tet_of_vertex[v] = none;
  free_vertices_.push_back(v);
}

void TetMesh::remove_tet(TetId t) {
  tets[t].v[0] = none;
  free_tets_.push_back(t);
}

void TetMesh::remove_triangle(TriangleId t) {
  triangles[t].v[0] = none;
  free_triangles_.push_back(t);
}

}  // namespace taut
