#include "taut/gradation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "adapt/fields.hpp"
#include "base/with_threads.hpp"
#include "mesh/edges.hpp"
#include "mesh/grid.hpp"
#include "metric/cholesky.hpp"
#include "metric/length.hpp"
#include "metric/random_metrics.hpp"
#include "sizing/gradation.hpp"
#include "sizing/growth.hpp"
#include "taut/error.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

using test::grid;
using test::Random;

constexpr std::array<double, 3> mixes = {0, 0.5, 1};

struct Setting {
  Mesh mesh;
  std::vector<std::array<Index, 2>> edges;
};

Setting setting(Index n) {
  Setting s{grid(n), {}};
  s.edges = edges_of(s.mesh.tetrahedra);
  return s;
}

std::vector<Sym3> graded(const Setting& s, const std::vector<Sym3>& metrics, const Gradation& gradation) {
  return gradate(s.mesh.points, s.edges, metrics, gradation);
}

std::vector<Sym3> noise(const Setting& s, double smallest, unsigned seed) {
  Random random(seed);
  std::vector<Sym3> metrics(s.mesh.points.size());
  for (Sym3& m : metrics) m = random.metric(smallest);
  return metrics;
}

// The definition, word for word.
Sym3 grown(const Sym3& m, const Vec3& e, const Gradation& g) {
  const double l = length_in(m, e), log_beta = std::log(g.beta);
  return map_eigenvalues(m, [&](double lambda) {
    return lambda / std::pow(1 + l * log_beta, 2 * (1 - g.mix)) /
           std::pow(1 + std::sqrt(lambda) * norm(e) * log_beta, 2 * g.mix);
  });
}

void expect_bound_holds(const Setting& s, const std::vector<Sym3>& metrics, const Gradation& gradation) {
  const auto check = [&](Index p, Index q) {
    const Sym3 demand = grown(metrics[p], s.mesh.points[q] - s.mesh.points[p], gradation);
    EXPECT_TRUE(is_dominated(demand, metrics[q], 1 + 1.001e-3)) << p << " to " << q;
  };
  for (const auto& [p, q] : s.edges) check(p, q), check(q, p);
}

TEST(Gradation, KeepsConstantFieldsBitForBit) {
  const Setting s = setting(4);
  Random random(1);
  for (const double smallest : {1.0, 1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 20; ++i) {
      const std::vector<Sym3> constant(s.mesh.points.size(), random.metric(smallest));
      for (const double mix : mixes) EXPECT_EQ(graded(s, constant, {1.1, mix}), constant);
    }
  }
}

TEST(Gradation, BoundsTheGrowthAndOnlyRefines) {
  const Setting s = setting(6);
  const auto rough = noise(s, 0.01, 2);
  for (const double beta : {1.1, 1.5, 3.0}) {
    for (const double mix : {0.0, 0.125, 0.5, 1.0}) {
      const auto smooth = graded(s, rough, {beta, mix});
      expect_bound_holds(s, smooth, {beta, mix});
      for (std::size_t v = 0; v < rough.size(); ++v) EXPECT_TRUE(is_dominated(rough[v], smooth[v], 1 + 1e-8));
    }
  }
}

