// Sizes by reference: where they hold, what goes before what, and what is refused.
#include "taut/local_sizes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/with_threads.hpp"
#include "metric/random_metrics.hpp"
#include "sizing/curved_meshes.hpp"
#include "sizing/smooth_fields.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using test::irregular_cube;
using test::refusal;

/// Ascending.
Vec3 sizes_of(const Tensor& m) {
  const Vec3 l = spectrum(m).values;
  return {1 / std::sqrt(l[2]), 1 / std::sqrt(l[1]), 1 / std::sqrt(l[0])};
}

/// With sides of reference 1 (x = 0), 2 (x = 1), and so on, stretched tensors of sizes 0.1 to 1 at the points.
class OnACube : public testing::Test {
protected:
  OnACube() {
    test::Random random(5);
    for (std::size_t p = 0; p < mesh.points.size(); ++p) metric.push_back(random.metric(0.1));
  }

  [[nodiscard]] Tensors with(const LocalSizes& sizes) const { return with_local_sizes(mesh, metric, sizes); }

  /// Where is(point) holds the metric is that of change(); elsewhere it has the same bits as before.
  template <class Is, class Expect>
  void expect_only(const Tensors& found, Is is, Expect expect) const {
    ASSERT_EQ(found.size(), metric.size());
    std::size_t count = 0;
    for (std::size_t p = 0; p < metric.size(); ++p) {
      if (is(p)) {
        expect(found[p], metric[p]);
        ++count;
      } else {
        EXPECT_EQ(found[p], metric[p]);
      }
    }
    EXPECT_GT(count, 0U);
    EXPECT_LT(count, metric.size());
  }

  Mesh mesh = irregular_cube(5, 1);
  Tensors metric;
};

constexpr auto expect_at_most = [](const Tensor& found, const Tensor& before, double size) {
  const Vec3 is = sizes_of(found), was = sizes_of(before);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], std::min(was[i], size), 1e-9);
};

TEST_F(OnACube, ASizeOfTrianglesHoldsAtTheirPoints) {
  expect_only(
      with({.triangles = {{2, {.size = 0.2}}}}), [&](std::size_t p) { return mesh.points[p][0] == 1; },
      [](const Tensor& m, const Tensor& before) { expect_at_most(m, before, 0.2); });
}

TEST_F(OnACube, ASizeOfPointsAndEdgesHoldsThere) {
  mesh.point_refs.assign(mesh.points.size(), 0);
  mesh.point_refs[17] = 4;
  mesh.edges = {{3, 4}, {4, 5}, {9, 10}};
  mesh.edge_refs = {6, 6, 7};
  const auto check = [](const Tensor& m, const Tensor& before) { expect_at_most(m, before, 0.15); };
  expect_only(
      with({.points = {{4, {.size = 0.15}}}}), [](std::size_t p) { return p == 17; }, check);
  expect_only(
      with({.edges = {{6, {.size = 0.15}}}}), [](std::size_t p) { return p >= 3 && p <= 5; }, check);
}

TEST_F(OnACube, BoundsOfRegionsHoldInThem) {
  for (const auto& t : mesh.tetrahedra) mesh.tetrahedron_refs.push_back(test::centre_of(mesh, t)[0] < 0.5 ? 1 : 2);
  std::vector<std::uint8_t> in_second(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (mesh.tetrahedron_refs[t] == 2)
      for (const Index p : mesh.tetrahedra[t]) in_second[p] = 1;
  expect_only(
      with({.tetrahedra = {{2, {.min = 0.3, .max = 0.4}}}}), [&](std::size_t p) { return in_second[p] == 1; },
      [](const Tensor& m, const Tensor& before) {
        const Vec3 is = sizes_of(m), was = sizes_of(before);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], std::clamp(was[i], 0.3, 0.4), 1e-9);
      });
}

// At the edge between two sides the smaller size counts; `size` gives way to a `min`, and that to a `max`.
TEST_F(OnACube, WhereEntitiesMeetAllAreHeard) {
  const auto all_are = [&](const LocalSizes& sizes, double expected) {
    const Tensors found = with(sizes);
    for (std::size_t p = 0; p < found.size(); ++p) {
      if (mesh.points[p][0] != 1 || mesh.points[p][1] != 0) continue;
      for (const double h : sizes_of(found[p])) EXPECT_NEAR(h, expected, 1e-9);
    }
  };
  all_are({.triangles = {{2, {.size = 0.05}}, {3, {.size = 0.01}}}}, 0.01);
  all_are({.triangles = {{2, {.size = 0.05}}, {3, {.min = 2}}}}, 2);
  all_are({.triangles = {{2, {.max = 0.05}}, {3, {.min = 2}}}}, 0.05);
  all_are({.triangles = {{2, {.min = 2}}, {3, {.min = 3}}}}, 3);
}

