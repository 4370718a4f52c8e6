#include "mesh/tet_mesh.hpp"

#include <algorithm>

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

// Returns how many of `count` ids are new, counted from `size`.
std::size_t lend(std::vector<std::uint32_t>& free, std::size_t size, std::size_t count, IdPool& to) {
  const std::size_t reused = std::min(count, free.size());
  for (std::size_t i = 0; i < reused; ++i) to.add(pop(free));
  for (std::size_t i = reused; i < count; ++i) to.add(static_cast<std::uint32_t>(size + i - reused));
  return count - reused;
}

}  // namespace

void TetMesh::resize_vertices(std::size_t count) {
  vertices.resize(count);
  tet_of_vertex.resize(count, none);
  tag_of_vertex.resize(count);
  host_of_vertex.resize(count, none);
  origin_of_vertex.resize(count, none);
  restless.resize(count, 0);
  drift.resize(count, 0);
}

void TetMesh::resize_tets(std::size_t count) {
  if (count > max_tets) throw Failure("more than 2^29 tetrahedra: beyond 32-bit ids");
  tets.resize(count);
  region_of_tet.resize(count, 0);
}

void TetMesh::put_vertex(VertexId v, const Vertex& vertex, Tag tag, std::uint32_t host) {
  vertices[v] = vertex;
  tag_of_vertex[v] = tag;
  host_of_vertex[v] = host;
  origin_of_vertex[v] = none;
  restless[v] = 1;
  drift[v] = 0;
}

void TetMesh::lend_vertices(std::size_t count, IdPool& to) {
  const std::size_t fresh = lend(free_vertices_, vertices.size(), count, to);
  resize_vertices(vertices.size() + fresh);
}

void TetMesh::lend_tets(std::size_t count, IdPool& to) {
  const std::size_t fresh = lend(free_tets_, tets.size(), count, to);
  resize_tets(tets.size() + fresh);
}

void TetMesh::lend_triangles(std::size_t count, IdPool& to) {
  const std::size_t fresh = lend(free_triangles_, triangles.size(), count, to);
  triangles.resize(triangles.size() + fresh);
}

void TetMesh::take_back(IdPool& vertex_ids, IdPool& tet_ids, IdPool& triangle_ids) {
  vertex_ids.return_to(free_vertices_);
  tet_ids.return_to(free_tets_);
  triangle_ids.return_to(free_triangles_);
}

}  // namespace taut
