#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/with_threads.hpp"
#include "mesh/grid.hpp"
#include "metric/quality.hpp"
#include "metric/random_metrics.hpp"
#include "taut/error.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

using test::grid;
using test::Random;

Mesh one(const std::array<Point, 4>& points) {
  Mesh mesh;
  mesh.points.assign(points.begin(), points.end());
  mesh.tetrahedra = {{0, 1, 2, 3}};
  return mesh;
}

const Mesh regular = one({{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}});
const Mesh corner = one({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});

TEST(Measure, TheRegularTetrahedronIsPerfect) {
  const Quality q = measure(regular, Sizes(4, std::sqrt(8.0)));
  EXPECT_EQ(q.vertices, 4);
  EXPECT_EQ(q.edges, 6);
  EXPECT_EQ(q.triangles, 0);
  EXPECT_EQ(q.tetrahedra, 1);
  EXPECT_NEAR(q.volume, 8.0 / 3, 1e-14);
  EXPECT_NEAR(q.complexity, 8.0 / 3 / std::pow(8, 1.5), 1e-14);
  for (const double x : {q.tau, q.unit_edges, q.length_min, q.length_max, q.Q_max, q.Q_mean, q.Q_up_to_2, q.Q_up_to_3,
                         q.mean_ratio_min, q.mean_ratio_mean})
    EXPECT_NEAR(x, 1, 1e-14);
}

TEST(Measure, ByHandInVaryingSizes) {
  // Size 1 at the origin and 1/2 elsewhere: three edges of length 1/log 2, three of 2 sqrt 2.
  const Quality q = measure(corner, Sizes{1, 0.5, 0.5, 0.5});
  const double shorter = 1 / std::log(2.0), longer = 2 * std::sqrt(2.0);
  EXPECT_NEAR(q.length_min, shorter, 1e-14);
  EXPECT_NEAR(q.length_max, longer, 1e-14);
  EXPECT_NEAR(q.tau, std::exp((1 / shorter + 1 / longer) / 2 - 1), 1e-14);
  EXPECT_EQ(q.unit_edges, 0);
  EXPECT_EQ(q.length_histogram, (std::array<std::size_t, 9>{0, 0, 0, 0, 0, 0, 3, 3, 0}));
  const double Q = 27 / (12 * std::sqrt(3.0));
  EXPECT_NEAR(q.Q_max, Q, 1e-14);
  EXPECT_NEAR(q.mean_ratio_min, std::pow(Q, -2.0 / 3), 1e-14);
  EXPECT_EQ(q.Q_histogram, (std::array<std::size_t, 7>{0, 1, 0, 0, 0, 0, 0}));
  EXPECT_NEAR(q.complexity, (1 + 3 * 8) / 4.0 / 6, 1e-14);
}

TEST(Measure, OfAGrid) {
  const Quality q = measure(grid(4), MetricFunction([](const Point&) { return metric_of_size(0.25); }));
  EXPECT_EQ(q.tetrahedra, 6 * 64);
  EXPECT_NEAR(q.volume, 1, 1e-13);
  EXPECT_NEAR(q.complexity, 64, 1e-11);
  EXPECT_NEAR(q.length_min, 1, 1e-13);
  EXPECT_NEAR(q.length_max, std::sqrt(3.0), 1e-13);
  EXPECT_EQ(std::accumulate(q.length_histogram.begin(), q.length_histogram.end(), std::size_t{0}), q.edges);
  EXPECT_EQ(std::accumulate(q.Q_histogram.begin(), q.Q_histogram.end(), std::size_t{0}), q.tetrahedra);
}

TEST(Measure, AllWaysOfGivingAMetricAgree) {
  const Mesh mesh = grid(3);
  const auto size = [](const Point& x) { return 0.2 + 0.1 * x[0] + 0.3 * x[2]; };
  Sizes sizes;
  Tensors tensors;
  for (const Point& x : mesh.points) sizes.push_back(size(x)), tensors.push_back(metric_of_size(size(x)));
  const double tau = measure(mesh, sizes).tau;
  EXPECT_EQ(measure(mesh, tensors).tau, tau);
  EXPECT_EQ(measure(mesh, [&](const Point& x) { return metric_of_size(size(x)); }).tau, tau);
}

