// Irregular triangulations of surfaces that are known by a formula.
#pragma once

#include <functional>
#include <numbers>

#include "base/vec3.hpp"
#include "metric/random_metrics.hpp"
#include "taut/mesh.hpp"

namespace taut::test {

/// A grid of cells over the unit square, mapped by `f`; its sides u = 0 and u = 1, or v = 0 and v = 1, may be one.
struct Sheet {
  Index nu = 1, nv = 1;
  bool is_closed_in_u = false, is_closed_in_v = false;
  double jitter = 0.2;  ///< of vertices, as a share of a cell, not across a border or a line of `fixed_u`
  Index fixed_u = 0;    ///< a line of the grid on which vertices stay, besides those on borders
  unsigned seed = 1;
};

/// Diagonals are chosen at random. Normals point to d/du x d/dv.
inline Mesh sheet(const Sheet& s, const std::function<Vec3(double, double)>& f) {
  Random random(s.seed);
  Mesh mesh;
  const Index columns = s.is_closed_in_u ? s.nu : s.nu + 1, rows = s.is_closed_in_v ? s.nv : s.nv + 1;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const bool stays_in_u = !s.is_closed_in_u && (i == 0 || i == s.nu || i == s.fixed_u);
      const bool stays_in_v = !s.is_closed_in_v && (j == 0 || j == s.nv);
      const double du = stays_in_u ? 0 : s.jitter * random.uniform(-1, 1);
      const double dv = stays_in_v ? 0 : s.jitter * random.uniform(-1, 1);
      mesh.points.push_back(f((i + du) / s.nu, (j + dv) / s.nv));
    }
  const auto at = [&](Index i, Index j) { return (j % rows) * columns + i % columns; };
  for (Index j = 0; j < s.nv; ++j)
    for (Index i = 0; i < s.nu; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (random.uniform(0, 1) < 0.5) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  return mesh;
}

/// A tube of radius 0.35 around the unit circle.
inline Mesh tube(Index around, Index across) {
  return sheet({.nu = around, .nv = across, .is_closed_in_u = true, .is_closed_in_v = true}, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v, r = 1 + 0.35 * std::cos(b);
    return Vec3{r * std::cos(a), r * std::sin(a), 0.35 * std::sin(b)};
  });
}

/// Two planes that meet in the line x = 1/2 at an angle, in degrees.
inline Mesh roof(Index n, double angle) {
  const double slope = std::tan(angle / 2 * std::numbers::pi / 180);
  return sheet({.nu = n, .nv = n, .fixed_u = n / 2}, [slope](double u, double v) {
    return Vec3{u, v, -slope * std::abs(u - 0.5)};
  });
}

/// A cap of the unit sphere on one of the sphere reflected at z = 0: they meet in a circle at an angle, in degrees.
inline Mesh lens(Index n, double angle) {
  const double half = (90 - angle / 2) * std::numbers::pi / 180, depth = std::cos(half);
  return sheet({.nu = n, .nv = 4 * n, .is_closed_in_v = true, .fixed_u = n / 2}, [=](double u, double v) {
    const double side = u < 0.5 ? 1 : -1, from_pole = half * (0.2 + 0.8 * (1 - 2 * std::abs(u - 0.5)));
    const double a = 2 * std::numbers::pi * v, r = std::sin(from_pole);
    return Vec3{r * std::cos(a), r * std::sin(a), side * (std::cos(from_pole) - depth)};
  });
}

/// The side of a cone of this height over the unit circle: rings of points, in the k-th of them `sides` k, around
/// the apex, which is point 0.
inline Mesh cone(Index rings, double height, unsigned seed = 3, Index sides = 5) {
  Random random(seed);
  Mesh mesh;
  mesh.points = {{0, 0, height}};
  std::vector<Index> first = {0};  // of each ring
  std::vector<std::vector<double>> turns = {{0}};
  for (Index k = 1; k <= rings; ++k) {
    first.push_back(static_cast<Index>(mesh.points.size()));
    turns.emplace_back();
    const double r = (k + (k < rings ? 0.1 * random.uniform(-1, 1) : 0)) / rings;
    for (Index i = 0; i < sides * k; ++i) {
      turns[k].push_back((i + 0.2 * random.uniform(-1, 1)) / (sides * k));
      const double a = 2 * std::numbers::pi * turns[k][i];
      mesh.points.push_back({r * std::cos(a), r * std::sin(a), height * (1 - r)});
    }
  }
  for (Index i = 0; i < sides; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
  for (Index k = 1; k < rings; ++k) {
    const Index inner = sides * k, outer = sides * (k + 1);
    const auto turn = [&](Index ring, Index count, Index i) { return turns[ring][i % count] + i / count; };
    for (Index i = 0, o = 0; i < inner || o < outer;) {
      const Index a = first[k] + i % inner, b = first[k + 1] + o % outer;
      if (o < outer && (i == inner || turn(k + 1, outer, o + 1) <= turn(k, inner, i + 1)))
        mesh.triangles.push_back({a, b, first[k + 1] + ++o % outer});
      else
        mesh.triangles.push_back({a, b, first[k] + ++i % inner});
    }
  }
  return mesh;
}

}  // namespace taut::test
