#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/with_threads.hpp"
#include "levelset/surface_checks.hpp"
#include "taut/levelset.hpp"

namespace taut {
namespace {

constexpr double pi = 3.14159265358979323846;
const Vec3 middle = {0.5, 0.5, 0.5};

double from_middle(const Point& p) {
  return norm(p - middle);
}

Mesh jittered(Index n) {
  Mesh mesh = test::grid(n);
  test::jitter(mesh, 0.2 / n, 1);
  return mesh;
}

double interpolated(const std::vector<double>& values, const EdgePoint& at) {
  return (1 - at.weight) * values[at.first] + at.weight * values[at.second];
}

TEST(Isosurface, OfADistanceIsASphere) {
  const Mesh mesh = jittered(16);
  const auto values = test::values_on(mesh, from_middle);
  const Isosurface found = isosurface(mesh, values, 0.3);
  test::expect_manifold(found.surface);
  EXPECT_EQ(test::euler_characteristic(found.surface), 2);
  const SurfaceMeasures m = measure(found.surface);
  EXPECT_NEAR(m.volume, 4 * pi / 3 * 0.027, 0.03 * 4 * pi / 3 * 0.027);
  EXPECT_NEAR(m.area, 4 * pi * 0.09, 0.03 * 4 * pi * 0.09);
}

TEST(Isosurface, TakesTheValueAtItsPoints) {
  const Mesh mesh = jittered(10);
  const auto values = test::values_on(mesh, from_middle);
  const auto [surface, on_edges] = isosurface(mesh, values, 0.3);
  ASSERT_EQ(on_edges.size(), surface.points.size());
  for (std::size_t i = 0; i < on_edges.size(); ++i) {
    EXPECT_NEAR(interpolated(values, on_edges[i]), 0.3, 1e-15);
    const Vec3 &p = mesh.points[on_edges[i].first], &q = mesh.points[on_edges[i].second];
    EXPECT_LT(norm(p + on_edges[i].weight * (q - p) - surface.points[i]), 1e-15);
    EXPECT_LT(on_edges[i].first, on_edges[i].second);
  }
}

TEST(Isosurface, OfATorus) {
  const Mesh mesh = jittered(20);
  const auto torus = [](const Point& p) {
    const Vec3 d = p - middle;
    return std::hypot(std::hypot(d[0], d[1]) - 0.28, d[2]) - 0.12;
  };
  const SurfaceMesh surface = isosurface(mesh, test::values_on(mesh, torus)).surface;
  test::expect_manifold(surface);
  EXPECT_EQ(test::euler_characteristic(surface), 0);
  EXPECT_NEAR(measure(surface).volume, 2 * pi * pi * 0.28 * 0.0144, 0.05 * 2 * pi * pi * 0.28 * 0.0144);
}

TEST(Isosurface, OfTheNegativeFieldHasTheOppositeNormals) {
  const Mesh mesh = jittered(10);
  const auto negative = test::values_on(mesh, [](const Point& p) { return 0.3 - from_middle(p); });
  const SurfaceMesh surface = isosurface(mesh, negative).surface;
  test::expect_manifold(surface);
  EXPECT_LT(measure(surface).volume, 0);
}

TEST(Isosurface, ThatReachesTheBoundaryIsOpenThereOnly) {
  const Mesh mesh = jittered(6);
  const SurfaceMesh surface = isosurface(mesh, test::values_on(mesh, [](const Point& p) { return p[0]; }), 0.3).surface;
  test::expect_sound(surface);
  EXPECT_NEAR(measure(surface).area, 1, 1e-14);
  for (const auto& [edge, count] : test::edge_counts(surface)) {
    const Vec3 centre = 0.5 * (surface.points[edge[0]] + surface.points[edge[1]]);
    const double inside = std::min(std::min(centre[1], 1 - centre[1]), std::min(centre[2], 1 - centre[2]));
    EXPECT_EQ(count, inside > 1e-14 ? 2 : 1);
  }
}

/// The part of the volume of a tetrahedron where the linear function with these values is negative. (It is a divided
/// difference; values below zero are all different.)
double share_below(const std::array<double, 4>& u) {
  double share = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (u[i] >= 0) continue;
    double term = 1;
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) term *= u[i] / (u[i] - u[j]);
    share += term;
  }
  return share;
}

double volume_below(const Mesh& mesh, const std::vector<double>& values) {
  double sum = 0;
  for (const auto& t : mesh.tetrahedra) {
    const auto x = [&](int k) { return mesh.points[t[k]]; };
    sum += share_below({values[t[0]], values[t[1]], values[t[2]], values[t[3]]}) *
           std::abs(six_volumes(x(0), x(1), x(2), x(3))) / 6;
  }
  return sum;
}