TEST(Gradation, DemandsAreFiniteIfRoundingMakesAnEigenvalueNegative) {
  const Spectrum s{{-1e-3, 1, 1e13}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (const double mix : mixes)
    for (const double entry : Growth({1.2, mix}).demand(s, {1e4, 0, 0})) EXPECT_TRUE(std::isfinite(entry));
}

TEST(Gradation, OfASmallSizeInALargeField) {
  const Setting s = setting(8);
  std::vector<Sym3> metrics(s.mesh.points.size(), metric_of_size(10));
  metrics[0] = metric_of_size(0.01);
  const double beta = 1.3;
  for (const double mix : mixes) {
    const auto smooth = graded(s, metrics, {beta, mix});
    expect_bound_holds(s, smooth, {beta, mix});
    EXPECT_EQ(smooth[0], metrics[0]);
    // For isotropic sizes the rule is h_q <= h_p + |pq| ln beta, a straight line along an axis of the grid.
    for (Index k = 0; k <= 8; ++k) {
      const double h = 1 / std::sqrt(smooth[k][0]);
      EXPECT_NEAR(h, 0.01 + k / 8.0 * std::log(beta), 1e-3 * h);
    }
  }
}

TEST(Gradation, OfSizesIsTheSameForEveryMix) {
  const Setting s = setting(6);
  Random random(5);
  std::vector<Sym3> sizes;
  for (std::size_t v = 0; v < s.mesh.points.size(); ++v)
    sizes.push_back(metric_of_size(std::exp(random.uniform(-5, 0))));
  const auto in_metric = graded(s, sizes, {1.4, 0});
  for (const double mix : mixes) {
    const auto mixed = graded(s, sizes, {1.4, mix});
    for (std::size_t v = 0; v < sizes.size(); ++v) EXPECT_LT(test::distance(mixed[v], in_metric[v]), 1e-10);
  }
}

TEST(Gradation, IsDoneAfterOnce) {
  const Setting s = setting(5);
  for (const double mix : mixes) {
    const auto once = graded(s, noise(s, 0.05, 3), {1.4, mix});
    EXPECT_EQ(graded(s, once, {1.4, mix}), once);
  }
}

TEST(Gradation, LeavesAFieldWithinTheBoundAlone) {
  const Setting s = setting(6);
  std::vector<Sym3> linear;
  for (const Point& x : s.mesh.points) linear.push_back(metric_of_size(0.1 + 0.2 * x[0]));
  for (const double mix : mixes) EXPECT_EQ(graded(s, linear, {1.3, mix}), linear);
}

TEST(Gradation, IsTheSameOnAnyNumberOfThreads) {
  const Setting s = setting(28);
  const auto rough = noise(s, 0.1, 4);
  const auto compute = [&] { return graded(s, rough, {}); };
  const auto one = test::with_threads(1, compute);
  expect_bound_holds(s, one, {});
  for (const int threads : {2, 3}) EXPECT_EQ(test::with_threads(threads, compute), one);
}

/// The same mesh with vertex v as number `place[v]`.
Setting renumbered(const Setting& s, const std::vector<Index>& place) {
  Setting other = s;
  for (std::size_t v = 0; v < place.size(); ++v) other.mesh.points[place[v]] = s.mesh.points[v];
  for (auto& tet : other.mesh.tetrahedra)
    for (Index& v : tet) v = place[v];
  other.edges = edges_of(other.mesh.tetrahedra);
  return other;
}

TEST(Gradation, DoesNotDependOnTheOrderOfTheVertices) {
  const Setting s = setting(7);
  std::vector<Index> place(s.mesh.points.size());
  std::iota(place.begin(), place.end(), 0U);
  std::shuffle(place.begin(), place.end(), std::mt19937(6));
  const Setting other = renumbered(s, place);
  for (const double mix : mixes) {
    const auto rough = noise(s, 0.02, 7);
    std::vector<Sym3> moved(rough.size());
    for (std::size_t v = 0; v < rough.size(); ++v) moved[place[v]] = rough[v];
    const auto smooth = graded(s, rough, {1.3, mix}), moved_smooth = graded(other, moved, {1.3, mix});
    for (std::size_t v = 0; v < rough.size(); ++v) ASSERT_EQ(moved_smooth[place[v]], smooth[v]);
  }
}

TEST(Gradation, OfAThinShellCostsLittleWithTheMix) {
  Mesh mesh = grid(20);
  for (Point& x : mesh.points) x = 2 * x - Point{1, 1, 1};
  Tensors shell;
  for (const Point& x : mesh.points) shell.push_back(test::shell()(x));
  const double before = measure(mesh, shell).complexity;
  const auto times = [&](double beta, double mix) {
    return measure(mesh, gradate(mesh, shell, {beta, mix})).complexity / before;
  };
  EXPECT_LT(times(1.3, 0.5), 1.6);  // on fine grids 1.5 and 1.1
  EXPECT_LT(times(1.5, 0.5), 1.2);
  EXPECT_LT(times(1.3, 1), 1.2);
  EXPECT_GT(times(1.3, 0), 3);
}

TEST(Gradation, OfAMeshIsThatOfItsEdges) {
  const Setting s = setting(3);
  const auto rough = noise(s, 0.1, 8);
  EXPECT_EQ(gradate(s.mesh, rough), graded(s, rough, {1.5, 0.5}));
}

TEST(Gradation, OfNothing) {
  EXPECT_TRUE(gradate({}, {}, {}, {}).empty());
}

void expect_refused(const Mesh& mesh, const Tensors& metric, const Gradation& gradation, const std::string& words) {
  try {
    (void)gradate(mesh, metric, gradation);
    ADD_FAILURE() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Gradation, RefusesWhatItCannotUse) {
  const Mesh mesh = grid(1);
  const Tensors metric(8, identity3);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double beta : {1.0, nan, infinity}) expect_refused(mesh, metric, {beta, 0.5}, "beta");
  for (const double mix : {-0.1, 1.1, nan}) expect_refused(mesh, metric, {1.5, mix}, "mix");
  expect_refused(mesh, Tensors(7, identity3), {}, "7 values for 8 vertices");
  Tensors indefinite = metric;
  indefinite[4] = {1, 0, 0, -1, 0, 1};
  expect_refused(mesh, indefinite, {}, "vertex 5");
  Mesh broken = mesh;
  broken.tetrahedra[2][1] = 8;
  expect_refused(broken, metric, {}, "tetrahedron 3: vertex 9");
}

}  // namespace
}  // namespace taut
