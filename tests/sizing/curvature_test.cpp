#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "mesh/shapes.hpp"
#include "metric/cholesky.hpp"
#include "metric/spectral.hpp"
#include "sizing/curved_meshes.hpp"
#include "taut/adapt.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using test::cylinder;
using test::refusal;
using test::sphere;
using test::torus;

constexpr double deviation = 1e-4;

double chord_of(double radius, double from_circle) {
  return 2 * std::sqrt(from_circle * (2 * radius - from_circle));
}

double size_along(const Tensor& m, const Vec3& e) {
  return norm(e) / std::sqrt(quadratic_form(m, e));
}

/// The smallest and the largest size.
std::array<double, 2> extreme_sizes(const Tensor& m) {
  const Spectrum s = spectrum(m);
  return {1 / std::sqrt(s.values[2]), 1 / std::sqrt(s.values[0])};
}

/// The curvature that asks for this size.
double curvature_of(double size) {
  return 2 * deviation / (size * size / 4 + deviation * deviation);
}

struct Errors {
  double mean = 0, worst = 0;
};

/// Of the larger and the smaller curvature at the points where exact() has values, relative to the largest of all.
template <class Exact>
Errors errors_of(const Mesh& mesh, const Exact& exact) {
  const Tensors metric = curvature_metric(mesh, {.deviation = deviation, .limits = {.hmax = 1e6}});
  Errors errors;
  double count = 0, largest = 0;
  for (std::size_t v = 0; v < metric.size(); ++v) {
    const std::optional<std::array<double, 2>> wanted = exact(mesh.points[v]);
    if (!wanted) continue;
    const auto [smallest_size, largest_size] = extreme_sizes(metric[v]);
    const double error = std::max(std::abs(curvature_of(smallest_size) - (*wanted)[0]),
                                  std::abs(curvature_of(largest_size) - (*wanted)[1]));
    errors = {errors.mean + error, std::max(errors.worst, error)};
    largest = std::max(largest, (*wanted)[0]);
    ++count;
  }
  return {errors.mean / count / largest, errors.worst / largest};
}

using Curvatures = std::optional<std::array<double, 2>>;

Errors errors_on_sphere(Index n) {
  return errors_of(sphere(n, n), [](const Point& p) { return norm(p) > 0.5 ? Curvatures({1, 1}) : std::nullopt; });
}

Errors errors_on_torus(Index n) {
  return errors_of(torus(n, n, 0.4), [](const Point& p) -> Curvatures {
    if (std::abs(test::from_unit_circle(p) - 0.4) > 1e-9) return {};
    const double cosine = (std::hypot(p[0], p[1]) - 1) / 0.4;
    return {{2.5, std::abs(cosine / (1 + 0.4 * cosine))}};
  });
}

TEST(CurvatureMetric, ConvergesOnAnIrregularSphere) {
  const Errors coarse = errors_on_sphere(8), fine = errors_on_sphere(16);
  EXPECT_GT(std::log2(coarse.mean / fine.mean), 3);
  EXPECT_GT(std::log2(coarse.worst / fine.worst), 3);
  EXPECT_LT(fine.worst, 2e-3);
}

TEST(CurvatureMetric, ConvergesOnAnIrregularTorus) {
  const Errors coarse = errors_on_torus(24), fine = errors_on_torus(48);
  EXPECT_GT(std::log2(coarse.mean / fine.mean), 3);
  EXPECT_GT(std::log2(coarse.worst / fine.worst), 2.5);
  EXPECT_LT(fine.worst, 1.5e-2);
}

TEST(CurvatureMetric, IsAlignedWithATorus) {
  const Mesh mesh = torus(32, 3, 0.2);
  const Tensors metric = curvature_metric(mesh, {.deviation = deviation, .limits = {.hmax = 1e6}});
  for (std::size_t v = 0; v < metric.size(); ++v) {
    const auto& [x, y, z] = mesh.points[v];
    if (std::abs(test::from_unit_circle(mesh.points[v]) - 0.2) > 1e-9) continue;
    EXPECT_GT(std::abs(dot(spectrum(metric[v]).vectors[0], {-y, x, 0})) / std::hypot(x, y), 0.99) << v;
  }
}

/// Side, caps, and the rims, which belong to both.
void expect_sizes_of_cylinder(const Mesh& mesh, double tolerance) {
  constexpr double height = 8, hmax = 3, wanted = 0.01;
  const Tensors metric = curvature_metric(mesh, {.deviation = wanted, .limits = {.hmax = hmax}});
  for (std::size_t v = 0; v < metric.size(); ++v) {
    const auto& [x, y, z] = mesh.points[v];
    if (std::hypot(x, y) < 1 - 1e-9) {
      EXPECT_LT(test::distance(metric[v], metric_of_size(hmax)), 1e-9) << v;
      continue;
    }
    EXPECT_NEAR(size_along(metric[v], {-y, x, 0}), chord_of(1, wanted), tolerance) << v;
    EXPECT_NEAR(size_along(metric[v], {x, y, 0}), chord_of(1, wanted), tolerance) << v;
    EXPECT_NEAR(size_along(metric[v], {0, 0, height}), hmax, 0.01) << v;
  }
}

