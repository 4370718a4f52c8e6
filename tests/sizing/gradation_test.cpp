#include "sizing/gradation.hpp"

#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "mesh/edges.hpp"
#include "mesh/grid.hpp"
#include "metric/length.hpp"
#include "metric/random_metrics.hpp"

namespace taut {
namespace {

using test::grid;
using test::Random;

struct Setting {
  Mesh mesh;
  std::vector<std::array<Index, 2>> edges;
};

Setting setting(Index n) {
  Setting s{grid(n), {}};
  s.edges = edges_of(s.mesh.tetrahedra);
  return s;
}

void expect_bound_holds(const Setting& s, const std::vector<Sym3>& metrics, double beta) {
  const auto check = [&](Index p, Index q) {
    const double growth = 1 + length_in(metrics[p], s.mesh.points[q] - s.mesh.points[p]) * std::log(beta);
    EXPECT_TRUE(is_dominated(1 / (growth * growth) * metrics[p], metrics[q], 1 + 2e-3)) << p << " to " << q;
  };
  for (const auto& [p, q] : s.edges) check(p, q), check(q, p);
}

TEST(Gradation, KeepsConstantFieldsBitForBit) {
  const Setting s = setting(4);
  Random random(1);
  for (const double smallest : {1.0, 1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 20; ++i) {
      const std::vector<Sym3> constant(s.mesh.points.size(), random.metric(smallest));
      EXPECT_EQ(gradate(s.mesh.points, s.edges, constant, 1.1), constant);
    }
  }
}

TEST(Gradation, BoundsTheGrowthAndOnlyRefines) {
  const Setting s = setting(6);
  Random random(2);
  for (const double beta : {1.1, 1.5, 3.0}) {
    std::vector<Sym3> noise(s.mesh.points.size());
    for (Sym3& m : noise) m = random.metric(0.01);
    const auto smooth = gradate(s.mesh.points, s.edges, noise, beta);
    expect_bound_holds(s, smooth, beta);
    for (std::size_t v = 0; v < noise.size(); ++v) EXPECT_TRUE(is_dominated(noise[v], smooth[v], 1 + 1e-8));
  }
}

TEST(Gradation, OfASmallSizeInALargeField) {
  const Setting s = setting(8);
  std::vector<Sym3> metrics(s.mesh.points.size(), metric_of_size(10));
  metrics[0] = metric_of_size(0.01);
  const double beta = 1.3;
  const auto graded = gradate(s.mesh.points, s.edges, metrics, beta);
  expect_bound_holds(s, graded, beta);
  EXPECT_EQ(graded[0], metrics[0]);
  // For isotropic sizes the rule is h_q <= h_p + |pq| ln beta, a straight line along an axis of the grid.
  for (Index k = 0; k <= 8; ++k) {
    const double h = 1 / std::sqrt(graded[k][0]);
    EXPECT_NEAR(h, 0.01 + k / 8.0 * std::log(beta), 1e-3 * h);
  }
}

TEST(Gradation, IsDoneAfterOnce) {
  const Setting s = setting(5);
  Random random(3);
  std::vector<Sym3> noise(s.mesh.points.size());
  for (Sym3& m : noise) m = random.metric(0.05);
  const auto once = gradate(s.mesh.points, s.edges, noise, 1.4);
  EXPECT_EQ(gradate(s.mesh.points, s.edges, once, 1.4), once);
  EXPECT_EQ(gradate(s.mesh.points, s.edges, noise, 1.4), once);
}

TEST(Gradation, LeavesAFieldWithinTheBoundAlone) {
  const Setting s = setting(6);
  std::vector<Sym3> linear;
  for (const Point& x : s.mesh.points) linear.push_back(metric_of_size(0.1 + 0.2 * x[0]));
  EXPECT_EQ(gradate(s.mesh.points, s.edges, linear, 1.3), linear);
}

TEST(Gradation, IsTheSameOnAnyNumberOfThreads) {
  const Setting s = setting(28);
  Random random(4);
  std::vector<Sym3> noise(s.mesh.points.size());
  for (Sym3& m : noise) m = random.metric(0.1);
  const auto compute = [&] { return gradate(s.mesh.points, s.edges, noise, 1.5); };
  const auto one = test::with_threads(1, compute);
  expect_bound_holds(s, one, 1.5);
  EXPECT_EQ(test::with_threads(3, compute), one);
}

TEST(Gradation, OfNothing) {
  EXPECT_TRUE(gradate({}, {}, {}, 1.5).empty());
}

}  // namespace
}  // namespace taut
