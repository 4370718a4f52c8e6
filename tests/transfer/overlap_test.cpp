// The intersection of two tetrahedra and the integrals over it.
#include "transfer/overlap.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "mesh/shapes.hpp"

namespace taut {
namespace {

using Corners = std::array<Vec3, 4>;

constexpr Corners unit = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Corners moved(Corners corners, double scale, const Vec3& by) {
  for (Vec3& x : corners) x = scale * x + by;
  return corners;
}

Corners random_tet(std::mt19937_64& generator, double stretch) {
  std::uniform_real_distribution<double> place(-1, 1);
  Corners x;
  do {
    for (Vec3& corner : x) corner = {place(generator), place(generator), stretch * place(generator)};
    if (six_volumes(x[0], x[1], x[2], x[3]) < 0) std::swap(x[2], x[3]);
  } while (six_volumes(x[0], x[1], x[2], x[3]) < 1e-2 * stretch);
  return x;
}

double sum_of(const Matrix4& matrix) {
  double sum = 0;
  for (const Weights4& row : matrix)
    for (const double x : row) sum += x;
  return sum;
}

TEST(Overlap, OfEqualTetrahedraIsTheMassMatrix) {
  const auto common = overlap(TetFrame(unit), unit);
  ASSERT_TRUE(common);
  EXPECT_NEAR(common->volume, 1.0 / 6, 1e-16);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(common->target_source[i][k], (i == k ? 2 : 1) / 120.0, 1e-17);
      EXPECT_NEAR(common->target_target[i][k], (i == k ? 2 : 1) / 120.0, 1e-17);
    }
}

TEST(Overlap, OfOneInsideTheOtherIsTheSmaller) {
  const Corners small = moved(unit, 0.1, {0.2, 0.3, 0.1});
  for (const bool swapped : {false, true}) {
    const auto common = swapped ? overlap(TetFrame(small), unit) : overlap(TetFrame(unit), small);
    ASSERT_TRUE(common);
    EXPECT_NEAR(common->volume, 1e-3 / 6, 1e-18);
    EXPECT_EQ(common->reaches, (swapped ? std::array{false, false, false, false} : std::array{true, true, true, true}));
  }
}

TEST(Overlap, OfTetrahedraThatOnlyTouchIsNone) {
  EXPECT_FALSE(overlap(TetFrame(unit), moved(unit, 1, {1, 0, 0})));
  EXPECT_FALSE(overlap(TetFrame(unit), moved(unit, 1, {0, 0, 5})));
  Corners mirrored = unit;
  mirrored[3] = {0, 0, -1};
  std::swap(mirrored[1], mirrored[2]);
  EXPECT_FALSE(overlap(TetFrame(unit), mirrored));
}

TEST(Overlap, HasAKnownVolume) {
  // The corner of the unit tetrahedron at the origin, cut by the plane x + y + z = 3/4 moved by 1/4.
  const auto common = overlap(TetFrame(unit), moved(unit, 1, {0.25, 0.25, 0.25}));
  ASSERT_TRUE(common);
  EXPECT_NEAR(common->volume, std::pow(0.25, 3) / 6, 1e-17);
}

TEST(Overlap, IsSymmetric) {
  std::mt19937_64 generator(1);
  int common_ones = 0;
  for (int i = 0; i < 2000; ++i) {
    const Corners a = random_tet(generator, 1), b = random_tet(generator, i % 2 == 0 ? 1 : 0.05);
    const auto ab = overlap(TetFrame(a), b), ba = overlap(TetFrame(b), a);
    ASSERT_EQ(ab.has_value(), ba.has_value());
    if (!ab) continue;
    ++common_ones;
    EXPECT_NEAR(ab->volume, ba->volume, 1e-15);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t m = 0; m < 4; ++m) EXPECT_NEAR(ab->target_source[k][m], ba->target_source[m][k], 1e-15);
  }
  EXPECT_GT(common_ones, 1000);
}

// The weights sum up to 1, so the sum of all integrals is the volume. No integral is negative.
TEST(Overlap, IntegralsSumUpToTheVolume) {
  std::mt19937_64 generator(2);
  for (int i = 0; i < 1000; ++i) {
    const auto common = overlap(TetFrame(random_tet(generator, 1)), random_tet(generator, 0.1));
    if (!common) continue;
    EXPECT_NEAR(sum_of(common->target_source), common->volume, 1e-13 * common->volume);
    EXPECT_NEAR(sum_of(common->target_target), common->volume, 1e-13 * common->volume);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t m = 0; m < 4; ++m) {
        EXPECT_GE(common->target_source[k][m], -1e-17);
        EXPECT_GE(common->target_target[k][m], -1e-17);
      }
  }
}

// A tetrahedron inside a cube is the sum of its intersections with the tetrahedra of any grid of the cube, whose planes
// meet it in many degenerate ways.
TEST(Overlap, AddsUpOverAMesh) {
  std::mt19937_64 generator(3);
  for (const Index n : {1, 2, 4}) {
    const Mesh mesh = test::grid(n);
    for (int i = 0; i < 20; ++i) {
      Corners inner = random_tet(generator, 0.3);
      for (Vec3& x : inner)
        for (double& c : x) c = i % 2 == 0 ? 0.5 + 0.5 * c : std::round(8 * (0.5 + 0.5 * c)) / 8;
      const TetFrame frame(inner);
      if (!(frame.volume > 1e-4)) continue;
      double volume = 0;
      Matrix4 mass{};
      for (const auto& t : mesh.tetrahedra) {
        const auto common =
            overlap(frame, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]});
        if (!common) continue;
        volume += common->volume;
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t m = 0; m < 4; ++m) mass[k][m] += common->target_target[k][m];
      }
      EXPECT_NEAR(volume, frame.volume, 1e-14 * frame.volume);
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t m = 0; m < 4; ++m)
          EXPECT_NEAR(mass[k][m], (k == m ? 2 : 1) * frame.volume / 20, 1e-14 * frame.volume);
    }
  }
}

}  // namespace
}  // namespace taut