TEST(CurvatureMetric, OfACylinderAsksForNothingAlongIt) {
  expect_sizes_of_cylinder(cylinder(16, 1, 8), 0.01);
}

TEST(CurvatureMetric, OfACylinderIsFoundFromTwoRowsOfPoints) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 8}, {0, 0, 4}};
  constexpr Index n = 24;
  for (Index i = 0; i < n; ++i)
    for (const double z : {0, 8}) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.points.push_back({std::cos(angle), std::sin(angle), z});
    }
  for (Index i = 0; i < n; ++i) {
    const Index a = 3 + 2 * i, b = 3 + 2 * ((i + 1) % n);
    for (const auto& [p, q, r] : {std::array{a, b, b + 1}, {a, b + 1, a + 1}, {0U, b, a}, {1U, a + 1, b + 1}})
      mesh.tetrahedra.push_back({2, p, q, r});
  }
  expect_sizes_of_cylinder(mesh, 0.015);
}

TEST(CurvatureMetric, IsLargestOnPlanes) {
  for (const Mesh& mesh : {test::cube(4), test::l_shape(6), test::cube_with_sheet(4)})
    EXPECT_EQ(curvature_metric(mesh, {.deviation = 1e-9, .limits = {.hmax = 0.5}}),
              Tensors(mesh.points.size(), metric_of_size(0.5)));
}

TEST(CurvatureMetric, DoesNotNeedTriangles) {
  Mesh mesh = sphere(6, 2);
  const Tensors given = curvature_metric(mesh, {.deviation = deviation});
  mesh.triangles.clear();
  const Tensors found = curvature_metric(mesh, {.deviation = deviation});
  for (std::size_t v = 0; v < given.size(); ++v) EXPECT_LT(test::distance(given[v], found[v]), 1e-9) << v;
}

TEST(CurvatureMetric, IsNotPartedByGivenEdgesThatAreNotSharp) {
  Mesh mesh = sphere(6, 3);
  const Tensors plain = curvature_metric(mesh, {.deviation = deviation});
  for (std::size_t t = 0; t < 40; ++t) mesh.edges.push_back({mesh.triangles[t][0], mesh.triangles[t][1]});
  EXPECT_EQ(curvature_metric(mesh, {.deviation = deviation}), plain);
  for (Index e = 0; e < mesh.edges.size(); ++e) mesh.ridges.push_back(e);
  EXPECT_NE(curvature_metric(mesh, {.deviation = deviation}), plain);
}

/// The sphere in two patches: one-sided at their border, and still a sphere.
TEST(CurvatureMetric, IsOneSidedWhereReferencesChange) {
  Mesh mesh = sphere(12, 4);
  for (const auto& t : mesh.triangles) mesh.triangle_refs.push_back(test::centre_of(mesh, t)[0] > 0.3 ? 1 : 2);
  const Tensors metric = curvature_metric(mesh, {.deviation = deviation, .limits = {.hmax = 1e6}});
  for (std::size_t v = 1; v < metric.size(); ++v)
    for (const double size : extreme_sizes(metric[v])) EXPECT_NEAR(size, chord_of(1, deviation), 2e-3) << v;
}

TEST(CurvatureMetric, SeesSurfacesBetweenRegions) {
  Mesh mesh = test::two_regions(16);
  for (Point& p : mesh.points) p[0] += 0.8 * p[0] * (1 - p[0]) * p[2] * (1 - p[2]);
  mesh.triangles.clear();
  mesh.triangle_refs.clear();
  const Tensors metric = curvature_metric(mesh, {.deviation = deviation, .limits = {.hmax = 10}});
  for (std::size_t v = 0; v < metric.size(); ++v) {
    const auto& [x, y, z] = mesh.points[v];
    if (z != 0.5 || std::abs(x - 0.55) > 1e-9 || y < 0.1 || y > 0.9) continue;
    EXPECT_NEAR(size_along(metric[v], {0, 0, 1}), chord_of(2.5, deviation), 1e-3) << v;
    EXPECT_NEAR(size_along(metric[v], {0, 1, 0}), 10, 1e-3) << v;
  }
}

