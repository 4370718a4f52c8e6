#include <gtest/gtest.h>

#include <cmath>

#include "base/with_threads.hpp"
#include "levelset/samples.hpp"
#include "levelset/surface_checks.hpp"
#include "taut/surface_distance.hpp"

namespace taut {
namespace {

SurfaceMesh sphere(Index n, double radius) {
  const Mesh mesh = test::grid(n);
  const auto values = test::values_on(mesh, [](const Point& p) { return norm(p - Vec3{0.5, 0.5, 0.5}); });
  SurfaceMesh surface = isosurface(mesh, values, 0.4).surface;
  for (Point& p : surface.points) {
    const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
    p = (radius / norm(d)) * d;
  }
  return surface;
}

TEST(SurfaceDistance, OfASurfaceToItselfIsZero) {
  const SurfaceMesh surface = sphere(8, 1);
  const SurfaceDistance d = distance(surface, surface, {.spacing = 0.02});
  EXPECT_LT(d.worst, 1e-15);
  EXPECT_LT(d.mean, 1e-15);
}

TEST(SurfaceDistance, OfParallelSquares) {
  const SurfaceDistance d = distance(test::rectangle(0, 1, 0), test::rectangle(0, 1, 0.25));
  for (const Deviation& way : {d.from_first, d.from_second}) {
    EXPECT_DOUBLE_EQ(way.worst, 0.25);
    EXPECT_NEAR(way.mean, 0.25, 1e-14);
    EXPECT_NEAR(way.area, 1, 1e-10);
  }
  EXPECT_DOUBLE_EQ(d.worst, 0.25);
  EXPECT_NEAR(d.mean, 0.25, 1e-14);
}

// What only one surface has is far from the other, but not the other way round.
TEST(SurfaceDistance, OfASquareAndItsHalf) {
  const SurfaceDistance d = distance(test::rectangle(0, 1, 0), test::rectangle(0, 0.5, 0));
  EXPECT_DOUBLE_EQ(d.from_first.worst, 0.5);
  EXPECT_EQ(d.from_first.where[0], 1);
  EXPECT_NEAR(d.from_first.mean, 0.125, 1e-5);
  EXPECT_LT(d.from_second.worst, 1e-15);
  EXPECT_EQ(d.worst, d.from_first.worst);
  EXPECT_NEAR(d.mean, 0.125 / 1.5, 1e-5);
}

TEST(SurfaceDistance, OfConcentricSpheres) {
  const SurfaceDistance d = distance(sphere(12, 1), sphere(12, 1.5), {.spacing = 0.1});
  EXPECT_NEAR(d.from_first.mean, 0.5, 1e-2);
  EXPECT_NEAR(d.from_second.mean, 0.5, 1e-2);
  EXPECT_NEAR(d.worst, 0.5, 2e-2);
}

// The middle of a chord is farthest from the arc: samples at the vertices alone would find nothing.
TEST(SurfaceDistance, BetweenTheVerticesCounts) {
  const double sag = distance(sphere(6, 1), sphere(24, 1), {.spacing = 0.02}).from_first.worst;
  EXPECT_GT(sag, 5e-3);
  EXPECT_LT(sag, 5e-2);
}

TEST(SurfaceDistance, FinerSamplesChangeLittle) {
  const SurfaceMesh coarse = sphere(6, 1), fine = sphere(20, 1);
  const SurfaceDistance d = distance(coarse, fine, {.spacing = 0.02});
  const SurfaceDistance finer = distance(coarse, fine, {.spacing = 0.01});
  EXPECT_GT(finer.from_first.samples, 3 * d.from_first.samples);
  EXPECT_NEAR(d.mean, finer.mean, 0.01 * d.mean);
  EXPECT_NEAR(d.worst, finer.worst, 0.02 * d.worst);
}

TEST(SurfaceDistance, IsTheSameOnAnyNumberOfThreads) {
  const SurfaceMesh a = sphere(6, 1), b = sphere(8, 1.01);
  const auto compute = [&] { return distance(a, b, {.spacing = 0.02}); };
  const SurfaceDistance one = test::with_threads(1, compute);
  for (const int threads : {2, 3}) {
    const SurfaceDistance other = test::with_threads(threads, compute);
    EXPECT_EQ(one.worst, other.worst);
    EXPECT_EQ(one.mean, other.mean);
    EXPECT_EQ(one.from_first.where, other.from_first.where);
    EXPECT_EQ(one.from_second.mean, other.from_second.mean);
  }
}

TEST(SurfaceDistance, OfSinglePoints) {
  const SurfaceMesh a{{{0, 0, 0}}, {{0, 0, 0}}}, b{{{0, 3, 4}}, {{0, 0, 0}}};
  const SurfaceDistance d = distance(a, b);
  EXPECT_EQ(d.worst, 5);
  EXPECT_EQ(d.mean, 5);
}

TEST(SurfaceDistance, RefusesWhatItCannotUse) {
  const SurfaceMesh good = test::rectangle(0, 1, 0);
  const auto refusal = [](const SurfaceMesh& a, const SurfaceMesh& b, const DistanceOptions& options = {}) {
    return test::refusal(2, [&] { return distance(a, b, options); });
  };
  SurfaceMesh bad = good;
  bad.triangles[1][2] = 7;
  EXPECT_EQ(refusal(bad, good), "first surface: triangle 2: vertex 8 found, expected 1..4");
  bad = good;
  bad.points[2][1] = INFINITY;
  EXPECT_EQ(refusal(good, bad), "second surface: vertex 3: coordinate inf is not finite");
  EXPECT_EQ(refusal(good, {}), "second surface: no triangles found, expected at least one");
  EXPECT_EQ(refusal(good, good, {.spacing = -1}), "spacing: -1 found, expected a number, 0 or more");
  EXPECT_EQ(refusal(good, good, {.divisions = 0}), "divisions: 0 found, expected 1 or more");
}

TEST(Samples, SharesAddUpToTheArea) {
  const SurfaceMesh surface = sphere(5, 1);
  for (const int divisions : {1, 2, 3, 7}) {
    const Samples samples(surface, 1e9, divisions);
    double area = 0;
    std::size_t count = 0;
    for (std::size_t row = 0; row < samples.rows(); ++row)
      samples.for_each_in_row(row, [&](const Vec3&, double share) {
        area += share;
        ++count;
      });
    const auto n = static_cast<std::size_t>(divisions);
    EXPECT_EQ(count, surface.triangles.size() * (n + 1) * (n + 2) / 2);
    EXPECT_NEAR(area, measure(surface).area, 1e-12);
  }
}

TEST(Samples, AreNoFartherApartThanAsked) {
  const SurfaceMesh square = test::rectangle(0, 1, 0);
  const Samples samples(square, 0.1, 1);
  // The diagonal of 1.41 needs 15 parts, and each triangle has one row more.
  EXPECT_EQ(samples.rows(), 32U);
}

TEST(SurfaceMeasures, OfACube) {
  Mesh mesh = test::cube(2);
  const SurfaceMeasures closed = measure(SurfaceMesh{mesh.points, mesh.triangles});
  EXPECT_NEAR(closed.area, 6, 1e-14);
  EXPECT_NEAR(closed.volume, 1, 1e-14);
  EXPECT_EQ(closed.open_edges, 0U);
  mesh.triangles.pop_back();
  const SurfaceMeasures open = measure(SurfaceMesh{mesh.points, mesh.triangles});
  EXPECT_EQ(open.open_edges, 3U);
  EXPECT_EQ(open.volume, 0);
  // An edge that both triangles pass in the same direction is no closed surface either.
  const SurfaceMesh folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
  EXPECT_EQ(measure(folded).open_edges, 3U);
  EXPECT_EQ(measure(SurfaceMesh{}).area, 0);
}

}  // namespace
}  // namespace taut
