// What every level set must fulfil, and surfaces to measure.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesh/shapes.hpp"
#include "taut/levelset.hpp"

namespace taut::test {

/// How often triangles pass each edge, in both directions together.
inline std::map<std::array<Index, 2>, int> edge_counts(const SurfaceMesh& surface) {
  std::map<std::array<Index, 2>, int> counts;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++counts[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
  return counts;
}

/// No triangle repeats a point or occurs twice, and every point is used.
inline void expect_sound(const SurfaceMesh& surface) {
  std::set<std::array<Index, 3>> triangles;
  std::set<Index> used;
  for (auto t : surface.triangles) {
    used.insert(t.begin(), t.end());
    std::sort(t.begin(), t.end());
    EXPECT_TRUE(t[0] < t[1] && t[1] < t[2]);
    EXPECT_TRUE(triangles.insert(t).second);
  }
  EXPECT_EQ(used.size(), surface.points.size());
}

/// Closed, with two triangles at every edge.
inline void expect_manifold(const SurfaceMesh& surface) {
  expect_sound(surface);
  for (const auto& [edge, count] : edge_counts(surface)) EXPECT_EQ(count, 2);
  EXPECT_EQ(measure(surface).open_edges, 0U);
}

inline long euler_characteristic(const SurfaceMesh& surface) {
  return static_cast<long>(surface.points.size()) - static_cast<long>(edge_counts(surface).size()) +
         static_cast<long>(surface.triangles.size());
}

template <class Function>
std::vector<double> values_on(const Mesh& mesh, const Function& function) {
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(function(p));
  return values;
}

/// A rectangle [x0, x1] x [0, 1] at height z, as two triangles with upward normals.
inline SurfaceMesh rectangle(double x0, double x1, double z) {
  return {{{x0, 0, z}, {x1, 0, z}, {x1, 1, z}, {x0, 1, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace taut::test
