#include "sizing/truncation.hpp"

#include <gtest/gtest.h>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;

TEST(Truncation, ClipsBothEnds) {
  EXPECT_LT(distance(truncate(Sym3{1e4, 0, 0, 4, 0, 1e-4}, Limits{.hmin = 0.1, .hmax = 10}), {100, 0, 0, 4, 0, 0.01}),
            1e-14);
}

TEST(Truncation, KeepsBitsWithoutBoundsOrWithin) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Sym3 m = random.metric(0.01);
    EXPECT_EQ(truncate(m, Limits{}), m);
    EXPECT_EQ(truncate(m, Limits{.hmin = 0.0099, .hmax = 1.01}), m);
  }
}

TEST(Truncation, BringsAllSizesWithin) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Spectrum s = spectrum(truncate(random.metric(1e-3), Limits{.hmin = 0.01, .hmax = 0.5}));
    EXPECT_GE(s.values[0], 4 * (1 - 1e-9));
    EXPECT_LE(s.values[2], 1e4 * (1 + 1e-9));
  }
}

TEST(Truncation, OfOneSizeIsIsotropic) {
  Random random(3);
  EXPECT_LT(distance(truncate(random.metric(1e-3), Limits{.hmin = 0.2, .hmax = 0.2}), metric_of_size(0.2)), 1e-14);
}

TEST(Truncation, ShortensLongSizesForTheAnisotropy) {
  const Limits limits{.hmin = 0.02, .anisotropy = 10};
  EXPECT_LT(distance(truncate(Sym3{1e4, 0, 0, 4, 0, 1e-4}, limits), {2500, 0, 0, 100, 0, 100}), 1e-12);
  const Sym3 within = {1e4, 0, 0, 100, 0, 101};
  EXPECT_EQ(truncate(within, Limits{.anisotropy = 10}), within);
}

}  // namespace
}  // namespace taut
