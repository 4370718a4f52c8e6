#include "metric/spectral.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;

/// The relative accuracy of a size in six doubles, if the sizes have this ratio.
double size_tolerance(double ratio) {
  return 1e-13 + 4e-16 * ratio * ratio;
}

TEST(Spectral, ExponentialUndoesLogarithm) {
  Random random(1);
  for (const double smallest : {1.0, 0.1, 1e-2, 1e-4}) {
    for (int i = 0; i < 300; ++i) {
      const Sym3 m = random.metric(smallest);
      EXPECT_LT(distance(exp_metric(log_metric(m)), m), 1e-7 * smallest + 2e-13);
    }
  }
}

TEST(Spectral, ExponentialOfKnownEigenvalues) {
  Random random(2);
  for (const double ratio : {1.0, 1.001, 10.0, 1e3, 1e4}) {
    for (int i = 0; i < 300; ++i) {
      Spectrum s{{}, random.rotation()};
      for (double& value : s.values) value = 2 * std::log(ratio) * random.uniform(0, 1);
      const Sym3 m = exp_metric(assemble(s));
      for (std::size_t k = 0; k < 3; ++k) {
        const double size = 1 / std::sqrt(quadratic_form(m, s.vectors[k]));
        EXPECT_NEAR(size / std::exp(-s.values[k] / 2), 1, size_tolerance(ratio));
      }
    }
  }
}

TEST(Spectral, ExponentialOfDiagonalStaysDiagonal) {
  const Sym3 m = exp_metric({std::log(1e8), 0, 0, std::log(4.0), 0, 0});
  EXPECT_NEAR(m[0] / 1e8, 1, 1e-13);
  EXPECT_NEAR(m[3] / 4, 1, 1e-13);
  EXPECT_NEAR(m[5], 1, 1e-13);
  EXPECT_EQ(m[1], 0);
  EXPECT_EQ(m[2], 0);
  EXPECT_EQ(m[4], 0);
}

TEST(Spectral, ExponentialOfMultipleOfIdentityIsExact) {
  for (const double t : {-30.0, 0.0, 0.3, 20.0}) {
    EXPECT_EQ(exp_metric(t * identity3), std::exp(t) * identity3);
  }
}

TEST(Spectral, ExponentialIsAlwaysPositiveDefinite) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    Spectrum s{{}, random.rotation()};
    const double spread = random.uniform(0, 200);
    for (double& value : s.values) value = random.uniform(-spread, spread);
    EXPECT_TRUE(is_positive_definite(exp_metric(assemble(s)))) << "spread " << spread;
  }
}

TEST(Spectral, ExponentialTurnsWithItsArgument) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Sym3 l = log_metric(random.metric(0.01));
    const auto r = random.rotation();
    EXPECT_LT(distance(exp_metric(test::rotate(r, l)), test::rotate(r, exp_metric(l))), 1e-12);
  }
}

TEST(Spectral, AssembleUndoesSpectrum) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Sym3 m = random.metric(1e-3);
    const Spectrum s = spectrum(m);
    EXPECT_LE(s.values[0], s.values[1]);
    EXPECT_LE(s.values[1], s.values[2]);
    EXPECT_LT(distance(assemble(s), m), 1e-14);
  }
}

TEST(Spectral, PositiveDefiniteMeansFiniteToo) {
  EXPECT_TRUE(is_positive_definite(identity3));
  EXPECT_TRUE(is_positive_definite({2, 1, 0, 2, 1, 2}));
  EXPECT_FALSE(is_positive_definite({1, 0, 0, 1, 0, 0}));
  EXPECT_FALSE(is_positive_definite({1, 0, 0, -1, 0, 1}));
  EXPECT_FALSE(is_positive_definite({1, 2, 0, 1, 0, 1}));
  EXPECT_FALSE(is_positive_definite({-1, 0, 0, -1, 0, 1}));
  EXPECT_FALSE(is_positive_definite({0, 0, 0, 0, 0, 0}));
  for (std::size_t i = 0; i < 6; ++i) {
    Sym3 m = identity3;
    m[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_positive_definite(m));
    m[i] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_positive_definite(m));
  }
}

TEST(Cholesky, DeterminantIsTheProductOfTheEigenvalues) {
  Random random(6);
  for (const double smallest : {1.0, 1e-2, 1e-4}) {
    for (int i = 0; i < 300; ++i) {
      Spectrum s{{1 / (smallest * smallest), 1, 3}, random.rotation()};
      EXPECT_NEAR(determinant_spd(assemble(s)) * smallest * smallest / 3, 1, 10 * size_tolerance(1 / smallest));
    }
  }
}

TEST(Cholesky, DominanceIsOfAllDirections) {
  EXPECT_TRUE(is_dominated(identity3, metric_of_size(0.5)));
  EXPECT_FALSE(is_dominated(metric_of_size(0.5), identity3));
  EXPECT_TRUE(is_dominated(metric_of_size(0.5), identity3, 4.001));
  EXPECT_FALSE(is_dominated({1, 0, 0, 3, 0, 1}, {2, 0, 0, 2, 0, 2}));
}

}  // namespace
}  // namespace taut
