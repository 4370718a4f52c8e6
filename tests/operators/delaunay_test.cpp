#include "operators/delaunay.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::Random;

Eigen::Matrix3d matrix(const Sym3& m) {
  Eigen::Matrix3d a;
  a << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  return a;
}

// |Op| / r after transforming space by M^(1/2), so that M becomes the identity.
double delta(const Vec3& p, const std::array<Vec3, 4>& k, const Sym3& m) {
  const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix(m)).operatorSqrt();
  const auto at = [&](const Vec3& x) { return Eigen::Vector3d(root * Eigen::Map<const Eigen::Vector3d>(x.data())); };
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d e = at(k[i + 1] - k[0]);
    a.row(i) = 2 * e.transpose();
    b[i] = e.squaredNorm();
  }
  const Eigen::Vector3d centre = a.fullPivLu().solve(b);
  return (at(p - k[0]) - centre).norm() / centre.norm();
}

struct Case {
  Vertex p;
  std::array<Vertex, 4> k;

  [[nodiscard]] bool in_conflict() const { return taut::in_conflict(p, {&k[0], &k[1], &k[2], &k[3]}); }
  [[nodiscard]] double delta_in(const Sym3& m) const { return delta(p.x, {k[0].x, k[1].x, k[2].x, k[3].x}, m); }
  [[nodiscard]] double sum() const {
    double s = delta_in(p.m);
    for (const Vertex& v : k) s += delta_in(v.m);
    return s;
  }
};

Case random_case(Random& random) {
  Case c;
  do {
    for (Vertex& v : c.k) v.x = random.point();
  } while (six_volumes(c.k[0].x, c.k[1].x, c.k[2].x, c.k[3].x) < 0.05);
  c.p.x = 1.3 * random.point();
  return c;
}

void set_metrics(Case& c, const std::function<Sym3()>& metric) {
  c.p.m = metric();
  for (Vertex& v : c.k) v.m = metric();
}

TEST(InConflict, InOneIsotropicMetricIsTheSphereTest) {
  Random random(1);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    Case c = random_case(random);
    const double h = std::exp(random.uniform(-10, 10));
    set_metrics(c, [&] { return metric_of_size(h); });
    const double d = c.delta_in(identity3);
    if (std::abs(d - 1) < 1e-9) continue;
    EXPECT_EQ(c.in_conflict(), d < 1) << d;
    inside += d < 1 ? 1 : 0;
  }
  EXPECT_GT(inside, 300);
  EXPECT_LT(inside, 2700);
}

TEST(InConflict, InOneAnisotropicMetricIsTheEllipsoidTest) {
  Random random(2);
  int differs = 0;
  for (int i = 0; i < 3000; ++i) {
    Case c = random_case(random);
    const Sym3 m = random.metric(0.01);
    set_metrics(c, [&] { return m; });
    const double d = c.delta_in(m);
    if (std::abs(d - 1) < 1e-7) continue;
    EXPECT_EQ(c.in_conflict(), d < 1) << d;
    differs += (d < 1) != (c.delta_in(identity3) < 1) ? 1 : 0;
  }
  EXPECT_GT(differs, 300) << "the metric does not matter";
}

TEST(InConflict, InFiveMetricsIsEquationFour) {
  Random random(3);
  int by_sum = 0, by_point = 0, conflicts = 0;
  for (int i = 0; i < 6000; ++i) {
    Case c = random_case(random);
    set_metrics(c, [&] { return random.metric(i % 2 == 0 ? 0.5 : 0.1); });
    const double d = c.delta_in(c.p.m), sum = c.sum();
    if (std::abs(d - 1) < 1e-7 || std::abs(sum - 5) < 1e-7) continue;
    EXPECT_EQ(c.in_conflict(), d < 1 && sum < 5) << d << " " << sum;
    by_sum += d < 1 && sum > 5 ? 1 : 0;
    by_point += d > 1 && sum < 5 ? 1 : 0;
    conflicts += d < 1 && sum < 5 ? 1 : 0;
  }
  EXPECT_GT(by_sum, 50) << "the second condition was not tested";
  EXPECT_GT(by_point, 50) << "the first condition was not tested";
  EXPECT_GT(conflicts, 300);
}

TEST(InConflict, AtTheCircumcentre) {
  // All deltas are zero up to rounding, whatever sign their squares get.
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    Case c = random_case(random);
    const double r = 0.7;
    c.p.x = random.point();
    do {
      for (Vertex& v : c.k) {
        const Vec3 d = random.rotation()[0];
        v.x = c.p.x + r * d;
      }
    } while (six_volumes(c.k[0].x, c.k[1].x, c.k[2].x, c.k[3].x) < 0.02);
    set_metrics(c, [] { return metric_of_size(0.1); });
    EXPECT_TRUE(c.in_conflict());
  }
}

}  // namespace
}  // namespace taut
