// Rigid motions: exact to rounding after thousands of compositions, and divisible.
#include "taut/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/sym3.hpp"

namespace taut::test {
namespace {

constexpr Point centre = {0.3, -1.2, 2.0}, axis = {1, -2, 0.5}, somewhere = {0.7, 3.1, -0.4};

void expect_near(const Point& a, const Point& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

void expect_near(const RigidMotion& a, const RigidMotion& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) expect_near(a.matrix()[i], b.matrix()[i], tolerance);
  expect_near(a.offset(), b.offset(), tolerance);
}

void expect_orthogonal(const RigidMotion& motion, double tolerance) {
  const auto& r = motion.matrix();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(dot(r[i], r[j]), i == j ? 1 : 0, tolerance);
  EXPECT_NEAR(dot(r[0], cross(r[1], r[2])), 1, tolerance);
}

RigidMotion any(std::mt19937& random, double degrees) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return Point{number(random), number(random), number(random)}; };
  return RigidMotion::translation(point()) * RigidMotion::rotation(point(), point(), degrees * number(random));
}

template <class Call>
std::string error_of(Call call) {
  try {
    (void)call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(RigidMotion, MovesNothingByDefault) {
  EXPECT_EQ(RigidMotion()(somewhere), somewhere);
  expect_near(RigidMotion(), RigidMotion::rotation(centre, axis, 720), 1e-15);
}

TEST(RigidMotion, FollowsTheRightHandRule) {
  expect_near(RigidMotion::rotation({0, 0, 0}, {0, 0, 7}, 90)({1, 0, 5}), {0, 1, 5}, 1e-15);
  expect_near(RigidMotion::rotation({1, 1, 0}, {0, 0, 1e-200}, 90)({2, 1, 0}), {1, 2, 0}, 1e-15);
  expect_near(RigidMotion::rotation({1, 1, 0}, {0, 0, -1e200}, -180)({2, 1, 0}), {0, 1, 0}, 1e-15);
  EXPECT_EQ(RigidMotion::translation({1, 2, 3})({1, 1, 1}), (Point{2, 3, 4}));
}

TEST(RigidMotion, RotationKeepsItsAxis) {
  const RigidMotion rotation = RigidMotion::rotation(centre, axis, 77);
  expect_near(rotation(centre), centre, 1e-15);
  expect_near(rotation(centre + 3 * axis), centre + 3 * axis, 1e-14);
}

TEST(RigidMotion, SetsOutWithTheVelocityOfItsScrew) {
  constexpr double h = 1e-4;
  std::mt19937 random(5);
  for (const double degrees : {1e-6, 1.0, 90.0, 179.0}) {
    const RigidMotion motion = any(random, degrees);
    const Point difference = motion.share(h)(somewhere) - motion.share(-h)(somewhere);
    expect_near(motion.velocity(somewhere), 1 / (2 * h) * difference, 1e-6);
  }
  expect_near(RigidMotion::translation({1, 2, 3}).velocity(somewhere), {1, 2, 3}, 0);
  expect_near(RigidMotion::rotation({0, 0, 0}, {0, 0, 1}, 180 / std::numbers::pi).velocity({2, 0, 7}), {0, 2, 0},
              1e-15);
}

TEST(RigidMotion, AWholeTurnInManyStepsComesBack) {
  for (const int steps : {100, 1000}) {
    const RigidMotion step = RigidMotion::rotation(centre, axis, 360.0 / steps);
    RigidMotion whole;
    Point x = somewhere;
    for (int i = 0; i < steps; ++i) {
      whole = step * whole;
      x = step(x);
    }
    expect_near(whole(somewhere), somewhere, 1e-12);
    expect_near(x, somewhere, 1e-12);
  }
}

TEST(RigidMotion, StaysOrthogonal) {
  std::mt19937 random(1);
  RigidMotion motion;
  for (int i = 0; i < 10000; ++i) motion = any(random, 180) * motion;
  expect_orthogonal(motion, 1e-14);
}

TEST(RigidMotion, ComposesFromRightToLeft) {
  std::mt19937 random(2);
  const RigidMotion a = any(random, 180), b = any(random, 180);
  expect_near((a * b)(somewhere), a(b(somewhere)), 1e-14);
}

TEST(RigidMotion, InverseUndoes) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion motion = any(random, 180);
    expect_near(motion.inverse() * motion, RigidMotion(), 1e-14);
    expect_near(motion * motion.inverse(), RigidMotion(), 1e-14);
  }
}

