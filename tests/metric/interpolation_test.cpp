#include "metric/interpolation.hpp"

#include <gtest/gtest.h>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;

TEST(Interpolation, LinearSizes) {
  const Sym3 m = interpolate_linear_in_size(metric_of_size(1), metric_of_size(3), 0.25);
  EXPECT_LT(distance(m, metric_of_size(1.5)), 1e-14);
}

TEST(Interpolation, GeometricSizes) {
  const std::array<Sym3, 2> ends = {metric_of_size(1), metric_of_size(4)};
  EXPECT_LT(distance(interpolate_log_euclidean(ends, std::array{0.5, 0.5}), metric_of_size(2)), 1e-14);
}

TEST(Interpolation, MeetsTheEnds) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::array<Sym3, 2> ends = {random.metric(0.01), random.metric(0.01)};
    EXPECT_LT(distance(interpolate_linear_in_size(ends[0], ends[1], 0), ends[0]), 1e-10);
    EXPECT_LT(distance(interpolate_linear_in_size(ends[0], ends[1], 1), ends[1]), 1e-10);
    EXPECT_LT(distance(interpolate_log_euclidean(ends, std::array{0.0, 1.0}), ends[1]), 1e-11);
  }
}

TEST(Interpolation, KeepsAConstantMetric) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Sym3 m = random.metric(0.01);
    const std::array<Sym3, 4> corners = {m, m, m, m};
    EXPECT_LT(distance(interpolate_log_euclidean(corners, std::array{0.1, 0.2, 0.3, 0.4}), m), 1e-11);
    EXPECT_LT(distance(interpolate_linear_in_size(m, m, 0.3), m), 1e-10);
  }
}

TEST(Interpolation, DeterminantIsTheGeometricMean) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const std::array<Sym3, 3> corners = {random.metric(0.1), random.metric(0.1), random.metric(0.1)};
    const std::array<double, 3> w = {0.5, 0.3, 0.2};
    double expected = 0;
    for (std::size_t k = 0; k < 3; ++k) expected += w[k] * std::log(determinant_spd(corners[k]));
    EXPECT_NEAR(std::log(determinant_spd(interpolate_log_euclidean(corners, w))), expected, 1e-9);
  }
}

TEST(Interpolation, FromLogarithmsIsTheSame) {
  Random random(4);
  const std::array<Sym3, 2> ends = {random.metric(0.1), random.metric(0.1)};
  const std::array<Sym3, 2> logarithms = {log_metric(ends[0]), log_metric(ends[1])};
  const std::array<double, 2> w = {0.4, 0.6};
  EXPECT_EQ(interpolate_logarithms(logarithms, w), interpolate_log_euclidean(ends, w));
}

}  // namespace
}  // namespace taut
