#include "metric/quality.hpp"

#include <gtest/gtest.h>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::Random;
using Tet = std::array<Vec3, 4>;

const Tet regular = {{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}};
const Tet corner = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

double shape(const Tet& t, const Sym3& m) {
  return shape_quality(t[0], t[1], t[2], t[3], m, m, m, m);
}
double ratio(const Tet& t, const Sym3& m) {
  return mean_ratio(t[0], t[1], t[2], t[3], m);
}

TEST(ShapeQuality, OfTheRegularTetrahedronIsOne) {
  ASSERT_GT(six_volumes(regular[0], regular[1], regular[2], regular[3]), 0);
  for (const double h : {1e-3, 1.0, 50.0}) {
    EXPECT_NEAR(shape(regular, metric_of_size(h)), 1, 1e-14);
    EXPECT_NEAR(ratio(regular, metric_of_size(h)), 1, 1e-14);
  }
}

TEST(ShapeQuality, OfTheCornerOfACube) {
  // Volume 1/6, sum of squared edges 3 + 3*2 = 9: 72 sqrt 3 / 6 / 27.
  EXPECT_NEAR(shape(corner, identity3), 12 * std::sqrt(3.0) / 27, 1e-15);
  EXPECT_NEAR(ratio(corner, identity3), std::pow(12 * std::sqrt(3.0) / 27, 2.0 / 3), 1e-15);
}

TEST(ShapeQuality, IsOneForTheTetrahedronRegularInTheMetric) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Sym3 m = random.metric(1e-3);
    // M^(-1/2) maps regular tetrahedra to tetrahedra that are regular in M.
    const Sym3 root = map_eigenvalues(m, [](double lambda) { return 1 / std::sqrt(lambda); });
    Tet t = regular;
    for (Vec3& p : t) p = root * p;
    EXPECT_NEAR(shape(t, m), 1, 1e-8);
    EXPECT_NEAR(ratio(t, m), 1, 1e-8);
  }
}

TEST(ShapeQuality, IsAtMostOneAndSignedAsTheVolume) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Tet t = {random.point(), random.point(), random.point(), random.point()};
    const Sym3 m = random.metric(0.01);
    EXPECT_LE(std::abs(shape(t, m)), 1 + 1e-12);
    EXPECT_EQ(shape(t, m) > 0, six_volumes(t[0], t[1], t[2], t[3]) > 0);
    EXPECT_NEAR(shape({t[1], t[0], t[2], t[3]}, m), -shape(t, m), 1e-12);
    EXPECT_NEAR(ratio({t[1], t[0], t[2], t[3]}, m), -ratio(t, m), 1e-12);
    EXPECT_NEAR(std::abs(ratio(t, m)), std::pow(std::abs(shape(t, m)), 2.0 / 3), 1e-12);
  }
}

TEST(ShapeQuality, TurnsAndScalesWithTheMetric) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Tet t = {random.point(), random.point(), random.point(), random.point()};
    const Sym3 m = random.metric(0.01);
    const auto r = random.rotation();
    Tet turned = t;
    for (Vec3& p : turned) p = 7.0 * test::rotate(r, p);
    EXPECT_NEAR(shape(turned, test::rotate(r, m)), shape(t, m), 1e-9);
  }
}

TEST(ShapeQuality, OfAFlatTetrahedronIsZero) {
  EXPECT_EQ(shape({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, identity3), 0);
}

TEST(Efficiency, FallsOffOnBothSidesOfUnitLength) {
  EXPECT_EQ(efficiency_phi(1), 0);
  EXPECT_EQ(efficiency_phi(0.5), -0.5);
  EXPECT_EQ(efficiency_phi(2), -0.5);
}

}  // namespace
}  // namespace taut
