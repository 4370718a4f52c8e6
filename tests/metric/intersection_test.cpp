#include "metric/intersection.hpp"

#include <gtest/gtest.h>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;

TEST(Intersection, OfAlignedMetricsTakesTheSmallerSizes) {
  const Sym3 both = intersect({1, 0, 0, 100, 0, 4}, {25, 0, 0, 9, 0, 5});
  EXPECT_LT(distance(both, {25, 0, 0, 100, 0, 5}), 1e-14);
}

TEST(Intersection, GrantsBothWishes) {
  Random random(1);
  for (const double smallest : {0.5, 0.1, 1e-3}) {
    for (int i = 0; i < 300; ++i) {
      const Sym3 m = random.metric(smallest), n = random.metric(smallest), both = intersect(m, n);
      EXPECT_TRUE(is_dominated(m, both, 1 + 1e-8));
      EXPECT_TRUE(is_dominated(n, both, 1 + 1e-8));
    }
  }
}

TEST(Intersection, IsSymmetric) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Sym3 m = random.metric(0.01), n = random.metric(0.01);
    EXPECT_LT(distance(intersect(m, n), intersect(n, m)), 1e-10);
  }
}

TEST(Intersection, IsIdempotent) {
  Random random(3);
  for (const double smallest : {0.1, 1e-2, 1e-4}) {
    for (int i = 0; i < 300; ++i) {
      const Sym3 m = random.metric(smallest), n = random.metric(smallest), both = intersect(m, n);
      EXPECT_EQ(intersect(m, m), m);
      EXPECT_LT(distance(intersect(both, n), both), 1e-7);
      EXPECT_LT(distance(intersect(both, m), both), 1e-7);
    }
  }
}

TEST(Intersection, KeepsTheBitsOfTheOneThatGrantsTheOther) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Sym3 m = random.metric(1e-4);
    EXPECT_EQ(intersect(m, 0.5 * m), m);
    EXPECT_EQ(intersect(0.5 * m, m), m);
    EXPECT_EQ(intersect(m, (1 + 1e-13) * m), m);
  }
}

TEST(Intersection, TurnsWithItsArguments) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Sym3 m = random.metric(0.05), n = random.metric(0.05);
    const auto r = random.rotation();
    EXPECT_LT(distance(intersect(test::rotate(r, m), test::rotate(r, n)), test::rotate(r, intersect(m, n))), 1e-10);
  }
}

TEST(Intersection, IsPositiveDefinite) {
  Random random(6);
  for (int i = 0; i < 3000; ++i) EXPECT_TRUE(is_positive_definite(intersect(random.metric(1e-5), random.metric(1e-5))));
}

}  // namespace
}  // namespace taut
