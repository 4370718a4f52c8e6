// How much a transfer loses.
#include <gtest/gtest.h>

#include "transfer/meshes.hpp"

namespace taut {
namespace {

double error_after_one(Index n, Transfer method) {
  const Mesh from = test::shaken_cube(n, 1), to = test::shaken_cube(n + n / 4, 2);
  const Transferred result = transfer(from, {test::sampled_field(from, test::smooth_function)}, to, {.method = method});
  return test::error_norm(to, result.fields[0], test::smooth_function);
}

TEST(TransferAccuracy, IsOfSecondOrder) {
  for (const Transfer method : {Transfer::linear, Transfer::conservative}) {
    const double coarse = error_after_one(4, method), fine = error_after_one(16, method);
    EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.85);
  }
}

struct ManyTimes {
  double error, mass_error;  ///< relative: to the interpolation error, to the mass
  double least, greatest;
};

ManyTimes back_and_forth(const Mesh& a, const Mesh& b, int times, const test::Function& f, const TransferOptions& o) {
  Field field = test::sampled_field(a, f);
  const Mesh* at = &a;
  TransferReport first, last;
  for (int i = 0; i < times; ++i) {
    const Mesh* next = at == &a ? &b : &a;
    Transferred result = transfer(*at, {field}, *next, o);
    field = result.fields[0];
    (i == 0 ? first : last) = std::move(result.report);
    at = next;
  }
  const auto [low, high] = std::minmax_element(field.values.begin(), field.values.end());
  const double before = first.fields[0][0].mass_before;
  return {test::error_norm(*at, field, f) / test::error_norm(*at, test::sampled_field(*at, f), f),
          std::abs(last.fields[0][0].mass_after - before) / std::abs(before), *low, *high};
}

double waves(const Point& p) {
  return 1.5 + std::sin(4 * p[0]) * std::cos(3 * p[1]) * std::cos(2 * p[2]);
}

TEST(TransferAccuracy, LastsForThirtyTransfers) {
  const Mesh a = adapt(test::cube(6), test::uniform(0.12), {}).mesh,
             b = adapt(test::cube(6), test::uniform(0.125), {}).mesh;
  const ManyTimes smooth = back_and_forth(a, b, 30, waves, {});
  EXPECT_LT(smooth.error, 1.5);
  EXPECT_LT(smooth.mass_error, 1e-12);
  const ManyTimes step = back_and_forth(a, b, 30, test::step_function, {});
  EXPECT_GE(step.least, 0);
  EXPECT_LE(step.greatest, 1);
  EXPECT_GT(step.greatest, 0.99);
  EXPECT_LT(step.mass_error, 1e-12);
}

TEST(TransferAccuracy, WithoutLimitsThePeaksLastAndJumpsOvershoot) {
  const Mesh a = test::shaken_cube(7, 1), b = test::shaken_cube(6, 2);
  const ManyTimes limited = back_and_forth(a, b, 6, waves, {}),
                  free = back_and_forth(a, b, 6, waves, {.limited = false});
  EXPECT_GE(free.greatest, limited.greatest);
  const ManyTimes step = back_and_forth(a, b, 2, test::step_function, {.limited = false});
  EXPECT_LT(step.least, -0.01);
  EXPECT_GT(step.greatest, 1.01);
  EXPECT_LT(step.mass_error, 1e-12);
}

}  // namespace
}  // namespace taut
