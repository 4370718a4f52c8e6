#include "mesh/order.hpp"

#include <algorithm>
#include <functional>
#include <span>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "base/raw_array.hpp"
#include "mesh/hilbert.hpp"

namespace taut {
namespace {

using Ids = std::vector<std::uint32_t>;
using Order = std::span<const std::uint32_t>;  // the old ids of the living entities as they come to lie

Ids vertex_order(const TetMesh& mesh) {
  const Ids alive = indices_where(mesh.vertices.size(), [&](std::size_t v) { return mesh.tet_of_vertex[v] != none; });
  std::vector<Vec3> points(alive.size());
  for_each_index(alive.size(), [&](std::size_t i) { points[i] = mesh.x(alive[i]); });
  Ids order = hilbert_order(points);
  for_each_index(order.size(), [&](std::size_t i) { order[i] = alive[order[i]]; });
  return order;
}

Ids inverse(Order order, std::size_t old_size) {
  Ids new_of_old(old_size, none);
  for_each_index(order.size(), [&](std::size_t i) { new_of_old[order[i]] = static_cast<std::uint32_t>(i); });
  return new_of_old;
}

// The living entities by smallest new vertex, otherwise as they are.
template <class Entity>
Buckets<std::uint32_t> by_smallest_vertex(const std::vector<Entity>& entities, const Ids& new_vertex,
                                          std::size_t vertex_count) {
  return gather<std::uint32_t>(entities.size(), vertex_count, [&](std::size_t i, auto put) {
    if (!entities[i].alive()) return;
    std::uint32_t least = none;
    for (VertexId v : entities[i].v) least = std::min(least, new_vertex[v]);
    put(least, static_cast<std::uint32_t>(i));
  });
}

// Changes each value that stays, on the way to its new place.
template <class T, class Change = std::identity>
void permute(std::vector<T>& values, Order order, const Change& change = {}) {
  RawArray<T> moved(order.size());
  for_each_index(order.size(), [&](std::size_t i) { moved[i] = change(values[order[i]]); });
  values.resize(order.size());
  for_each_index(order.size(), [&](std::size_t i) { values[i] = moved[i]; });
}

struct Renumbering {
  Ids vertex, tet, triangle;

  [[nodiscard]] FaceLink operator()(FaceLink link) const {
    if (link == outside) return link;
    if (link.is_triangle()) return FaceLink::to_triangle(triangle[link.triangle()]);
    return FaceLink::to_face(tet[link.tet()], link.face());
  }
  [[nodiscard]] Tet operator()(Tet t) const {
    for (VertexId& v : t.v) v = vertex[v];
    for (FaceLink& n : t.n) n = (*this)(n);
    return t;
  }
  [[nodiscard]] Triangle operator()(Triangle t) const {
    for (VertexId& v : t.v) v = vertex[v];
    for (FaceLink& side : t.side) side = (*this)(side);
    return t;
  }
};

}  // namespace

void reorder(TetMesh& mesh) {
  const Ids vertices = vertex_order(mesh);
  Renumbering renumber;
  renumber.vertex = inverse(vertices, mesh.vertices.size());
  const auto tets = by_smallest_vertex(mesh.tets, renumber.vertex, vertices.size());
  renumber.tet = inverse(tets.all(), mesh.tets.size());
  const auto triangles = by_smallest_vertex(mesh.triangles, renumber.vertex, vertices.size());
  renumber.triangle = inverse(triangles.all(), mesh.triangles.size());

  permute(mesh.vertices, vertices);
  permute(mesh.tet_of_vertex, vertices, [&](TetId t) { return renumber.tet[t]; });
  permute(mesh.tag_of_vertex, vertices);
  permute(mesh.host_of_vertex, vertices);
  permute(mesh.origin_of_vertex, vertices);
  permute(mesh.restless, vertices);
  permute(mesh.drift, vertices);
  permute(mesh.tets, tets.all(), renumber);
  permute(mesh.region_of_tet, tets.all());
  permute(mesh.triangles, triangles.all(), renumber);
  mesh.forget_free();
}

}  // namespace taut
