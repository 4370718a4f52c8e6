#include "metric/length.hpp"

#include <gtest/gtest.h>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::Random;

TEST(Length, OfAConstantMetric) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Sym3 m = random.metric(0.01);
    const Vec3 p = random.point(), q = random.point();
    const double expected = std::sqrt(quadratic_form(m, q - p));
    EXPECT_DOUBLE_EQ(edge_length(p, q, m, m), expected);
    EXPECT_DOUBLE_EQ(edge_length_fast(p, q, m, m), expected);
  }
}

/// Size h(t) = h0 (h1/h0)^t along an edge of length 1: the integral of 1/h by Simpson's rule on many intervals.
double integrated_length(double h0, double h1) {
  const int n = 2000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight / (h0 * std::pow(h1 / h0, i / static_cast<double>(n)));
  }
  return sum / (3 * n);
}

TEST(Length, IsTheIntegralOfAGeometricSize) {
  for (const double ratio : {1.0, 1 + 1e-9, 1.001, 1.019, 1.021, 1.5, 10.0, 100.0}) {
    const double l = edge_length({0, 0, 0}, {0, 1, 0}, metric_of_size(0.1), metric_of_size(0.1 * ratio));
    EXPECT_NEAR(l / integrated_length(0.1, 0.1 * ratio), 1, 1e-11) << "ratio " << ratio;
  }
}

TEST(Length, SeriesMeetsTheLogarithm) {
  // The switch is at (a - b)/(a + b) = 0.01, which is a/b = 1.0202.
  for (const double a : {1.02020, 1.02021, 0.98019, 0.98020}) {
    const double direct = (a - 1) / std::log1p(a - 1);
    EXPECT_NEAR(logarithmic_mean(a, 1) / direct, 1, 1e-13);
  }
}

TEST(Length, IsSymmetric) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Sym3 m = random.metric(0.1), n = random.metric(0.1);
    const Vec3 p = random.point(), q = random.point();
    EXPECT_NEAR(edge_length(p, q, m, n) / edge_length(q, p, n, m), 1, 1e-13);
    EXPECT_DOUBLE_EQ(edge_length_fast(p, q, m, n), edge_length_fast(q, p, n, m));
  }
}

TEST(Length, FastIsCloseWhereSizesAreComparable) {
  for (const double ratio : {1.0, 1.1, 1.5, 2.0})
    EXPECT_NEAR(simpson_mean(1, ratio) / logarithmic_mean(1, ratio), 1, 1e-4);
  EXPECT_NEAR(simpson_mean(1, 10) / logarithmic_mean(1, 10), 1, 1e-2);
}

TEST(Length, TurnsWithTheMetric) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Sym3 m = random.metric(0.01), n = random.metric(0.01);
    const Vec3 p = random.point(), q = random.point();
    const auto r = random.rotation();
    const double turned = edge_length(test::rotate(r, p), test::rotate(r, q), test::rotate(r, m), test::rotate(r, n));
    EXPECT_NEAR(turned / edge_length(p, q, m, n), 1, 1e-10);
  }
}

TEST(Length, OfNothingIsZero) {
  EXPECT_EQ(edge_length({1, 2, 3}, {1, 2, 3}, identity3, identity3), 0);
}

}  // namespace
}  // namespace taut
