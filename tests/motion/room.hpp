// A cubic room with a cubic body in its middle that can move.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/shapes.hpp"
#include "taut/taut.hpp"

namespace taut::test {

inline constexpr int wall = 1, body = 7;

inline double distance_from_middle(const Vec3& p) {
  return std::max({std::abs(p[0] - 0.5), std::abs(p[1] - 0.5), std::abs(p[2] - 0.5)});
}

/// The unit cube without its middle, where the body is: a third as large. `cells` per side is a multiple of 3.
inline Mesh room(Index cells = 9, double size = 0.12) {
  Mesh mesh = restricted(cube(cells), [](const Vec3& x) { return distance_from_middle(x) > 0.5 / 3; });
  mesh.triangles.clear();
  mesh.triangle_refs.clear();
  add_triangles(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.triangle_refs[t] = distance_from_middle(centre_of(mesh, mesh.triangles[t])) < 0.4 ? body : wall;
  return adapt(mesh, Sizes(mesh.points.size(), size), {.surface = Surface::fixed}).mesh;
}

inline MotionOptions fixed_surface(MeshChanges changes = MeshChanges::all) {
  return {.changes = changes, .adaptation = {.surface = Surface::fixed, .max_rounds = 0}};
}

inline MovingMesh moving(const Mesh& mesh, const MotionOptions& options, double size = 0.12) {
  return {mesh, Sizes(mesh.points.size(), size), options};
}

inline double volume(const Mesh& mesh, const Tensors& metric) {
  return measure(mesh, metric).volume;
}

inline RigidMotion turn(double degrees) {
  return RigidMotion::rotation({0.5, 0.5, 0.5}, {1, 2, 3}, degrees);
}

/// Of the triangles with this reference.
inline std::vector<Point> points_of(const Mesh& mesh, int reference) {
  std::vector<Point> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == reference)
      for (const Index v : mesh.triangles[t]) points.push_back(mesh.points[v]);
  std::ranges::sort(points);
  return points;
}

inline void expect_near(const std::vector<Point>& a, const std::vector<Point>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (const Point& p : a) {
    double nearest = 1;
    for (const Point& q : b) nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    ASSERT_LT(nearest, tolerance);
  }
}

}  // namespace taut::test
