// The unit cube as n^3 boxes of six tetrahedra each.
#pragma once

#include <algorithm>

#include "taut/mesh.hpp"

namespace taut::test {

/// Kuhn's subdivision, positively oriented, without triangles.
inline Mesh grid(Index n) {
  Mesh mesh;
  const auto coordinate = [n](Index i) { return static_cast<double>(i) / static_cast<double>(n); };
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j)
      for (Index k = 0; k <= n; ++k) mesh.points.push_back({coordinate(i), coordinate(j), coordinate(k)});
  const std::array<Index, 3> stride = {(n + 1) * (n + 1), n + 1, 1};
  // Each path from the lowest corner of a box to its highest is a tetrahedron; odd permutations are reversed in
  // orientation.
  std::array<std::size_t, 3> axes = {0, 1, 2};
  bool even = true;
  const std::array<std::array<std::size_t, 3>, 6> walks = {
      {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& walk : walks) {
    axes = walk;
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j)
        for (Index k = 0; k < n; ++k) {
          const Index a = i * stride[0] + j * stride[1] + k;
          const Index b = a + stride[axes[0]], c = b + stride[axes[1]], d = c + stride[axes[2]];
          mesh.tetrahedra.push_back(even ? std::array<Index, 4>{a, b, c, d} : std::array<Index, 4>{a, c, b, d});
        }
    even = !even;
  }
  return mesh;
}

}  // namespace taut::test
