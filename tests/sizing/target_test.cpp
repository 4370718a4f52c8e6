#include "sizing/target.hpp"

#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "mesh/build.hpp"
#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::distance;
using test::Random;

/// exp(A + x B + y C + z D), which a log-Euclidean field reproduces.
struct LogLinear {
  Sym3 a, b, c, d;

  explicit LogLinear(Random& random) {
    for (Sym3* m : {&a, &b, &c, &d})
      for (double& entry : *m) entry = random.uniform(-1, 1);
  }
  Sym3 operator()(const Vec3& x) const { return exp_metric(a + x[0] * b + x[1] * c + x[2] * d); }
};

TetMesh with_metric(const Mesh& input, const MetricFunction& field) {
  TetMesh mesh = build(input).mesh;
  for (Vertex& v : mesh.vertices) v.m = field(v.x);
  return mesh;
}

/// The target that the metrics of a mesh are.
class Field {
public:
  explicit Field(const TetMesh& mesh)
      : background_(std::make_unique<Background>(mesh)), target_(*background_, metrics_of(mesh)) {}

  [[nodiscard]] Sym3 at(const Vec3& x, CellId& host) const { return target_.at(x, host); }

private:
  static std::vector<Sym3> metrics_of(const TetMesh& mesh) {
    std::vector<Sym3> metrics;
    for (const Vertex& v : mesh.vertices) metrics.push_back(v.m);
    return metrics;
  }

  std::unique_ptr<const Background> background_;
  Target target_;
};

Vec3 point_in(const TetMesh& mesh, TetId t, Random& random) {
  double w[4], sum = 0;
  for (double& x : w) sum += x = random.uniform(0, 1);
  Vec3 p{};
  for (int k = 0; k < 4; ++k) p = p + (w[k] / sum) * mesh.x(mesh.tets[t].v[k]);
  return p;
}

bool contains(const TetMesh& mesh, TetId t, const Vec3& x) {
  for (int f = 0; f < 4; ++f) {
    const auto v = mesh.face(t, f);
    if (six_volumes(mesh.x(v[0]), mesh.x(v[1]), mesh.x(v[2]), x) > 1e-12) return false;
  }
  return true;
}

Mesh disturbed(Mesh mesh) {
  test::jitter(mesh, 0.03, 1);
  return mesh;
}

TEST(Target, ReproducesConstantFieldsEverywhere) {
  Random random(1);
  for (const double smallest : {1.0, 1e-2, 1e-4}) {
    const Sym3 m = random.metric(smallest);
    const TetMesh mesh = with_metric(disturbed(test::cube(4)), [&](const Point&) { return m; });
    const Field target(mesh);
    CellId host{0};
    for (int i = 0; i < 200; ++i) EXPECT_LT(distance(target.at(1.5 * random.point(), host), m), 1e-12);
  }
}

TEST(Target, ReproducesFieldsThatAreLinearInTheLogarithm) {
  Random random(2);
  for (const Mesh& input : {test::cube(5), test::two_regions(4), test::ball(test::cube(4))}) {
    const LogLinear field(random);
    const TetMesh mesh = with_metric(disturbed(input), field);
    const Field target(mesh);
    CellId host{0};  // the place of the last point, anywhere in these domains, which are convex
    for (int i = 0; i < 500; ++i) {
      const Vec3 x =
          point_in(mesh, static_cast<TetId>(random.uniform(0, static_cast<double>(mesh.tets.size()))), random);
      EXPECT_LT(distance(target.at(x, host), field(x)), 1e-11);
      EXPECT_TRUE(contains(mesh, static_cast<TetId>(host), x));
    }
  }
}

TEST(Target, FindsVerticesAndPointsOnTheBoundary) {
  Random random(3);
  const LogLinear field(random);
  const TetMesh mesh = with_metric(test::cube(4), field);
  const Field target(mesh);
  CellId host{0};
  for (const Vertex& v : mesh.vertices) EXPECT_LT(distance(target.at(v.x, host), v.m), 1e-12);
  for (int i = 0; i < 200; ++i) {
    Vec3 x = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    x[i % 3] = i % 2;
    EXPECT_LT(distance(target.at(x, host), field(x)), 1e-12);
  }
}

TEST(Target, JustOutsideIsAsOnTheBoundary) {
  Random random(4);
  const LogLinear field(random);
  const TetMesh mesh = with_metric(test::cube(4), field);
  const Field target(mesh);
  for (const double beyond : {1e-15, 1e-10, 1e-6, 1e-3}) {
    CellId host{0};
    for (int i = 0; i < 200; ++i) {
      Vec3 x = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      x[i % 3] = i % 2 == 0 ? -beyond : 1 + beyond;
      EXPECT_LT(distance(target.at(x, host), field(x)), 40 * beyond + 1e-12) << beyond;
    }
  }
}

// From anywhere to anywhere, on domains where a straight path may leave the domain.
class TargetOnDomains : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(NotConvex, TargetOnDomains, testing::Range(0, 2));

TEST_P(TargetOnDomains, FindsItsWay) {
  Random random(5);
  const LogLinear field(random);
  const Mesh horseshoe =
      test::restricted(test::grid(4), [](const Vec3& c) { return std::abs(c[0] - 0.5) > 0.25 || c[1] < 0.25; });
  const TetMesh mesh = with_metric(GetParam() == 0 ? disturbed(test::l_shape(4)) : horseshoe, field);
  const Field target(mesh);
  for (int i = 0; i < 300; ++i) {
    const auto from = static_cast<TetId>(random.uniform(0, static_cast<double>(mesh.tets.size())));
    const auto to = static_cast<TetId>(random.uniform(0, static_cast<double>(mesh.tets.size())));
    const Vec3 x = point_in(mesh, to, random);
    auto host = static_cast<CellId>(from);
    EXPECT_LT(distance(target.at(x, host), field(x)), 1e-11) << "from " << from << " to " << to;
    EXPECT_TRUE(contains(mesh, static_cast<TetId>(host), x));
  }
}

TEST(Target, IsTheSameOnAnyNumberOfThreads) {
  Random random(7);
  const LogLinear field(random);
  const TetMesh mesh = with_metric(test::grid(28), field);
  const Field one = test::with_threads(1, [&] { return Field(mesh); });
  const Field three = test::with_threads(3, [&] { return Field(mesh); });
  CellId host{0}, other_host{0};
  for (int i = 0; i < 300; ++i) {
    const Vec3 x = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    EXPECT_EQ(one.at(x, host), three.at(x, other_host));
    EXPECT_EQ(host, other_host);
  }
}

TEST(Target, OfAFunctionIsTheFunctionWithinBounds) {
  Random random(6);
  const LogLinear field(random);
  const Target free([&](const Point& x) { return field(x); }, Limits{});
  const Target bounded([&](const Point& x) { return field(x); }, Limits{.hmin = 0.9, .hmax = 1.1});
  CellId host{7};
  for (int i = 0; i < 100; ++i) {
    const Vec3 x = random.point();
    EXPECT_EQ(free.at(x, host), field(x));
    const Spectrum s = spectrum(bounded.at(x, host));
    EXPECT_GE(s.values[0], 1 / 1.21 - 1e-12);
    EXPECT_LE(s.values[2], 1 / 0.81 + 1e-12);
  }
}

}  // namespace
}  // namespace taut
