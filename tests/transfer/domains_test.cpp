// Domains that differ, and domains in several parts.
#include <gtest/gtest.h>

#include "locate/closest_on_triangle.hpp"
#include "transfer/meshes.hpp"

namespace taut {
namespace {

OnTriangle nearest_on_boundary(const Mesh& mesh, const Point& x) {
  OnTriangle best{{}, {}, std::numeric_limits<double>::infinity()};
  for (const auto& t : mesh.triangles) {
    const OnTriangle at = closest_on_triangle(x, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    if (at.squared_distance < best.squared_distance) best = at;
  }
  return best;
}

bool contains(const Mesh& mesh, const Point& x) {
  for (const auto& t : mesh.tetrahedra) {
    bool inside = true;
    for (const auto& [i, j, k] : face_vertices)
      inside &= six_volumes(mesh.points[t[i]], mesh.points[t[k]], mesh.points[t[j]], x) >= -1e-15;
    if (inside) return true;
  }
  return false;
}

TEST(PointsOutside, TakeTheValueAtTheNearestPointOfTheBoundary) {
  const Mesh from = test::ball(test::cube(4)), to = test::ball(test::cube(7));
  const auto result =
      transfer(from, {test::sampled_field(from, test::linear_function)}, to, {.method = Transfer::linear});
  std::size_t outside_ones = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < to.points.size(); ++i) {
    const Point& x = to.points[i];
    const OnTriangle nearest = nearest_on_boundary(from, x);
    const bool is_inside = contains(from, x);
    EXPECT_NEAR(result.fields[0].values[i], test::linear_function(is_inside ? x : nearest.point), 1e-13);
    if (is_inside) continue;
    ++outside_ones;
    farthest = std::max(farthest, std::sqrt(nearest.squared_distance));
  }
  EXPECT_GT(outside_ones, 50);
  EXPECT_EQ(result.report.outside, outside_ones);
  EXPECT_DOUBLE_EQ(result.report.distance_max, farthest);
}

TEST(CurvedWalls, LeaveValuesRight) {
  double before = 1;
  for (const Index n : {4, 8}) {
    const Mesh from = test::ball(test::cube(n)), to = test::ball(test::cube(n + n / 2));
    const auto constant = [](const Point&) { return 0.3; };
    const auto fields = {test::sampled_field(from, test::smooth_function), test::sampled_field(from, constant)};
    const auto [transferred, report] = transfer(from, fields, to);
    EXPECT_LT(test::largest_error(to, transferred[1], constant), 1e-15);
    const double error = test::error_norm(to, transferred[0], test::smooth_function);
    EXPECT_LT(error, 0.35 * before);
    before = error;
    const ComponentReport& u = report.fields[0][0];
    EXPECT_NEAR(u.mass_after / report.volume_after, u.mass_before / report.volume_before, 0.01 * u.mass_before);
    EXPECT_GE(u.least_after, u.least_before);
    EXPECT_LE(u.greatest_after, u.greatest_before);
    EXPECT_LT(report.covered_volume.value(), std::min(report.volume_before, report.volume_after));
    EXPECT_GT(report.covered_volume.value(), 0.9 * report.volume_before);
    EXPECT_GT(report.outside, 0);
  }
}

// A wrong search of the neighbours would take values across the gap.
TEST(SeparateParts, DoNotMix) {
  const Mesh from = test::shaken(test::two_slabs(8), 0.02, 1), to = test::shaken(test::two_slabs(16), 0.01, 2);
  const auto side = [](const Point& p) { return p[0] < 0.4375 ? 1.0 : 2.0; };
  for (const Transfer method : {Transfer::linear, Transfer::conservative}) {
    const auto result = transfer(from, {test::sampled_field(from, side)}, to, {.method = method});
    EXPECT_EQ(test::largest_error(to, result.fields[0], side), 0);
  }
}

// Large tetrahedra across the gap meet both slabs: neighbours do not lead from one to the other.
TEST(SeparateParts, AreBothFoundFromOneTetrahedronAcross) {
  const Mesh from = test::shaken(test::two_slabs(16), 0.01, 1), to = test::shaken_cube(2, 2);
  const auto fields = {test::sampled_field(from, test::linear_function)};
  const auto [transferred, report] = transfer(from, fields, to);
  EXPECT_NEAR(report.covered_volume.value(), 0.875, 1e-12);
  EXPECT_LT(test::largest_error(to, transferred[0], test::linear_function), 1e-12);
}

// The part that is not covered at all takes the value at the nearest point.
TEST(SeparateParts, MayBeMissingAltogether) {
  const Mesh from = test::restricted(test::grid(8), [](const Vec3& c) { return c[0] < 0.375; });
  const Mesh to = test::two_slabs(8);
  const auto across = [](const Point& p) { return p[0]; };
  for (const Transfer method : {Transfer::linear, Transfer::conservative}) {
    const auto [fields, report] = transfer(from, {test::sampled_field(from, across)}, to, {.method = method});
    EXPECT_NEAR(report.distance_max, 0.625, 1e-15);
    for (std::size_t i = 0; i < to.points.size(); ++i)
      EXPECT_NEAR(fields[0].values[i], std::min(to.points[i][0], 0.375), 1e-13);
  }
}

TEST(UnusedPoints, AreInterpolated) {
  const Mesh from = test::shaken_cube(3, 1);
  Mesh to = test::shaken_cube(4, 2);
  to.points.push_back({0.3, 0.4, 0.45});
  to.points.push_back({0.3, 0.4, 2});
  const auto [fields, report] = transfer(from, {test::sampled_field(from, test::linear_function)}, to);
  EXPECT_NEAR(fields[0].values[to.points.size() - 2], test::linear_function({0.3, 0.4, 0.45}), 1e-14);
  EXPECT_NEAR(fields[0].values[to.points.size() - 1], test::linear_function({0.3, 0.4, 1}), 1e-14);
  EXPECT_EQ(report.outside, 1);
}

}  // namespace
}  // namespace taut