// Random signs make all patterns, faces and whole tetrahedra on the level, and surfaces that touch along edges.
TEST(Isosurface, OfRandomSignsBoundsWhatIsBelow) {
  const Mesh mesh = jittered(8);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> size(0.1, 1);
  for (const int zeros : {0, 1, 4, 12}) {
    std::uniform_int_distribution<int> sign(-1, zeros);
    const auto values = test::values_on(mesh, [&](const Point& p) {
      const bool on_boundary = *std::ranges::min_element(p) == 0 || *std::ranges::max_element(p) == 1;
      const int s = sign(generator);
      return on_boundary || s == 1 ? size(generator) : s == -1 ? -size(generator) : 0.0;
    });
    const SurfaceMesh surface = isosurface(mesh, values).surface;
    test::expect_sound(surface);
    const SurfaceMeasures m = measure(surface);
    EXPECT_EQ(m.open_edges, 0U);
    for (const auto& [edge, count] : test::edge_counts(surface)) EXPECT_EQ(count % 2, 0);
    EXPECT_NEAR(m.volume, volume_below(mesh, values), 1e-12);
  }
}

// The plane x = 1/2 consists of faces of the grid.
TEST(Isosurface, OnFacesOfTheMesh) {
  const Mesh mesh = test::grid(4);
  for (const double sign : {1.0, -1.0}) {
    const auto values = test::values_on(mesh, [&](const Point& p) { return sign * (p[0] - 0.5); });
    const auto [surface, on_edges] = isosurface(mesh, values);
    test::expect_sound(surface);
    EXPECT_EQ(surface.triangles.size(), 32U);
    for (const EdgePoint& at : on_edges) EXPECT_EQ(at.first, at.second);
    for (const auto& [i, j, k] : surface.triangles) {
      const Vec3 &a = surface.points[i], &b = surface.points[j], &c = surface.points[k];
      EXPECT_GT(sign * cross(b - a, c - a)[0], 0);
    }
  }
}

TEST(Isosurface, AtAPlateauIsItsLowerEnd) {
  const Mesh mesh = test::grid(4);
  const auto plateau = [](const Point& p) { return p[0] < 0.5 ? -1.0 : p[0] < 0.8 ? 0.0 : 1.0; };
  const SurfaceMesh surface = isosurface(mesh, test::values_on(mesh, plateau)).surface;
  EXPECT_EQ(surface.triangles.size(), 32U);
  for (const Point& p : surface.points) EXPECT_EQ(p[0], 0.5);
}

TEST(Isosurface, LeavesOutTouchingAndTheBoundary) {
  const Mesh mesh = test::grid(4);
  const auto none_at = [&](const auto& function) {
    return isosurface(mesh, test::values_on(mesh, function)).surface.triangles.empty();
  };
  EXPECT_TRUE(none_at([](const Point& p) { return p[0]; }));
  EXPECT_TRUE(none_at([](const Point& p) { return -p[0]; }));
  EXPECT_TRUE(none_at([](const Point& p) { return -std::abs(p[0] - 0.5); }));
  EXPECT_TRUE(none_at([](const Point& p) { return std::abs(p[0] - 0.5); }));
  EXPECT_TRUE(none_at([](const Point&) { return 0.0; }));
  EXPECT_TRUE(none_at([](const Point&) { return 1.0; }));
}

TEST(Isosurface, DoesNotDependOnTheOrientationOfTetrahedra) {
  Mesh mesh = jittered(8);
  const auto values = test::values_on(mesh, from_middle);
  const double volume = measure(isosurface(mesh, values, 0.3).surface).volume;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); t += 2) std::swap(mesh.tetrahedra[t][1], mesh.tetrahedra[t][2]);
  const SurfaceMesh surface = isosurface(mesh, values, 0.3).surface;
  test::expect_manifold(surface);
  EXPECT_NEAR(measure(surface).volume, volume, 1e-14);
}

TEST(Isosurface, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = jittered(24);
  const auto values = test::values_on(mesh, [](const Point& p) { return std::round(20 * from_middle(p)) - 6; });
  const auto compute = [&] { return isosurface(mesh, values); };
  const Isosurface one = test::with_threads(1, compute);
  EXPECT_GT(one.surface.triangles.size(), 1000U);
  for (const int threads : {2, 3}) {
    const Isosurface other = test::with_threads(threads, compute);
    EXPECT_EQ(one.surface.points, other.surface.points);
    EXPECT_EQ(one.surface.triangles, other.surface.triangles);
  }
}

TEST(Isosurface, RefusesWhatItCannotUse) {
  Mesh mesh = test::grid(2);
  const auto values = test::values_on(mesh, from_middle);
  const auto refusal = [&](const Mesh& m, const std::vector<double>& v, double level = 0.3) {
    return test::refusal(2, [&] { return isosurface(m, v, level); });
  };
  EXPECT_EQ(refusal(mesh, {1, 2}), "field: 2 values found, expected 27, one per vertex");
  auto broken = values;
  broken[4] = std::nan("");
  EXPECT_EQ(refusal(mesh, broken), "field: vertex 5: nan found, expected a finite number");
  EXPECT_EQ(refusal(mesh, values, INFINITY), "level: inf found, expected a finite number");
  mesh.tetrahedra[3][2] = 99;
  EXPECT_EQ(refusal(mesh, values), "tetrahedron 4: vertex 100 found, expected 1..27");
  Mesh flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  flat.tetrahedra = {{0, 1, 2, 3}};
  EXPECT_EQ(refusal(flat, {0, 1, 0, 1}), "tetrahedron 1 (1 2 3 4) is flat: its volume is exactly zero");
}

}  // namespace
}  // namespace taut
