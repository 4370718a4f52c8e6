#include <gtest/gtest.h>

#include <algorithm>

#include "base/with_threads.hpp"
#include "sizing/curved_meshes.hpp"
#include "surface/closest_on_cubic.hpp"
#include "surface/reference_surface.hpp"
#include "surface/surfaces.hpp"

namespace taut {
namespace {

using test::Random;

ReferenceSurface surface_around(Mesh mesh) {
  mesh.tetrahedra.clear();
  return {surface_of(mesh), {}};
}

/// At distances from 1e-4 to 1 times `size` from the surface, most of them near.
std::vector<Vec3> places_around(const ReferenceSurface& surface, std::size_t count, double size, unsigned seed) {
  Random random(seed);
  std::vector<Vec3> places;
  const auto triangles = static_cast<double>(surface.facets().triangles.size());
  while (places.size() < count) {
    const auto t = static_cast<TriangleId>(random.uniform(0, triangles));
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const double h = size * std::pow(10, -random.uniform(0, 4));
    places.push_back(evaluate(surface.cubic_of(t), {1 - u - v, u, v}).x +
                     Vec3{random.uniform(-h, h), random.uniform(-h, h), random.uniform(-h, h)});
  }
  return places;
}

/// By trying all triangles of the patch, from several places on each.
double least_distance(const ReferenceSurface& surface, const Vec3& x, PatchId patch = none) {
  double least = 1e300;
  for (const TriangleId t : ids<TriangleId>(surface.facets().triangles.size())) {
    if (patch != none && surface.patch_of(t) != patch) continue;
    const CubicTriangle& cubic = surface.cubic_of(t);
    const OnTriangle flat = closest_on_triangle(x, cubic.corner);
    if (std::sqrt(flat.squared_distance) - deviation_bound(cubic) > least) continue;
    for (const std::array<double, 3>& w : {flat.weights,
                                           {1.0 / 3, 1.0 / 3, 1.0 / 3},
                                           {1, 0, 0},
                                           {0, 1, 0},
                                           {0, 0, 1},
                                           {0.5, 0.5, 0},
                                           {0, 0.5, 0.5},
                                           {0.5, 0, 0.5}})
      least = std::min(least, std::sqrt(closest_on(cubic, x, w).squared_distance));
  }
  return least;
}

struct Cost {
  double visited = 0;
  std::vector<int> iterations;
};

Cost expect_closest(const ReferenceSurface& surface, const std::vector<Vec3>& places) {
  Cost cost;
  for (const Vec3& x : places) {
    const OnPatch at = surface.closest(x);
    EXPECT_NEAR(at.distance, least_distance(surface, x), 1e-12);
    EXPECT_NEAR(norm(at.point - x), at.distance, 1e-14);
    cost.visited += at.visited / static_cast<double>(places.size());
    cost.iterations.push_back(at.iterations);
  }
  std::sort(cost.iterations.begin(), cost.iterations.end());
  return cost;
}

TEST(Closest, IsNeverWrong) {
  for (const Mesh& mesh : {test::sphere(8, 1), test::tube(36, 14), test::cylinder(8, 1, 2), test::lens(10, 30)}) {
    const ReferenceSurface surface = surface_around(mesh);
    const Cost cost = expect_closest(surface, places_around(surface, 1500, 0.3, 1));
    EXPECT_LT(cost.visited, 3);
    EXPECT_LE(cost.iterations[cost.iterations.size() * 99 / 100], 4);
  }
}

TEST(Closest, IsFoundFromFarAway) {
  const ReferenceSurface surface = surface_around(test::tube(36, 14));
  expect_closest(surface, places_around(surface, 500, 5, 2));
}

TEST(Closest, DoesNotDependOnTheGuess) {
  const ReferenceSurface surface = surface_around(test::tube(36, 14));
  Random random(3);
  const auto triangles = static_cast<double>(surface.facets().triangles.size());
  for (const Vec3& x : places_around(surface, 1000, 0.2, 3)) {
    const OnPatch plain = surface.closest_on(PatchId{0}, x);
    for (const TriangleId guess : {plain.triangle, static_cast<TriangleId>(random.uniform(0, triangles))}) {
      const OnPatch at = surface.closest_on(PatchId{0}, x, guess);
      EXPECT_EQ(at.point, plain.point);
      EXPECT_EQ(at.normal, plain.normal);
      EXPECT_EQ(at.triangle, plain.triangle);
    }
  }
}

/// Of each side of a cylinder, which continue behind their rims as far as their points are concerned.
TEST(Closest, StaysOnThePatch) {
  const ReferenceSurface surface = surface_around(test::cylinder(8, 1, 2));
  for (const Vec3& x : places_around(surface, 500, 0.3, 4))
    for (const PatchId p : ids<PatchId>(surface.patches().size())) {
      const OnPatch at = surface.closest_on(p, x);
      EXPECT_EQ(surface.patch_of(at.triangle), p);
      EXPECT_NEAR(at.distance, least_distance(surface, x, p), 1e-12);
      const Vec3 flat = area_normal(surface.facets(), at.triangle);
      EXPECT_NEAR(std::abs(at.normal[2]), std::abs(flat[2]) > 0.5 * norm(flat) ? 1 : 0, 2e-2);
    }
}

TEST(Closest, OnACurve) {
  const ReferenceSurface surface = surface_around(test::cylinder(8, 1, 2));
  Random random(5);
  for (const LineId l : ids<LineId>(surface.curves().size())) {
    const double z = surface.facets().points[surface.curves()[l].vertices[0]][2];
    for (int i = 0; i < 500; ++i) {
      const Vec3 x = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 3)};
      const double r = std::hypot(x[0], x[1]);
      const OnCurve at = surface.closest_on(l, x);
      EXPECT_NEAR(at.distance, std::hypot(r - 1, x[2] - z), 1e-5);
      EXPECT_NEAR(std::abs(at.tangent[0] * x[1] - at.tangent[1] * x[0]), r, 1e-3 * r);
      const OnCurve again =
          surface.closest_on(l, x, static_cast<Index>((at.segment + 7) % surface.curves()[l].segments.size()));
      EXPECT_EQ(again.point, at.point);
      EXPECT_EQ(again.segment, at.segment);
    }
  }
}

TEST(Closest, CanBeAskedByAllThreads) {
  const ReferenceSurface surface = surface_around(test::sphere(12, 1));
  const std::vector<Vec3> places = places_around(surface, 4000, 0.3, 6);
  const auto found_on = [&](int threads) {
    return test::with_threads(threads, [&] {
      std::vector<Vec3> points(places.size());
      for_each_index(Chunks(places.size(), 64), [&](std::size_t i) { points[i] = surface.closest(places[i]).point; });
      return points;
    });
  };
  EXPECT_EQ(found_on(1), found_on(3));
}

}  // namespace
}  // namespace taut
