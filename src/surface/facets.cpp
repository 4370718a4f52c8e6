#include "surface/facets.hpp"

#include <algorithm>
#include <utility>

#include "base/box.hpp"
#include "base/parallel.hpp"
#include "taut/mesh.hpp"

namespace taut {
namespace {

/// Whether each triangle has to be turned.
std::vector<std::uint8_t> turns(std::span<const Corners> triangles, std::span<const EdgePair> edges) {
  const auto edges_at = gather<Index>(edges.size(), triangles.size(), [&](std::size_t e, auto put) {
    for (const EdgeUse& use : edges[e]) put(use.triangle, static_cast<Index>(e));
  });
  const auto turns_over = [&](const EdgePair& e) {
    return runs_forward(triangles[e[0].triangle], e[0]) == runs_forward(triangles[e[1].triangle], e[1]);
  };
  constexpr std::uint8_t unknown = 2;
  std::vector<std::uint8_t> turned(triangles.size(), unknown);
  std::vector<TriangleId> open;
  for (const TriangleId first : ids<TriangleId>(triangles.size())) {
    if (turned[first] != unknown) continue;
    turned[first] = 0;
    open.assign(1, first);
    while (!open.empty()) {
      const TriangleId t = open.back();
      open.pop_back();
      for (const Index e : edges_at[t]) {
        const TriangleId other = edges[e][edges[e][0].triangle == t ? 1 : 0].triangle;
        if (turned[other] != unknown) continue;
        turned[other] = turned[t] ^ static_cast<std::uint8_t>(turns_over(edges[e]));
        open.push_back(other);
      }
    }
  }
  return turned;
}

}  // namespace

Facets facets_of(const TetMesh& mesh) {
  Facets facets{std::vector<Vec3>(mesh.vertices.size()), corners_of(mesh.triangles)};
  for_each_index(facets.points.size(), [&](std::size_t v) { facets.points[v] = mesh.vertices[v].x; });
  return facets;
}

double flatness_tolerance(const Facets& facets) {
  Box box;
  for (const Corners& t : facets.triangles)
    for (const VertexId v : t) box.include(facets.points[v]);
  return flatness * box.diagonal();
}

Vec3 area_normal(const Facets& facets, TriangleId t) {
  const auto [a, b, c] = places_of(facets, t);
  return cross(b - a, c - a);
}

std::vector<Vec3> unit_normals(const Facets& facets) {
  std::vector<Vec3> normals(facets.triangles.size());
  for_each_index(normals.size(), [&](std::size_t t) {
    const Vec3 n = area_normal(facets, static_cast<TriangleId>(t));
    const double length = norm(n);
    normals[t] = length > 0 ? 1 / length * n : Vec3{};
  });
  return normals;
}

Buckets<TriangleId> triangles_of_vertices(const Facets& facets) {
  return gather<TriangleId>(facets.triangles.size(), facets.points.size(), [&](std::size_t t, auto put) {
    for (const VertexId v : facets.triangles[t]) put(v, static_cast<TriangleId>(t));
  });
}

std::vector<EdgePair> orient(std::vector<Corners>& triangles, std::vector<EdgePair> edges) {
  const std::vector<std::uint8_t> turned = turns(triangles, edges);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (turned[t] != 0) std::swap(triangles[t][1], triangles[t][2]);
  for (EdgePair& pair : edges)
    for (EdgeUse& use : pair)
      if (turned[use.triangle] != 0) use.corner = (3 - use.corner) % 3;
  std::erase_if(edges, [&](const EdgePair& e) {
    return runs_forward(triangles[e[0].triangle], e[0]) == runs_forward(triangles[e[1].triangle], e[1]);
  });
  return edges;
}

}  // namespace taut