/// Along the tube of radius 0.05 a chord 0.02 from the unit circle would be 0.4 long, and six short edges would do.
TEST(CurvatureMetric, KeepsTrianglesFromTilting) {
  const Mesh mesh = torus(32, 5, 0.05, 0.02);
  const Tensors metric = curvature_metric(mesh, {.deviation = 0.02});
  for (std::size_t v = 0; v < metric.size(); ++v) {
    if (std::abs(test::from_unit_circle(mesh.points[v]) - 0.05) > 1e-9) continue;
    const auto [smallest, largest] = extreme_sizes(metric[v]);
    EXPECT_NEAR(smallest, 0.05, 0.005) << v;  // 60 degrees
    const double cosine = (std::hypot(mesh.points[v][0], mesh.points[v][1]) - 1) / 0.05;
    if (std::abs(cosine) < 0.9) continue;
    EXPECT_NEAR(largest, 1.2 * std::sqrt(0.05 * (1 / std::abs(cosine) + 0.05)), 0.03) << v;
  }
}

TEST(CurvatureMetric, TurnsByNoMoreThanAskedFor) {
  const Mesh mesh = sphere(12, 6);
  for (const double turn : {60.0, 20.0})
    EXPECT_NEAR(extreme_sizes(curvature_metric(mesh, {.deviation = 100, .turn = turn}).back())[0],
                2 * std::sin(turn * std::numbers::pi / 360), 0.01)
        << turn;
}

TEST(CurvatureMetric, TakesShareOfTheDomain) {
  const Mesh mesh = sphere(6, 7);
  Vec3 low = mesh.points[0], high = low;
  for (const Point& p : mesh.points)
    for (std::size_t d = 0; d < 3; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  EXPECT_EQ(curvature_metric(mesh, {.deviation = 0.001, .relative = true}),
            curvature_metric(mesh, {.deviation = 0.001 * norm(high - low)}));
}

TEST(CurvatureMetric, GrowsFromTheSurface) {
  const Mesh mesh = test::ball(test::cube(8));
  CurvatureOptions options{.deviation = 1e-3, .limits = {.hmax = 1}};
  const auto at_centre = [&] { return extreme_sizes(curvature_metric(mesh, options)[mesh.points.size() / 2])[0]; };
  EXPECT_EQ(at_centre(), 1);
  options.limits.gradation = Gradation{.beta = 1.2, .mix = 1};
  EXPECT_NEAR(at_centre(), chord_of(1, 1e-3) + std::log(1.2), 0.05);
}

TEST(CurvatureMetric, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = torus(24, 8, 0.4);
  const CurvatureOptions options{.deviation = deviation, .limits = {.gradation = Gradation{}}};
  const auto on = [&](int threads) {
    return test::with_threads(threads, [&] { return curvature_metric(mesh, options); });
  };
  EXPECT_EQ(on(1), on(3));
}

/// With every facet a patch of its own, the surface can be refined.
TEST(CurvatureMetric, RefinesTheSurfaceAlongIt) {
  const Mesh mesh = test::ball(test::cube(4));
  const CurvatureOptions options{.deviation = 2e-3, .limits = {.gradation = Gradation{}}};
  const AdaptResult fine = adapt(mesh, curvature_metric(mesh, options), {.ridge_angle = 1e-3});
  double sum = 0, count = 0;
  for (const auto& t : fine.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k, ++count) sum += norm(fine.mesh.points[t[k]] - fine.mesh.points[t[(k + 1) % 3]]);
  EXPECT_GT(fine.mesh.triangles.size(), 5 * mesh.triangles.size());
  EXPECT_NEAR(sum / count, chord_of(1, 2e-3), 0.2 * chord_of(1, 2e-3));
}

TEST(CurvatureMetric, RefusesWhatMakesNoSense) {
  Mesh mesh = sphere(3, 9);
  const auto message = [&](const CurvatureOptions& o) { return refusal(1, [&] { return curvature_metric(mesh, o); }); };
  EXPECT_EQ(message({}), "deviation 0 found, expected a number above 0");
  EXPECT_EQ(message({.deviation = -1}), "deviation -1 found, expected a number above 0");
  EXPECT_EQ(message({.deviation = std::nan("")}), "deviation nan found, expected a number above 0");
  EXPECT_EQ(message({.deviation = 1, .turn = 0}), "turn 0 found, expected degrees above 0, at most 90");
  EXPECT_EQ(message({.deviation = 1, .ridge_angle = 180}), "ridge angle 180 found, expected between 0 and 180 degrees");
  EXPECT_EQ(message({.deviation = 1, .limits = {.hmin = 2, .hmax = 1}}).substr(0, 14), "hmin 2, hmax 1");
  mesh.points[2][1] = std::nan("");
  EXPECT_NE(message({.deviation = 1}).find("vertex 3"), std::string::npos);
  mesh.points.clear();
  EXPECT_NE(message({.deviation = 1}), "not refused");
}

}  // namespace
}  // namespace taut
