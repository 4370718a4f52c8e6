#include <gtest/gtest.h>

#include <limits>

#include "base/with_threads.hpp"
#include "sizing/smooth_fields.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using test::irregular_cube;
using test::refusal;
using test::sampled;

constexpr double infinity = std::numeric_limits<double>::infinity();

Tensors hessians_of_front(const Mesh& mesh) {
  return recover_hessian(mesh, sampled(mesh, [](const Point& p) { return std::tanh(20 * (p[0] - 0.5 + 0.2 * p[1])); }));
}

ScaledMetric metric_for(const Mesh& mesh, const Tensors& hessian, const LpOptions& options) {
  return lp_metric(mesh, std::array{hessian}, options);
}

TEST(LpMetric, HasTheComplexityWithAllLimits) {
  const Mesh mesh = irregular_cube(12, 1);
  const Tensors hessian = hessians_of_front(mesh);
  for (const double norm : {1.0, 2.0, 4.0, infinity})
    for (const Limits& limits :
         {Limits{}, Limits{.hmin = 0.02, .hmax = 0.3}, Limits{.anisotropy = 5}, Limits{.gradation = Gradation{}},
          Limits{.hmin = 0.01, .hmax = 0.5, .anisotropy = 20, .gradation = Gradation{.beta = 1.3}}}) {
      const auto scaled = metric_for(mesh, hessian, {.complexity = 2000, .norm = norm, .limits = limits});
      EXPECT_NEAR(scaled.complexity, 2000, 10);
      EXPECT_NEAR(complexity(mesh, scaled.metric), scaled.complexity, 1e-9 * scaled.complexity);
      EXPECT_EQ(scaled.stopped_by, "");
      EXPECT_LE(scaled.evaluations, 6);
    }
}

/// Flat in two directions: an unlimited metric would ask for infinitely long edges.
TEST(LpMetric, OfAParabolaHasTheComplexity) {
  const Mesh mesh = irregular_cube(10, 2);
  const auto hessian = recover_hessian(mesh, sampled(mesh, [](const Point& p) { return 100 * p[0] * p[0]; }));
  for (const double norm : {1.0, 2.0, infinity}) {
    const auto scaled = metric_for(mesh, hessian, {.complexity = 1000, .norm = norm});
    EXPECT_NEAR(complexity(mesh, scaled.metric), 1000, 5);
    const auto limited = metric_for(mesh, hessian, {.complexity = 1000, .norm = norm, .limits = {.anisotropy = 10}});
    EXPECT_NEAR(complexity(mesh, limited.metric), 1000, 5);
  }
}

/// What det|H| is there is rounding, which must not decide on the size across the front.
TEST(LpMetric, OfAPlanarFrontDependsOnTheDistanceAlone) {
  const Mesh mesh = irregular_cube(16, 11);
  const auto slope = [](const Point& p) { return std::tanh(8 * (p[0] - 0.4)); };
  const auto hessian = recover_hessian(mesh, sampled(mesh, slope));
  Tensors noisy(mesh.points.size());  // in the directions along the front
  for (std::size_t v = 0; v < noisy.size(); ++v) {
    const double t = slope(mesh.points[v]);
    noisy[v] = {-128 * t * (1 - t * t), 0, 0, v % 2 == 0 ? 1e-3 : 1e-11, 0, 1e-9};
  }
  for (const Tensors& h : {hessian, noisy}) {
    const Tensors metric = metric_for(mesh, h, {.complexity = 600}).metric;
    double near = 0, far = 0;
    for (std::size_t v = 0; v < metric.size(); ++v) {
      const double d = std::abs(mesh.points[v][0] - 0.4);
      (d < 0.15 ? near : far) = std::max(d < 0.15 ? near : far, d < 0.15 || d > 0.3 ? metric[v][0] : 0);
    }
    EXPECT_GT(near, 4 * far);
  }
}

TEST(LpMetric, OfALinearFieldIsUniform) {
  const Mesh mesh = irregular_cube(5, 3);
  const auto scaled = metric_for(mesh, Tensors(mesh.points.size()), {.complexity = 1000});
  for (const Tensor& m : scaled.metric) EXPECT_LT(test::distance(m, metric_of_size(0.1)), 2e-3);
}

/// Without limits the metric of a constant Hessian is proportional to it.
TEST(LpMetric, FollowsTheHessian) {
  const Mesh mesh = irregular_cube(5, 4);
  const Tensor h = {50, 3, -2, -8, 1, 2};
  const Sym3 expected = map_eigenvalues(h, [](double l) { return std::abs(l); });
  const auto scaled = metric_for(mesh, Tensors(mesh.points.size(), h), {.complexity = 3000});
  const double factor = std::pow(3000 / std::sqrt(determinant_spd(expected)), 2.0 / 3);
  for (const Tensor& m : scaled.metric) EXPECT_LT(test::distance(m, factor * expected), 2e-3);
}

