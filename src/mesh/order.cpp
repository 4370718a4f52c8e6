#include "mesh/order.hpp"

#include <algorithm>

#include "mesh/hilbert.hpp"

namespace taut {
namespace {

using Ids = std::vector<std::uint32_t>;

// The living vertices in their new order.
Ids vertex_order(const TetMesh& mesh) {
  Ids alive;
  std::vector<Vec3> points;
  for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.is_vertex_alive(v)) continue;
    alive.push_back(v);
    points.push_back(mesh.x(v));
  }
  Ids order = hilbert_order(points);
  for (auto& i : order) i = alive[i];
  return order;
}

Ids inverse(const Ids& order, std::size_t old_size) {
  Ids new_of_old(old_size, none);
  for (std::uint32_t i = 0; i < order.size(); ++i) new_of_old[order[i]] = i;
  return new_of_old;
}

// The living entities by smallest new vertex, stable: a counting sort.
template <class Entity>
Ids order_by_smallest_vertex(const std::vector<Entity>& entities, const Ids& new_vertex, std::size_t vertex_count) {
  const auto smallest = [&](const Entity& e) {
    std::uint32_t least = none;
    for (VertexId v : e.v) least = std::min(least, new_vertex[v]);
    return least;
  };
  Ids start(vertex_count + 1, 0);
  std::size_t alive = 0;
  for (const auto& e : entities) {
    if (!e.alive()) continue;
    ++start[smallest(e) + 1];
    ++alive;
  }
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  Ids order(alive);
  for (std::uint32_t i = 0; i < entities.size(); ++i)
    if (entities[i].alive()) order[start[smallest(entities[i])]++] = i;
  return order;
}

template <class T>
void permute(std::vector<T>& values, const Ids& order) {
  std::vector<T> old(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) old[i] = values[order[i]];
  values.swap(old);
}

struct Renumbering {
  Ids vertex, tet, triangle;

  [[nodiscard]] FaceLink operator()(FaceLink link) const {
    if (link == outside) return link;
    if (link.is_triangle()) return FaceLink::to_triangle(triangle[link.triangle()]);
    return FaceLink::to_face(tet[link.tet()], link.face());
  }
};

}  // namespace

void reorder(TetMesh& mesh) {
  const Ids vertices = vertex_order(mesh);
  Renumbering renumber;
  renumber.vertex = inverse(vertices, mesh.vertices.size());
  const Ids tets = order_by_smallest_vertex(mesh.tets, renumber.vertex, vertices.size());
  renumber.tet = inverse(tets, mesh.tets.size());
  const Ids triangles = order_by_smallest_vertex(mesh.triangles, renumber.vertex, vertices.size());
  renumber.triangle = inverse(triangles, mesh.triangles.size());

  permute(mesh.vertices, vertices);
  permute(mesh.tet_of_vertex, vertices);
  permute(mesh.tag_of_vertex, vertices);
  permute(mesh.host_of_vertex, vertices);
  permute(mesh.origin_of_vertex, vertices);
  permute(mesh.restless, vertices);
  permute(mesh.drift, vertices);
  permute(mesh.tets, tets);
  permute(mesh.region_of_tet, tets);
  permute(mesh.triangles, triangles);
  for (TetId& t : mesh.tet_of_vertex) t = renumber.tet[t];
  for (Tet& tet : mesh.tets) {
    for (VertexId& v : tet.v) v = renumber.vertex[v];
    for (FaceLink& n : tet.n) n = renumber(n);
  }
  for (Triangle& triangle : mesh.triangles) {
    for (VertexId& v : triangle.v) v = renumber.vertex[v];
    for (FaceLink& side : triangle.side) side = renumber(side);
  }
  mesh.forget_free();
}

}  // namespace taut
