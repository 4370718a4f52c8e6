#include "mesh/order.hpp"

#include <algorithm>
#include <span>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "base/raw_array.hpp"
#include "mesh/hilbert.hpp"

namespace taut {
namespace {

using Order = std::span<const std::uint32_t>;  // the old ids of the living entities, in their new order

std::vector<std::uint32_t> vertex_order(const TetMesh& mesh) {
  const auto alive = indices_where(mesh.vertices.size(), [&](std::size_t v) { return mesh.tet_of_vertex[v] != none; });
  std::vector<Vec3> points(alive.size());
  for_each_index(alive.size(), [&](std::size_t i) { points[i] = mesh.vertices[alive[i]].x; });
  std::vector<std::uint32_t> order = hilbert_order(points);
  for_each_index(order.size(), [&](std::size_t i) { order[i] = alive[order[i]]; });
  return order;
}

template <class Id>
std::vector<Id> inverse(Order order, std::size_t old_size) {
  std::vector<Id> new_of_old(old_size, none);
  for_each_index(order.size(), [&](std::size_t i) { new_of_old[order[i]] = static_cast<Id>(i); });
  return new_of_old;
}

// The living entities, sorted by smallest new vertex; ties keep their order.
template <class Entity>
Buckets<std::uint32_t> by_smallest_vertex(const std::vector<Entity>& entities, const std::vector<VertexId>& new_vertex,
                                          std::size_t vertex_count) {
  return gather<std::uint32_t>(entities.size(), vertex_count, [&](std::size_t i, auto put) {
    if (!entities[i].alive()) return;
    VertexId least = none;
    for (VertexId v : entities[i].v) least = std::min(least, new_vertex[v]);
    put(least, static_cast<std::uint32_t>(i));
  });
}

// An entry of any array after a renumbering: ids change, whatever holds none stays.
class Renumbered {
public:
  explicit Renumbered(const Renumbering& map) : map_(map) {}

  [[nodiscard]] TetId operator()(TetId t) const { return map_.tet[t]; }
  [[nodiscard]] Tet operator()(Tet t) const {
    for (VertexId& v : t.v) v = map_.vertex[v];
    for (FaceLink& n : t.n) n = of(n);
    return t;
  }
  [[nodiscard]] Triangle operator()(Triangle t) const {
    for (VertexId& v : t.v) v = map_.vertex[v];
    for (FaceLink& side : t.side) side = of(side);
    return t;
  }
  template <class T>
  [[nodiscard]] const T& operator()(const T& value) const {
    return value;
  }

private:
  [[nodiscard]] FaceLink of(FaceLink link) const {
    if (link == outside) return link;
    if (link.is_triangle()) return FaceLink::to_triangle(map_.triangle[link.triangle()]);
    return FaceLink::to_face(map_.tet[link.tet()], link.face());
  }

  const Renumbering& map_;
};

template <class T>
void permute(std::vector<T>& values, Order order, const Renumbered& renumbered) {
  RawArray<T> moved(order.size());
  for_each_index(order.size(), [&](std::size_t i) { moved[i] = renumbered(values[order[i]]); });
  values.resize(order.size());
  for_each_index(order.size(), [&](std::size_t i) { values[i] = moved[i]; });
}

}  // namespace

Renumbering reorder(TetMesh& mesh) {
  Renumbering map;
  const auto vertices = vertex_order(mesh);
  map.vertex = inverse<VertexId>(vertices, mesh.vertices.size());
  const auto tets = by_smallest_vertex(mesh.tets, map.vertex, vertices.size());
  map.tet = inverse<TetId>(tets.all(), mesh.tets.size());
  const auto triangles = by_smallest_vertex(mesh.triangles, map.vertex, vertices.size());
  map.triangle = inverse<TriangleId>(triangles.all(), mesh.triangles.size());

  const Renumbered renumbered(map);
  const auto to_order = [&](Order order) {
    return [&renumbered, order](auto& array, const auto&) { permute(array, order, renumbered); };
  };
  TetMesh::for_each_vertex_array(mesh, to_order(vertices));
  TetMesh::for_each_tet_array(mesh, to_order(tets.all()));
  TetMesh::for_each_triangle_array(mesh, to_order(triangles.all()));
  mesh.forget_free();
  return map;
}

}  // namespace taut
