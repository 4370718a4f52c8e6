// Metrics for solutions that change in time, under one complexity.
#include <gtest/gtest.h>

#include <limits>

#include "base/with_threads.hpp"
#include "sizing/smooth_fields.hpp"
#include "taut/space_time.hpp"

namespace taut {
namespace {

using test::irregular_cube;
using test::refusal;
using test::sampled;

constexpr double infinity = std::numeric_limits<double>::infinity();

Tensors hessian_of_front(const Mesh& mesh, double place, double height = 1) {
  return recover_hessian(mesh, sampled(mesh, [=](const Point& p) { return height * std::tanh(20 * (p[0] - place)); }));
}

/// A front that moves, in three sub-intervals with different numbers of steps.
class SpaceTime : public testing::Test {
protected:
  const Mesh mesh = irregular_cube(10, 1);

  [[nodiscard]] std::vector<SubInterval> intervals(double height = 1) const {
    return {{&mesh, hessian_of_front(mesh, 0.2, height), 10, 0.5},
            {&mesh, hessian_of_front(mesh, 0.5, height), 40, 0.5},
            {&mesh, hessian_of_front(mesh, 0.8, 0.1 * height), 20, 1.5}};
  }

  void expect_close(const std::vector<ScaledMetric>& found, const std::vector<ScaledMetric>& expected) const {
    for (std::size_t i = 0; i < expected.size(); ++i)
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        ASSERT_LT(test::distance(found[i].metric[v], expected[i].metric[v]), 5e-3);
  }
};

TEST_F(SpaceTime, OfOneStepIsTheLpMetric) {
  for (const double norm : {1.0, 2.0, infinity})
    for (const double duration : {1.0, 0.01}) {
      const LpOptions options{.complexity = 500, .norm = norm, .limits = {.gradation = Gradation{}}};
      const SubInterval interval{&mesh, hessian_of_front(mesh, 0.5), 1, duration};
      const SpaceTimeMetrics found = space_time_metrics({&interval, 1}, options);
      const ScaledMetric expected = lp_metric(mesh, std::array{interval.hessian}, options);
      expect_close(found.metrics, {expected});
      EXPECT_NEAR(found.complexity, 500, 1.01);
    }
}

TEST_F(SpaceTime, HasTheComplexityWithAllLimits) {
  const auto all = intervals();
  for (const double norm : {1.0, 2.0, infinity})
    for (const Limits& limits :
         {Limits{}, Limits{.hmin = 0.02, .hmax = 0.5, .anisotropy = 20, .gradation = Gradation{}}}) {
      const SpaceTimeMetrics found = space_time_metrics(all, {.complexity = 3e4, .norm = norm, .limits = limits});
      double sum = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(complexity(mesh, found.metrics[i].metric), found.metrics[i].complexity, 1e-9 * 3e4);
        sum += all[i].steps * found.metrics[i].complexity;
      }
      EXPECT_NEAR(sum, 3e4, 0.00201 * 3e4);
      EXPECT_NEAR(found.complexity, sum, 1e-9 * sum);
      EXPECT_EQ(found.stopped_by, "");
    }
}

/// Without limits the complexities are proportional to n^(-3/(2p+3)) d^(3p/(2p+3)), for equal Hessians.
TEST_F(SpaceTime, WeighsStepsAndDurations) {
  const Tensors hessian(mesh.points.size(), Tensor{100, 0, 0, 10, 0, 1});
  const std::vector<SubInterval> all = {{&mesh, hessian, 1, 1}, {&mesh, hessian, 8, 1}, {&mesh, hessian, 1, 4}};
  for (const double p : {1.0, 2.0, 4.0}) {
    const auto metrics = space_time_metrics(all, {.complexity = 1e4, .norm = p, .limits = {.hmax = 100}}).metrics;
    EXPECT_NEAR(metrics[1].complexity / metrics[0].complexity, std::pow(8, -3 / (2 * p + 3)), 1e-9);
    EXPECT_NEAR(metrics[2].complexity / metrics[0].complexity, std::pow(4, 3 * p / (2 * p + 3)), 1e-9);
  }
}

TEST_F(SpaceTime, DoesNotSeeTheUnitOfTheField) {
  for (const double height : {1e-9, 1e9})
    expect_close(space_time_metrics(intervals(height), {.complexity = 2e4}).metrics,
                 space_time_metrics(intervals(), {.complexity = 2e4}).metrics);
}

TEST_F(SpaceTime, AQuietIntervalGetsLittle) {
  auto all = intervals();
  all[0].hessian = Tensors(mesh.points.size());
  const SpaceTimeMetrics found = space_time_metrics(all, {.complexity = 3e4});
  EXPECT_LT(found.metrics[0].complexity, 2);
  EXPECT_GT(found.metrics[1].complexity, 100);
}

TEST_F(SpaceTime, QuietTimesAreUniform) {
  HessianInTime quiet(InTime::intersection);
  for (int i = 0; i < 2; ++i) quiet.add(Tensors(mesh.points.size()), 1);
  const SubInterval interval{&mesh, quiet.hessian(), 2, 2};
  const SpaceTimeMetrics found = space_time_metrics({&interval, 1}, {.complexity = 2000});
  for (const Tensor& m : found.metrics[0].metric) EXPECT_LT(test::distance(m, metric_of_size(0.1)), 5e-3);
}

TEST_F(SpaceTime, SaysWhatStopsIt) {
  const auto all = intervals();
  const auto fine = space_time_metrics(all, {.complexity = 1e7, .limits = {.hmin = 0.1}});
  EXPECT_EQ(fine.stopped_by, "hmin");
  EXPECT_NEAR(fine.complexity, 7e4, 200);
  EXPECT_EQ(space_time_metrics(all, {.complexity = 10, .limits = {.hmax = 0.2}}).stopped_by, "hmax");
}

TEST_F(SpaceTime, ServesSeveralMeshes) {
  const Mesh other = irregular_cube(6, 2);
  const std::vector<SubInterval> all = {{&mesh, hessian_of_front(mesh, 0.3), 5, 1},
                                        {&other, hessian_of_front(other, 0.7), 5, 1}};
  const SpaceTimeMetrics found = space_time_metrics(all, {.complexity = 5000});
  EXPECT_EQ(found.metrics[0].metric.size(), mesh.points.size());
  EXPECT_EQ(found.metrics[1].metric.size(), other.points.size());
  EXPECT_NEAR(found.complexity, 5000, 10.1);
}

TEST_F(SpaceTime, HasTheSameBitsOnAnyNumberOfThreads) {
  const auto on = [&](int threads) {
    return test::with_threads(threads, [&] {
      return space_time_metrics(intervals(), {.complexity = 1e4, .limits = {.gradation = Gradation{}}});
    });
  };
  const auto one = on(1), three = on(3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(one.metrics[i].metric, three.metrics[i].metric);
}

TEST_F(SpaceTime, RefusesWhatMakesNoSense) {
  auto all = intervals();
  const auto message = [&](double complexity) {
    return refusal(1, [&] { return space_time_metrics(all, {.complexity = complexity}); });
  };
  EXPECT_EQ(message(0), "complexity 0 found, expected a number above 0");
  all[1].steps = 0;
  EXPECT_EQ(message(9), "sub-interval 2: steps 0 found, expected a number above 0");
  all[1].steps = 1;
  all[2].duration = infinity;
  EXPECT_EQ(message(9), "sub-interval 3: duration inf found, expected a number above 0");
  all[2].duration = 1;
  all[0].hessian.pop_back();
  EXPECT_EQ(message(9), "sub-interval 1: field: 1330 values for 1331 vertices, expected one per vertex");
  all[0].mesh = nullptr;
  EXPECT_EQ(message(9), "sub-interval 1: no mesh found");
  all.clear();
  EXPECT_EQ(message(9), "no sub-interval found, expected one or more");
}

TEST(HessianInTime, AveragesByTheLengthOfTheSteps) {
  HessianInTime collected;
  EXPECT_TRUE(collected.hessian().empty());
  collected.add({{4, 0, 0, -8, 0, 12}}, 1);
  collected.add({{-8, 0, 0, 4, 0, 4}}, 3);
  EXPECT_LT(test::distance(collected.hessian()[0], {7, 0, 0, 5, 0, 6}), 1e-12);
  EXPECT_EQ(collected.steps(), 2U);
  EXPECT_EQ(collected.duration(), 4);
}

TEST(HessianInTime, IntersectsRegardlessOfTheLengthOfTheSteps) {
  HessianInTime collected(InTime::intersection);
  collected.add({{4, 0, 0, -8, 0, 12}}, 1);
  collected.add({{-8, 0, 0, 4, 0, 4}}, 0.001);
  EXPECT_LT(test::distance(collected.hessian()[0], {8, 0, 0, 8, 0, 12}), 1e-9);
}

TEST(HessianInTime, RefusesWhatMakesNoSense) {
  HessianInTime collected;
  const auto message = [&](const Tensors& hessian, double dt) {
    return refusal(1, [&] { return collected.add(hessian, dt), 0; });
  };
  EXPECT_EQ(message({Tensor{}}, 0), "dt 0 found, expected a number above 0");
  EXPECT_EQ(message({Tensor{1, 0, infinity}}, 1), "field: vertex 1: a number of the tensor is not finite");
  collected.add({Tensor{}}, 1);
  EXPECT_EQ(message({Tensor{}, Tensor{}}, 1), "field: 2 values for 1 vertices, expected one per vertex");
}

}  // namespace
}  // namespace taut
