#include "taut/placing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/with_threads.hpp"
#include "mesh/shapes.hpp"
#include "metric/spectral.hpp"
#include "taut/levelset.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

using test::refusal;

constexpr double radius = 0.3;

double sphere(const Point& p) {
  return norm(p - Vec3{0.5, 0.5, 0.5}) - radius;
}

/// A unit mesh of the unit cube.
Mesh unit_mesh(double size) {
  return adapt(test::cube(4), Metric{Sizes(125, size)}).mesh;
}

Metric uniform(double size) {
  return [size](const Point&) { return metric_of_size(size); };
}

/// The largest distance of the centres of triangles and edges of the reconstruction to the sphere.
double deviation_from_sphere(const Placed& placed) {
  const SurfaceMesh surface = isosurface(placed.adapted.mesh, placed.values).surface;
  double worst = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 &x = surface.points[a], &y = surface.points[b], &z = surface.points[c];
    for (const Vec3& p : {1.0 / 3 * (x + y + z), 0.5 * (x + y), 0.5 * (y + z), 0.5 * (z + x)})
      worst = std::max(worst, std::abs(sphere(p)));
  }
  return worst;
}

void expect_sound(const Placed& placed) {
  EXPECT_EQ(defects(placed.adapted.mesh), std::vector<std::string>{});
  EXPECT_NEAR(test::volume_of(placed.adapted.mesh), 1, 1e-12);
  EXPECT_EQ(placed.values.size(), placed.adapted.mesh.points.size());
}

TEST(Placing, PutsVerticesOnASphere) {
  const Mesh mesh = unit_mesh(0.1);
  const Placed placed = place_on_level_set(mesh, uniform(0.1), sphere);
  expect_sound(placed);
  EXPECT_GT(placed.moved, 100U);
  EXPECT_LE(placed.crossed, 3U);
  EXPECT_LE(placed.adapted.report.quality.Q_max, 20);
  std::size_t on_sphere = 0;
  for (std::size_t v = 0; v < placed.values.size(); ++v) {
    const double exact = sphere(placed.adapted.mesh.points[v]);
    if (placed.values[v] == 0) {
      ++on_sphere;
      EXPECT_LT(std::abs(exact), 1e-10);
    } else {
      EXPECT_EQ(placed.values[v], exact);
    }
  }
  EXPECT_GE(on_sphere, placed.moved);
}

TEST(Placing, InsertsVerticesUntilTheSurfaceIsNear) {
  const Mesh mesh = unit_mesh(0.15);
  const Placed coarse = place_on_level_set(mesh, uniform(0.15), sphere);
  const Placed fine = place_on_level_set(mesh, uniform(0.15), sphere, {.deviation = 2e-3});
  expect_sound(fine);
  EXPECT_GT(deviation_from_sphere(coarse), 5e-3);
  EXPECT_LT(deviation_from_sphere(fine), 2.2e-3);
}

/// u = |x|^2 - r^2 is quadratic, so that nothing is lost when it is recovered from its values.
TEST(Placing, RecoversTheFunctionFromItsValues) {
  const Mesh mesh = unit_mesh(0.1);
  std::vector<double> values;
  for (const Point& p : mesh.points) {
    const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
    values.push_back(dot(d, d) - radius * radius);
  }
  const Placed placed = place_on_level_set(mesh, uniform(0.1), values);
  expect_sound(placed);
  EXPECT_LE(placed.crossed, 3U);
  for (std::size_t v = 0; v < placed.values.size(); ++v) {
    if (placed.values[v] == 0) {
      EXPECT_LT(std::abs(sphere(placed.adapted.mesh.points[v])), 1e-9);
    }
  }
}

/// The vertices on the sides move along these, and edges of the cube are crossed in a vertex.
TEST(Placing, ReachesTheBoundary) {
  const Mesh mesh = unit_mesh(0.1);
  const auto oblique = [](const Point& p) { return p[0] + 0.3 * p[1] - 0.2 * p[2] - 0.5431; };
  const Placed placed = place_on_level_set(mesh, uniform(0.1), oblique);
  expect_sound(placed);
  EXPECT_LE(placed.crossed, 10U);
  const auto is_on_side = [](const Point& p) { return p[1] == 0 || p[1] == 1; };
  std::size_t on_sides = 0;
  for (std::size_t v = 0; v < placed.values.size(); ++v)
    on_sides += placed.values[v] == 0 && is_on_side(placed.adapted.mesh.points[v]) ? 1 : 0;
  EXPECT_GT(on_sides, 15U);
}

TEST(Placing, KeepsAFixedSurface) {
  const Mesh mesh = unit_mesh(0.15);
  const auto plane = [](const Point& p) { return p[0] - 0.5431; };
  const Placed placed = place_on_level_set(mesh, uniform(0.15), plane, {.surface = Surface::fixed});
  expect_sound(placed);
  EXPECT_EQ(placed.adapted.mesh.triangles.size(), mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (const Index p : triangle) EXPECT_EQ(placed.adapted.mesh.points[placed.adapted.new_of_old[p]], mesh.points[p]);
}

TEST(Placing, LeavesAMeshWithoutSurfaceAsItIs) {
  const Mesh mesh = unit_mesh(0.2);
  const Placed placed =
      place_on_level_set(mesh, uniform(0.2), [](const Point& p) { return 1 + p[0]; }, {.deviation = 1e-3});
  EXPECT_EQ(placed.moved + placed.inserted + placed.crossed, 0U);
  EXPECT_EQ(placed.adapted.mesh.points.size(), mesh.points.size());
}

TEST(Placing, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = unit_mesh(0.1);
  const auto on = [&](int threads) {
    return test::with_threads(threads, [&] {
      return place_on_level_set(mesh, uniform(0.1), sphere, {.deviation = 1e-3}).adapted.report.hash;
    });
  };
  EXPECT_EQ(on(1), on(3));
}

TEST(Placing, RefusesWhatMakesNoSense) {
  const Mesh mesh = test::cube(4);
  const std::vector<double> values(125, 1);
  const auto message = [&](const PlaceOptions& o) {
    return refusal(1, [&] { return place_on_level_set(mesh, uniform(0.2), values, o); });
  };
  EXPECT_EQ(message({.Q_max = 1}), "Q_max 1 found, expected a number above 1");
  EXPECT_EQ(message({.deviation = -1}), "deviation -1 found, expected 0 or more");
  EXPECT_EQ(refusal(1, [&] { return place_on_level_set(mesh, uniform(0.2), std::vector<double>(3)); }),
            "field: 3 values for 125 vertices, expected one per vertex");
}

}  // namespace
}  // namespace taut