TEST_F(OnACube, WhatIsWantedAlreadyKeepsItsBits) {
  EXPECT_EQ(with({}), metric);
  EXPECT_EQ(with({.triangles = {{2, {.size = 1.1, .min = 0.01, .max = 2, .deviation = 1}}}}), metric);
}

TEST_F(OnACube, MissingTrianglesHaveTheReferenceZero) {
  std::erase_if(mesh.triangles,
                [&](const auto& t) { return std::ranges::all_of(t, [&](Index p) { return mesh.points[p][0] == 1; }); });
  mesh.triangle_refs.assign(mesh.triangles.size(), 1);
  expect_only(
      with({.triangles = {{0, {.size = 0.2}}}}), [&](std::size_t p) { return mesh.points[p][0] == 1; },
      [](const Tensor& m, const Tensor& before) { expect_at_most(m, before, 0.2); });
}

TEST_F(OnACube, GradationMakesSizesGrowFromThere) {
  const Tensors coarse(mesh.points.size(), metric_of_size(1));
  const Tensors found =
      limited(mesh, with_local_sizes(mesh, coarse, {.triangles = {{1, {.size = 0.05}}}}), {.gradation = Gradation{}});
  for (std::size_t p = 0; p < found.size(); ++p) {
    if (mesh.points[p][0] >= 0.3) continue;
    EXPECT_LT(sizes_of(found[p])[2], 0.4);
  }
}

TEST_F(OnACube, RefusesWhatMakesNoSense) {
  const auto message = [&](const LocalSizes& sizes) { return refusal(2, [&] { return with(sizes); }); };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({.triangles = {{3, {.size = 0}}}}),
            "local sizes: triangles.3.size: 0 found, expected a number above 0");
  EXPECT_EQ(message({.points = {{0, {.size = nan}}}}),
            "local sizes: points.0.size: nan found, expected a number above 0");
  EXPECT_EQ(message({.edges = {{-3, {.min = -1}}}}),
            "local sizes: edges.-3.min: -1 found, expected a number, 0 or more");
  EXPECT_EQ(message({.tetrahedra = {{0, {.max = 1e-200}}}}),
            "local sizes: tetrahedra.0.max: 1e-200 found, expected a number above 0");
  EXPECT_EQ(message({.tetrahedra = {{0, {.min = 2, .max = 1}}}}),
            "local sizes: tetrahedra.0.min: 2 found, expected at most 1, the max");
  EXPECT_EQ(message({.tetrahedra = {{0, {.size = 1, .min = 2}}}}),
            "local sizes: tetrahedra.0.min: 2 found, expected at most 1, the size");
  EXPECT_EQ(message({.tetrahedra = {{0, {.deviation = 1}}}}),
            "local sizes: tetrahedra.0.deviation: 1 found, expected it for triangles only");
  EXPECT_EQ(message({.triangles = {{9, {.size = 1}}}}),
            "local sizes: triangles.9: none of the mesh's 300 triangles has this reference");
  EXPECT_EQ(message({.edges = {{0, {.size = 1}}}}),
            "local sizes: edges.0: none of the mesh's 0 edges has this reference");
  EXPECT_EQ(refusal(1, [&] { return with_local_sizes(mesh, Tensors(2), {}); }),
            "metric: 2 values for 216 vertices, expected one per vertex");
}

// A cylinder of radius 1 whose side has the references 1 to 4, in quarters: only one of these is resolved.
TEST(LocalDeviation, HoldsForItsTrianglesOnly) {
  Mesh mesh = test::cylinder(12, 3, 2);
  for (const auto& t : mesh.triangles) {
    const Vec3 c = test::centre_of(mesh, t);
    const bool cap = std::abs(test::area_normal(mesh, t)[2]) > 0.9 * norm(test::area_normal(mesh, t));
    mesh.triangle_refs.push_back(cap ? 9 : 1 + (c[0] > 0 ? 1 : 0) + (c[1] > 0 ? 2 : 0));
  }
  const Tensors coarse(mesh.points.size(), metric_of_size(3));
  const double deviation = 2e-3;
  const Tensors found = with_local_sizes(mesh, coarse, {.triangles = {{4, {.deviation = deviation}}}});
  std::size_t inside = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const auto& [x, y, z] = mesh.points[p];
    const bool on_side = std::hypot(x, y) > 0.999;
    if (on_side && x > 0.15 && y > 0.15 && z > 0.3 && z < 1.7) {
      // The chord of a unit circle that is half as far from it, along the circle and across the surface.
      EXPECT_NEAR(sizes_of(found[p])[0], std::sqrt(8 * deviation / 2), 0.01);
      EXPECT_GT(sizes_of(found[p])[2], 0.2);
      ++inside;
    } else if (!on_side || x < -0.15 || y < -0.15) {
      EXPECT_EQ(found[p], coarse[p]) << x << ' ' << y << ' ' << z;
    }
  }
  EXPECT_GT(inside, 20U);
}

}  // namespace
}  // namespace taut
