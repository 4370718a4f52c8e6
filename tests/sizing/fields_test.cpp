#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "metric/length.hpp"
#include "sizing/smooth_fields.hpp"
#include "taut/quality.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using test::irregular_cube;
using test::refusal;
using test::sampled;

/// A regular tetrahedron of edge length 1 under a linear map A: the implied metric is (A A^T)^-1, whatever A.
TEST(ImpliedMetric, MakesOneTetrahedronRegular) {
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    Mesh mesh;
    for (int k = 0; k < 4; ++k) mesh.points.push_back(random.point());
    mesh.tetrahedra = {{0, 1, 2, 3}};
    const Tensors m = implied_metric(mesh);
    for (std::size_t p = 0; p < 4; ++p)
      for (std::size_t q = 0; q < p; ++q) EXPECT_NEAR(edge_length(mesh.points[p], mesh.points[q], m[p], m[q]), 1, 1e-6);
  }
}

TEST(ImpliedMetric, MakesTheMeshAboutUnit) {
  Mesh mesh = irregular_cube(8, 2);
  for (Point& p : mesh.points) p = {p[0], 0.1 * p[1], 0.01 * p[2] + 0.02 * p[0]};
  const Quality q = measure(mesh, implied_metric(mesh));
  EXPECT_GT(q.tau, 0.7);
  EXPECT_LT(q.length_max, 3);
}

TEST(ImpliedMetric, OfAPointWithoutTetrahedronIsCoarse) {
  Mesh mesh = irregular_cube(2, 3);
  mesh.points.push_back({0.5, 0.5, 0.5});
  EXPECT_LT(test::distance(implied_metric(mesh).back(), metric_of_size(std::sqrt(3.0))), 1e-12);
}

TEST(ImpliedMetric, RefusesAFlatTetrahedron) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  EXPECT_NE(refusal(1, [&] { return implied_metric(mesh); }).find("tetrahedron 1 (1 2 3 4) is flat"),
            std::string::npos);
}

TEST(Complexity, IsTheVolumeOverThatOfAUnitCube) {
  const Mesh mesh = irregular_cube(4, 4);
  EXPECT_NEAR(complexity(mesh, Tensors(mesh.points.size(), Tensor{100, 0, 0, 25, 0, 4})), 100, 1e-10);
  const Tensors varied = tensors_of(mesh, [](const Point& p) { return metric_of_size(0.1 + p[0]); });
  EXPECT_NEAR(complexity(mesh, varied), measure(mesh, varied).complexity, 1e-10);
}

TEST(Intersection, IsThatAtEachVertex) {
  const Tensors a = {{4, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}}, b = {{1, 0, 0, 9, 0, 1}, {2, 0, 0, 2, 0, 2}};
  const Tensors both = intersection(a, b);
  EXPECT_LT(test::distance(both[0], {4, 0, 0, 9, 0, 1}), 1e-14);
  EXPECT_EQ(both[1], b[1]);
  EXPECT_EQ(refusal(1, [&] { return intersection(a, {a[0]}); }), "metrics of 2 and 1 vertices found, expected as many");
}

TEST(Limited, AppliesAllLimits) {
  const Mesh mesh = irregular_cube(6, 5);
  const auto thin = [](const Point& p) { return Tensor{p[0] < 0.5 ? 1e6 : 1, 0, 0, 1, 0, 1e-6}; };
  const Limits limits{.hmin = 0.01, .hmax = 0.5, .anisotropy = 10, .gradation = Gradation{}};
  const Tensors metric = limited(mesh, tensors_of(mesh, thin), limits);
  for (const Tensor& m : metric) {
    const Vec3 l = spectrum(m).values;
    EXPECT_GE(l[0], 4 * (1 - 1e-9));
    EXPECT_LE(l[2], 1e4 * (1 + 1e-9));
    EXPECT_LE(l[2], 100 * l[0] * (1 + 1e-9));
  }
  EXPECT_EQ(limited(mesh, metric, {.hmin = 0.01, .hmax = 0.5, .anisotropy = 10}), metric);
}

/// A sphere of radius 0.3: size `error` across, sqrt(error / |k|) along, both curvatures 1 / 0.3.
TEST(LevelSetMetric, FollowsTheCurvatureOfASphere) {
  const Mesh mesh = irregular_cube(16, 6);
  const Vec3 centre = {0.5, 0.5, 0.5};
  const auto values = sampled(mesh, [&](const Point& p) { return norm(p - centre) - 0.3; });
  const LevelSetOptions options{.error = 0.01, .growth = 1, .refinement = 100, .limits = {.hmax = 0.2}};
  const Tensors metric = level_set_metric(mesh, values, options);
  for (std::size_t v = 0; v < metric.size(); ++v) {
    const double r = norm(mesh.points[v] - centre);
    if (std::abs(r - 0.3) > 0.02) continue;  // of crossed tetrahedra
    const Spectrum s = spectrum(metric[v]);
    EXPECT_NEAR(1 / std::sqrt(s.values[2]), 0.01, 1e-6);
    EXPECT_NEAR(1 / std::sqrt(s.values[0]), std::sqrt(0.01 * r), 0.01);
    EXPECT_GT(std::abs(dot(s.vectors[2], 1 / r * (mesh.points[v] - centre))), 0.99);
  }
}

TEST(LevelSetMetric, ShrinksSizesBitByBit) {
  const Mesh mesh = irregular_cube(8, 7);
  const auto values = sampled(mesh, [](const Point& p) { return p[0] - 0.44; });
  const Tensors metric = level_set_metric(mesh, values, {.error = 1e-5, .refinement = 2});
  const Tensors implied = implied_metric(mesh);
  for (std::size_t v = 0; v < metric.size(); ++v) EXPECT_TRUE(is_dominated(metric[v], 4 * implied[v], 1.01)) << v;
}

TEST(LevelSetMetric, RefusesWhatMakesNoSense) {
  const Mesh mesh = irregular_cube(3, 8);
  const std::vector<double> values(64, 1);
  const auto message = [&](const LevelSetOptions& o) {
    return refusal(1, [&] { return level_set_metric(mesh, values, o); });
  };
  EXPECT_EQ(message({}), "error 0 found, expected a number above 0");
  EXPECT_EQ(message({.error = 1, .growth = -1}), "growth -1 found, expected 0 or more");
  EXPECT_EQ(message({.error = 1, .refinement = 1}), "refinement 1 found, expected a number above 1");
}

}  // namespace
}  // namespace taut
