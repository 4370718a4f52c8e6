#include "mesh/tet_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/error.hpp"

namespace taut {
namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 30;
constexpr std::size_t most_vertices = std::size_t{1} << 31;

void require_ids(const char* what, std::size_t count, std::size_t most) {
  if (count >= most)
    throw Failure(
        fmt::format("{} {} needed, expected fewer than {}: 32-bit ids cannot number them", count, what, most));
}

// Takes `count` ids, free ones first; the others are new, counted from `size`, and need room.
template <class Id>
std::vector<Id> lend(std::vector<Id>& free, std::size_t size, std::size_t count) {
  const std::size_t reused = std::min(count, free.size());
  std::vector<Id> lent(free.rbegin(), free.rbegin() + static_cast<std::ptrdiff_t>(reused));
  free.resize(free.size() - reused);
  lent.reserve(count);
  for (std::size_t i = reused; i < count; ++i) lent.push_back(static_cast<Id>(size + i - reused));
  return lent;
}

template <class Id>
std::size_t size_with(const std::vector<Id>& lent, std::size_t size) {
  return lent.empty() ? size : std::max(size, std::size_t{lent.back()} + 1);
}

template <class Id>
void append(std::vector<Id>& free, std::span<const Id> dead) {
  free.insert(free.end(), dead.begin(), dead.end());
}

}  // namespace

void TetMesh::resize_vertices(std::size_t count) {
  require_ids("vertices", count, most_vertices);
  for_each_vertex_array(*this, [&](auto& array, const auto& dead) { array.resize(count, dead); });
}

void TetMesh::resize_tets(std::size_t count) {
  require_ids("tetrahedra", count, TetMesh::most_tets);
  for_each_tet_array(*this, [&](auto& array, const auto& dead) { array.resize(count, dead); });
}

void TetMesh::resize_triangles(std::size_t count) {
  require_ids("triangles", count, most_triangles);
  for_each_triangle_array(*this, [&](auto& array, const auto& dead) { array.resize(count, dead); });
}

void TetMesh::put_vertex(VertexId v, const Vertex& vertex, Tag tag, CellId host, SeatId seat) {
  vertices[v] = vertex;
  tag_of_vertex[v] = tag;
  host_of_vertex[v] = host;
  seat_of_vertex[v] = seat;
  origin_of_vertex[v] = none;
  state_of_vertex[v] = {};
}

std::vector<VertexId> TetMesh::lend_vertices(std::size_t count) {
  auto lent = lend(free_vertices_, vertices.size(), count);
  resize_vertices(size_with(lent, vertices.size()));
  return lent;
}

std::vector<TetId> TetMesh::lend_tets(std::size_t count) {
  auto lent = lend(free_tets_, tets.size(), count);
  resize_tets(size_with(lent, tets.size()));
  return lent;
}

std::vector<TriangleId> TetMesh::lend_triangles(std::size_t count) {
  auto lent = lend(free_triangles_, triangles.size(), count);
  resize_triangles(size_with(lent, triangles.size()));
  return lent;
}

void TetMesh::take_back(std::span<const VertexId> dead) {
  append(free_vertices_, dead);
}
void TetMesh::take_back(std::span<const TetId> dead) {
  append(free_tets_, dead);
}
void TetMesh::take_back(std::span<const TriangleId> dead) {
  append(free_triangles_, dead);
}

}  // namespace taut
