#include <gtest/gtest.h>

#include "locate/closest_on_triangle.hpp"
#include "metric/random_metrics.hpp"
#include "surface/closest_on_cubic.hpp"
#include "surface/handles.hpp"

namespace taut {
namespace {

using test::Random;

Vec3 random_place(Random& random, double half) {
  return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

/// A triangle with edges of about unit length, bent by up to `bend`.
CubicTriangle random_patch(Random& random, double bend) {
  const std::array<Vec3, 3> corner = {Vec3{0, 0, 0}, Vec3{1, 0.1, 0}, Vec3{0.4, 0.9, 0.1}};
  std::array<std::array<Vec3, 2>, 3> handle;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i) {
      const double share = (1.0 + static_cast<double>(i)) / 3;
      handle[k][i] = (1 - share) * corner[k] + share * corner[(k + 1) % 3] + random_place(random, bend);
    }
  return with_centre(corner, handle);
}

std::array<double, 3> random_weights(Random& random) {
  double u = random.uniform(0, 1), v = random.uniform(0, 1);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

TEST(CubicTriangle, HasTheDerivativesOfFiniteDifferences) {
  Random random(1);
  constexpr double h = 1e-4;
  for (int i = 0; i < 50; ++i) {
    const CubicTriangle t = random_patch(random, 0.2);
    const auto at = [&](double u, double v) { return evaluate(t, {1 - u - v, u, v}); };
    const auto w = random_weights(random);
    const double u = w[1], v = w[2];
    const SurfacePoint s = at(u, v);
    EXPECT_LT(norm(1 / (2 * h) * (at(u + h, v).x - at(u - h, v).x) - s.u), 1e-7);
    EXPECT_LT(norm(1 / (2 * h) * (at(u, v + h).x - at(u, v - h).x) - s.v), 1e-7);
    EXPECT_LT(norm(1 / (2 * h) * (at(u + h, v).u - at(u - h, v).u) - s.uu), 1e-7);
    EXPECT_LT(norm(1 / (2 * h) * (at(u, v + h).u - at(u, v - h).u) - s.uv), 1e-7);
    EXPECT_LT(norm(1 / (2 * h) * (at(u, v + h).v - at(u, v - h).v) - s.vv), 1e-7);
  }
}

TEST(CubicTriangle, IsNowhereFartherThanItsBound) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const CubicTriangle t = random_patch(random, 0.1);
    const double bound = deviation_bound(t);
    double farthest = 0;
    for (int k = 0; k < 500; ++k) {
      const Vec3 x = evaluate(t, random_weights(random)).x;
      farthest = std::max(farthest, std::sqrt(closest_on_triangle(x, t.corner).squared_distance));
    }
    EXPECT_LE(farthest, bound);
    EXPECT_LT(bound, 2.5 * farthest);
  }
}

TEST(CubicTriangle, IsFlatIfItsEdgesAreStraight) {
  Random random(3);
  const CubicTriangle t = random_patch(random, 0);
  EXPECT_LT(deviation_bound(t), 1e-15);
  for (int i = 0; i < 20; ++i) {
    const auto w = random_weights(random);
    EXPECT_LT(norm(evaluate(t, w).x - (w[0] * t.corner[0] + w[1] * t.corner[1] + w[2] * t.corner[2])), 1e-15);
  }
}

/// The best that cubic curves can do: an error of the sixth order.
TEST(Handles, FollowCircles) {
  for (const double turn : {0.1, 0.5, 1.0}) {
    const Vec3 a = {1, 0, 0}, b = {std::cos(turn), std::sin(turn), 0}, e = b - a;
    const CubicSegment curve = {a, a + handle_along(e, projected_chord(e, a)),
                                b - handle_along(e, projected_chord(e, b)), b};
    for (int i = 0; i <= 20; ++i) EXPECT_NEAR(norm(evaluate(curve, i / 20.0).x), 1, 1e-4 * std::pow(turn, 6));
  }
}

TEST(CubicSegment, HasTheDerivativesOfFiniteDifferences) {
  Random random(4);
  constexpr double h = 1e-4;
  for (int i = 0; i < 20; ++i) {
    CubicSegment b;
    for (Vec3& x : b) x = random_place(random, 1);
    const double s = random.uniform(0, 1);
    const CurvePoint c = evaluate(b, s), above = evaluate(b, s + h), below = evaluate(b, s - h);
    EXPECT_LT(norm(1 / (2 * h) * (above.x - below.x) - c.first), 1e-6);
    EXPECT_LT(norm(1 / (2 * h) * (above.first - below.first) - c.second), 1e-6);
  }
}

TEST(ClosestOnCubic, NothingOnTheTriangleIsCloser) {
  Random random(5);
  constexpr int n = 40;
  for (int i = 0; i < 300; ++i) {
    const CubicTriangle t = random_patch(random, 0.05);
    const Vec3 x = Vec3{0.5, 0.4, 0} + random_place(random, 0.8);
    const OnCubicTriangle at = closest_on(t, x, closest_on_triangle(x, t.corner).weights);
    EXPECT_LT(norm(evaluate(t, at.weights).x - at.point), 1e-14);
    EXPECT_NEAR(at.weights[0] + at.weights[1] + at.weights[2], 1, 1e-14);
    for (const double w : at.weights) EXPECT_GE(w, 0);
    for (int p = 0; p <= n; ++p)
      for (int q = 0; p + q <= n; ++q) {
        const double u = 1.0 * p / n, v = 1.0 * q / n;
        EXPECT_LE(std::sqrt(at.squared_distance), norm(evaluate(t, {1 - u - v, u, v}).x - x) + 1e-12);
      }
  }
}

TEST(ClosestOnCubic, FindsThePlaceItself) {
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const CubicTriangle t = random_patch(random, 0.05);
    const Vec3 x = evaluate(t, random_weights(random)).x;
    const OnCubicTriangle at = closest_on(t, x, closest_on_triangle(x, t.corner).weights);
    EXPECT_LT(at.squared_distance, 1e-26);
    EXPECT_LE(at.iterations, 6);
  }
}

TEST(ClosestOnCubic, NothingOnTheCurveIsCloser) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const CubicSegment b = {Vec3{0, 0, 0}, Vec3{0.3, 0.1, 0} + random_place(random, 0.05),
                            Vec3{0.7, 0.1, 0} + random_place(random, 0.05), Vec3{1, 0, 0}};
    const Vec3 x = Vec3{0.5, 0, 0} + random_place(random, 0.9);
    const OnCubicSegment at = closest_on(b, x, std::clamp(x[0], 0.0, 1.0));
    for (int k = 0; k <= 200; ++k)
      EXPECT_LE(std::sqrt(at.squared_distance), norm(evaluate(b, k / 200.0).x - x) + 1e-12);
  }
}

}  // namespace
}  // namespace taut