TEST(Measure, TurnsWithMeshAndMetric) {
  Random random(1);
  Mesh mesh = grid(3), turned = mesh;
  const auto r = random.rotation();
  Tensors metric, turned_metric;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    turned.points[v] = test::rotate(r, mesh.points[v]);
    metric.push_back(random.metric(0.05));
    turned_metric.push_back(test::rotate(r, metric.back()));
  }
  const Quality a = measure(mesh, metric), b = measure(turned, turned_metric);
  EXPECT_NEAR(a.tau, b.tau, 1e-11);
  EXPECT_NEAR(a.complexity / b.complexity, 1, 1e-11);
  EXPECT_NEAR(a.Q_mean / b.Q_mean, 1, 1e-9);
  EXPECT_NEAR(a.mean_ratio_mean, b.mean_ratio_mean, 1e-11);
}

TEST(Measure, IsTheSameOnAnyNumberOfThreads) {
  Random random(2);
  const Mesh mesh = grid(28);
  Tensors metric;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) metric.push_back(random.metric(0.05));
  const auto compute = [&] { return measure(mesh, metric); };
  const Quality one = test::with_threads(1, compute), three = test::with_threads(3, compute);
  EXPECT_EQ(one.tau, three.tau);
  EXPECT_EQ(one.complexity, three.complexity);
  EXPECT_EQ(one.volume, three.volume);
  EXPECT_EQ(one.Q_mean, three.Q_mean);
  EXPECT_EQ(one.mean_ratio_mean, three.mean_ratio_mean);
  EXPECT_EQ(one.length_histogram, three.length_histogram);
  EXPECT_EQ(one.Q_histogram, three.Q_histogram);
}

TEST(Measure, RefusesTheFirstOfSeveralOnAnyNumberOfThreads) {
  Mesh mesh = grid(28);
  Sizes sizes(mesh.points.size(), 1.0);
  sizes[17000] = sizes[23000] = -1;
  const auto compute = [&] { return measure(mesh, sizes); };
  for (const int threads : {1, 3})
    EXPECT_EQ(test::refusal(threads, compute), "metric: vertex 17001: size -1 found, expected a positive number");
  mesh.tetrahedra[20000][3] = mesh.tetrahedra[130000][3] = 99999;
  for (const int threads : {1, 3})
    EXPECT_EQ(test::refusal(threads, compute), "mesh: tetrahedron 20001: vertex 100000 found, expected 1..24389");
}

TEST(Measure, FlatElementsAreInfinitelyBad) {
  const Quality q = measure(one({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}), Sizes(4, 1.0));
  EXPECT_TRUE(std::isinf(q.Q_max));
  EXPECT_EQ(q.mean_ratio_min, 0);
  EXPECT_EQ(q.Q_histogram.back(), 1);
}

TEST(Measure, OfAnEmptyMesh) {
  const Quality q = measure(Mesh{}, Sizes{});
  EXPECT_EQ(q.edges, 0);
  EXPECT_EQ(q.tau, 0);
}

TEST(Measure, RefusesWhatDoesNotFit) {
  EXPECT_THROW((void)measure(corner, Sizes(3, 1.0)), InputError);
  EXPECT_THROW((void)measure(corner, Sizes{1, 1, 1, -1}), InputError);
  Mesh broken = corner;
  broken.tetrahedra[0][2] = 4;
  EXPECT_THROW((void)measure(broken, Sizes(4, 1.0)), InputError);
}

// As the benchmarks of the Unstructured Grid Adaptation Working Group define it.
TEST(Measure, TakesTheMeanRatioInTheFinestMetric) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  const Sym3 fine = {100, 0, 0, 1, 0, 1};
  const auto& p = mesh.points;
  for (std::size_t at = 0; at < 4; ++at) {
    Tensors metric(4, identity3);
    metric[at] = fine;
    EXPECT_DOUBLE_EQ(measure(mesh, metric).mean_ratio_min, mean_ratio(p[0], p[1], p[2], p[3], fine));
  }
}

}  // namespace
}  // namespace taut
