#include "mesh/orientation.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace taut {
namespace {

using boost::multiprecision::cpp_rational;

int by_rationals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  std::array<std::array<cpp_rational, 3>, 3> m;
  for (std::size_t k = 0; k < 3; ++k) {
    m[0][k] = cpp_rational(b[k]) - cpp_rational(a[k]);
    m[1][k] = cpp_rational(c[k]) - cpp_rational(a[k]);
    m[2][k] = cpp_rational(d[k]) - cpp_rational(a[k]);
  }
  const cpp_rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det.sign();
}

void expect_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int expected = by_rationals(a, b, c, d);
  EXPECT_EQ(orientation(a, b, c, d), expected);
  EXPECT_EQ(exact_orientation(a, b, c, d), expected);
  EXPECT_EQ(orientation(b, a, c, d), -expected);
  EXPECT_EQ(orientation(d, c, b, a), expected);
}

TEST(Orientation, OfPlainTetrahedra) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0);
  EXPECT_EQ(orientation({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}), 0);
}

TEST(Orientation, OnAGridOfUlps) {
  // Around a point of the plane x = y, in steps of one unit in the last place: zero only on the diagonal.
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const Vec3 a = {0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 0.3};
      expect_exact(a, {12, 12, 0.1}, {24, 24, 1.7}, {-7, -7, 25});
      EXPECT_EQ(orientation(a, {12, 12, 0.1}, {24, 24, 1.7}, {-7, -7, 25}) == 0, a[0] == a[1]);
    }
  }
}

TEST(Orientation, OfMidpointsOnAPlane) {
  // The sums of corners of a cell lie exactly on it, or miss it only by rounding.
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Vec3{uniform(generator), uniform(generator), uniform(generator)}; };
  for (int i = 0; i < 500; ++i) {
    const Vec3 a = point(), b = point(), c = point();
    const double s = uniform(generator), t = uniform(generator);
    expect_exact(a, b, c, a + s * (b - a) + t * (c - a));
    expect_exact(a, b, c, 0.5 * (a + b));
    expect_exact(a, b, c, point());
  }
}

TEST(Orientation, AtAllScales) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const int exponent : {-1060, -600, -360, -330, -100, 0, 100, 330, 600, 1020}) {
    const auto point = [&] {
      return Vec3{std::ldexp(uniform(generator), exponent), std::ldexp(uniform(generator), exponent),
                  std::ldexp(uniform(generator), exponent)};
    };
    for (int i = 0; i < 30; ++i) {
      const Vec3 a = point(), b = point(), c = point();
      expect_exact(a, b, c, point());
      expect_exact(a, b, c, 0.5 * a + 0.5 * b);
    }
  }
}

TEST(Orientation, AcrossScales) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> exponent(-1000, 1000);
  const auto number = [&] { return std::ldexp(uniform(generator), exponent(generator)); };
  const auto point = [&] { return Vec3{number(), number(), number()}; };
  for (int i = 0; i < 100; ++i) expect_exact(point(), point(), point(), point());
}

TEST(Orientation, OnTheSideOfABox) {
  const double x = 0.1 + 0.2;
  expect_exact({x, 0.1, 0.7}, {x, 0.3, 0.2}, {x, 0.9, 0.4}, {x, 0.5, 0.5});
  EXPECT_EQ(orientation({x, 0.1, 0.7}, {x, 0.3, 0.2}, {x, 0.9, 0.4}, {x, 0.5, 0.5}), 0);
}

}  // namespace
}  // namespace taut