TEST(LpMetric, DoesNotSeeTheUnitOfTheField) {
  const Mesh mesh = irregular_cube(8, 5);
  const Tensors hessian = hessians_of_front(mesh);
  Tensors scaled_hessian = hessian;
  for (Tensor& h : scaled_hessian) h = 1e-9 * h;
  const auto one = metric_for(mesh, hessian, {.complexity = 1000}).metric;
  const auto two = metric_for(mesh, scaled_hessian, {.complexity = 1000}).metric;
  for (std::size_t v = 0; v < one.size(); ++v) EXPECT_LT(test::distance(one[v], two[v]), 1e-3);
}

TEST(LpMetric, OfSeveralFieldsServesAll) {
  const Mesh mesh = irregular_cube(10, 6);
  const auto x_front =
      recover_hessian(mesh, sampled(mesh, [](const Point& p) { return std::tanh(20 * (p[0] - 0.5)); }));
  const auto y_front =
      recover_hessian(mesh, sampled(mesh, [](const Point& p) { return 1e6 * std::tanh(20 * (p[1] - 0.5)); }));
  const auto both = lp_metric(mesh, std::array{x_front, y_front}, {.complexity = 2000});
  EXPECT_NEAR(both.complexity, 2000, 10);
  std::array<double, 2> finest{};
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    finest[0] = std::max(finest[0], both.metric[v][0]);
    finest[1] = std::max(finest[1], both.metric[v][3]);
  }
  EXPECT_NEAR(finest[0] / finest[1], 1, 0.2);
}

TEST(LpMetric, SaysWhatStopsIt) {
  const Mesh mesh = irregular_cube(6, 7);
  const Tensors hessian = hessians_of_front(mesh);
  const auto fine = metric_for(mesh, hessian, {.complexity = 1e6, .limits = {.hmin = 0.1}});
  EXPECT_EQ(fine.stopped_by, "hmin");
  EXPECT_NEAR(fine.complexity, 1000, 5);
  const auto coarse = metric_for(mesh, hessian, {.complexity = 10, .limits = {.hmax = 0.1}});
  EXPECT_EQ(coarse.stopped_by, "hmax");
  EXPECT_NEAR(coarse.complexity, 1000, 5);
}

TEST(LpMetric, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = irregular_cube(20, 8);
  const Tensors hessian = hessians_of_front(mesh);
  const auto on = [&](int threads) {
    return test::with_threads(threads, [&] {
      return metric_for(mesh, hessian, {.complexity = 5000, .limits = {.gradation = Gradation{}}}).metric;
    });
  };
  EXPECT_EQ(on(1), on(3));
}

TEST(LpMetric, RefusesWhatMakesNoSense) {
  const Mesh mesh = irregular_cube(3, 9);
  Tensors hessian(64, Tensor{1, 0, 0, 1, 0, 1});
  const auto message = [&](const LpOptions& options) {
    return refusal(1, [&] { return metric_for(mesh, hessian, options); });
  };
  EXPECT_EQ(message({}), "complexity 0 found, expected a number above 0");
  EXPECT_EQ(message({.complexity = 9, .norm = 0.5}), "norm 0.5 found, expected 1 or more");
  EXPECT_EQ(message({.complexity = 9, .limits = {.hmin = 2, .hmax = 1}}),
            "hmin 2, hmax 1 found, expected 0 <= hmin <= hmax, hmax > 0");
  EXPECT_EQ(message({.complexity = 9, .limits = {.anisotropy = 0.9}}), "anisotropy 0.9 found, expected 1 or more");
  hessian[7][2] = infinity;
  EXPECT_EQ(message({.complexity = 9}), "field: vertex 8: a number of the tensor is not finite");
  EXPECT_EQ(refusal(1, [&] { return lp_metric(mesh, {}, {.complexity = 9}); }), "no field found, expected one or more");
}

TEST(ErrorMetric, BoundsTheErrorOfAParabola) {
  const Mesh mesh = irregular_cube(4, 10);
  const Tensors metric =
      error_metric(mesh, Tensors(mesh.points.size(), Tensor{200, 0, 0, -8, 0, 0}), 0.01, {.hmax = 2});
  for (const Tensor& m : metric)
    EXPECT_LT(test::distance(m, Tensor{9.0 / 32 * 200 / 0.01, 0, 0, 9.0 / 32 * 8 / 0.01, 0, 0.25}), 1e-12);
}

}  // namespace
}  // namespace taut
