// Entities named by their vertices, in an order in which equal ones are adjacent.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "base/ids.hpp"
#include "base/parallel.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// An entity named by its vertices in ascending order, and its index; for a face, the index of its tetrahedron or
/// triangle.
template <std::size_t n>
struct Named {
  std::array<Index, n> vertices;
  Index source;
  auto operator<=>(const Named&) const = default;
};

using Face = Named<3>;

/// What name(i, put) passes to put(vertices) for each i below `count`, by the smallest vertex, and sorted for each
/// vertex. Indices of vertices are below `vertices`.
template <std::size_t n, class Name>
[[nodiscard]] Buckets<Named<n>> sorted_by_vertices(std::size_t count, std::size_t vertices, const Name& name) {
  auto buckets = gather<Named<n>>(count, vertices, [&](std::size_t i, auto put) {
    name(i, [&](std::array<Index, n> of) {
      std::ranges::sort(of);
      put(of[0], Named<n>{of, static_cast<Index>(i)});
    });
  });
  for_each_index(buckets.keys(), [&](std::size_t v) { std::ranges::sort(buckets[v]); });
  return buckets;
}

template <std::size_t n>
[[nodiscard]] Buckets<Named<n>> named(const std::vector<std::array<Index, n>>& entities, std::size_t vertices) {
  return sorted_by_vertices<n>(entities.size(), vertices, [&](std::size_t i, auto put) { put(entities[i]); });
}

/// All four faces of each tetrahedron; a face of two tetrahedra occurs twice.
[[nodiscard]] inline Buckets<Face> faces_of(std::span<const std::array<Index, 4>> tets, std::size_t vertices) {
  return sorted_by_vertices<3>(tets.size(), vertices, [&](std::size_t t, auto put) {
    for (const auto& [i, j, k] : face_vertices) put({tets[t][i], tets[t][j], tets[t][k]});
  });
}

}  // namespace taut
