#include "sizing/truncation.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Truncation, ClipsBothEnds) {
  EXPECT_LT(distance(truncate({1e4, 0, 0, 4, 0, 1e-4}, 0.1, 10), {100, 0, 0, 4, 0, 0.01}), 1e-14);
}

TEST(Truncation, KeepsBitsWithoutBoundsOrWithin) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Sym3 m = random.metric(0.01);
    EXPECT_EQ(truncate(m, 0, infinity), m);
    EXPECT_EQ(truncate(m, 0.0099, 1.01), m);
  }
}

TEST(Truncation, BringsAllSizesWithin) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Spectrum s = spectrum(truncate(random.metric(1e-3), 0.01, 0.5));
    EXPECT_GE(s.values[0], 4 * (1 - 1e-9));
    EXPECT_LE(s.values[2], 1e4 * (1 + 1e-9));
  }
}

TEST(Truncation, OfOneSizeIsIsotropic) {
  Random random(3);
  EXPECT_LT(distance(truncate(random.metric(1e-3), 0.2, 0.2), metric_of_size(0.2)), 1e-14);
}

}  // namespace
}  // namespace taut
