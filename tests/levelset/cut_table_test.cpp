// Every row of the table, on tetrahedra and values at random.
#include "levelset/cut_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/vec3.hpp"

namespace taut {
namespace {

class CutTable : public testing::TestWithParam<std::size_t> {
protected:
  const Signs signs = signs_of(GetParam());
  const Cut cut = cuts[GetParam()];

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  /// A positive tetrahedron.
  std::array<Vec3, 4> tetrahedron() {
    std::array<Vec3, 4> x;
    for (Vec3& p : x) p = {number(-1, 1), number(-1, 1), number(-1, 1)};
    if (six_volumes(x[0], x[1], x[2], x[3]) < 0) std::swap(x[0], x[1]);
    return x;
  }

private:
  std::mt19937 generator_{3};
};

/// The gradient of the linear function with these values.
Vec3 gradient(const std::array<Vec3, 4>& x, const std::array<double, 4>& u) {
  const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
  const Vec3 sum = (u[1] - u[0]) * cross(b, c) + (u[2] - u[0]) * cross(c, a) + (u[3] - u[0]) * cross(a, b);
  return (1 / six_volumes(x[0], x[1], x[2], x[3])) * sum;
}

std::vector<Vec3> polygon_at(const Cut& cut, const std::array<Vec3, 4>& x, const std::array<double, 4>& u) {
  std::vector<Vec3> polygon;
  for (std::size_t k = 0; k < cut.count; ++k) {
    const auto [i, j] = detail::ends_of(cut.corners[k]);
    polygon.push_back(i == j ? x[i] : x[i] + (u[i] / (u[i] - u[j])) * (x[j] - x[i]));
  }
  return polygon;
}

TEST_P(CutTable, PatternsAreNumberedByTheirSigns) {
  EXPECT_EQ(pattern_of(signs), GetParam());
}

TEST_P(CutTable, CornersAreAllPlacesOnTheLevel) {
  const bool below = std::ranges::count(signs, -1) > 0, above = std::ranges::count(signs, 1) > 0;
  std::vector<std::size_t> expected;
  for (std::size_t corner = 0; below && above && corner < 10; ++corner) {
    const auto [i, j] = detail::ends_of(corner);
    if (i == j ? signs[i] == 0 : signs[i] * signs[j] < 0) expected.push_back(corner);
  }
  std::vector<std::size_t> found(cut.corners.begin(), cut.corners.begin() + static_cast<std::ptrdiff_t>(cut.count));
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
  if (below && above) {
    EXPECT_GE(cut.count, 3U);
  }
}

TEST_P(CutTable, PolygonsAreConvexAndTheirNormalsPointToLargerValues) {
  for (int trial = 0; trial < 20; ++trial) {
    const std::array<Vec3, 4> x = tetrahedron();
    std::array<double, 4> u;
    for (std::size_t i = 0; i < 4; ++i) u[i] = signs[i] * number(0.1, 1);
    const Vec3 g = gradient(x, u);
    const std::vector<Vec3> polygon = polygon_at(cut, x, u);
    for (std::size_t k = 0; k < cut.count; ++k) {
      const Vec3 &a = polygon[k], &b = polygon[(k + 1) % cut.count], &c = polygon[(k + 2) % cut.count];
      EXPECT_GT(dot(cross(b - a, c - b), g), 0);
      EXPECT_NEAR(dot(c - a, g), 0, 1e-9 * norm(g));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, CutTable, testing::Range<std::size_t>(0, sign_patterns));

}  // namespace
}  // namespace taut
