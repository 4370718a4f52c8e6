#include "geometry/surface_edges.hpp"

#include <algorithm>
#include <tuple>

namespace taut {

std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangles[t].v[(k + 1) % 3], triangles[t].v[(k + 2) % 3]);
      uses.push_back({{a, b}, t, k});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) {
    return std::tie(x.edge, x.triangle) < std::tie(y.edge, y.triangle);
  });
  return uses;
}

}  // namespace taut