TEST(RigidMotion, RotatesTensorsWithSpace) {
  const RigidMotion motion = RigidMotion::rotation(centre, axis, 50) * RigidMotion::translation({1, 2, 3});
  const Tensor m = {2, 0.3, -0.1, 5, 0.7, 9};
  const Vec3 e = {0.2, -0.5, 0.9};
  const Vec3 moved = motion(somewhere + e) - motion(somewhere);
  EXPECT_NEAR(quadratic_form(motion.rotated(m), moved), quadratic_form(m, e), 1e-13);
  EXPECT_NEAR(determinant(motion.rotated(m)), determinant(m), 1e-12);
}

TEST(RigidMotion, SharesAddUp) {
  std::mt19937 random(4);
  // Down to angles whose square is lost in 1: their centre is as far away as they are small.
  for (const double degrees : {0.0, 1e-300, 1e-12, 1e-6, 1.0, 179.0, 180.0}) {
    const RigidMotion motion = any(random, degrees);
    expect_near(motion.share(0), RigidMotion(), 1e-14);
    expect_near(motion.share(1), motion, 1e-14);
    expect_near(motion.share(0.5) * motion.share(0.5), motion, 1e-14);
    expect_near(motion.share(0.3) * motion.share(0.7), motion, 1e-14);
    expect_near(motion.share(-1), motion.inverse(), 1e-14);
    expect_near(motion.share(3), motion * motion * motion, 1e-13);
    RigidMotion sum;
    for (int i = 0; i < 1000; ++i) sum = motion.share(1e-3) * sum;
    expect_near(sum, motion, 1e-12);
  }
}

TEST(RigidMotion, SharesOfARotationTurnAboutTheSameAxis) {
  const RigidMotion rotation = RigidMotion::rotation(centre, axis, 120);
  expect_near(rotation.share(0.25), RigidMotion::rotation(centre, axis, 30), 1e-14);
  expect_near(rotation.share(2), RigidMotion::rotation(centre, axis, 240), 1e-14);
  expect_near(RigidMotion::rotation(centre, axis, 350).share(0.5), RigidMotion::rotation(centre, axis, -5), 1e-14);
  expect_near(RigidMotion::rotation(centre, axis, 180).share(0.5), RigidMotion::rotation(centre, axis, 90), 1e-14);
  EXPECT_EQ(RigidMotion::translation({1, 2, 4}).share(0.25)({0, 0, 0}), (Point{0.25, 0.5, 1}));
}

TEST(RigidMotion, RefusesWhatIsNoMotion) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of([] {
              return RigidMotion::rotation(centre, {0, 0, 0}, 1);
            }),
            "rotation: axis: (0, 0, 0) found, expected a vector of any other length");
  EXPECT_EQ(error_of([] {
              return RigidMotion::translation({0, nan, 0});
            }),
            "translation: (0, nan, 0) found, expected three finite numbers");
  EXPECT_EQ(error_of([] {
              return RigidMotion::rotation({inf, 0, 0}, axis, 1);
            }),
            "rotation: centre: (inf, 0, 0) found, expected three finite numbers");
  EXPECT_EQ(error_of([] {
              return RigidMotion::rotation(centre, {1, 0, nan}, 1);
            }),
            "rotation: axis: (1, 0, nan) found, expected three finite numbers");
  EXPECT_EQ(error_of([] { return RigidMotion::rotation(centre, axis, inf); }),
            "rotation: degrees: inf found, expected a finite number");
  EXPECT_EQ(error_of([] { return RigidMotion().share(nan); }), "share: nan found, expected a finite number");
}

}  // namespace
}  // namespace taut::test
