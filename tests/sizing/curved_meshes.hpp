// Irregular meshes of curved bodies whose curvatures are known.
#pragma once

#include <functional>
#include <map>
#include <numbers>

#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"

namespace taut::test {

/// The surface of a cube of n^3 boxes, its vertices moved at random within the sides and mapped by `f`, and a
/// tetrahedron from each triangle to the image of the centre, which is point 0.
inline Mesh star(Index n, unsigned seed, const std::function<Vec3(const Vec3&)>& f) {
  const Mesh box = cube(n);
  Random random(seed);
  std::map<Index, Index> renumber;
  Mesh mesh;
  mesh.points = {f({0.5, 0.5, 0.5})};
  for (auto triangle : box.triangles) {
    for (Index& v : triangle) {
      const auto [at, is_new] = renumber.try_emplace(v, static_cast<Index>(mesh.points.size()));
      if (is_new) {
        Vec3 p = box.points[v];
        for (double& x : p)
          if (x != 0 && x != 1) x += 0.2 / n * random.uniform(-1, 1);
        mesh.points.push_back(f(p));
      }
      v = at->second;
    }
    mesh.triangles.push_back(triangle);
    mesh.tetrahedra.push_back({0, triangle[0], triangle[1], triangle[2]});
  }
  return mesh;
}

/// The unit sphere.
inline Mesh sphere(Index n, unsigned seed) {
  return star(n, seed, [](const Vec3& p) {
    Mesh one;
    one.points = {p};
    return ball(std::move(one)).points[0];
  });
}

/// Of radius 1 around the z axis, with flat caps at z = 0 and z = height.
inline Mesh cylinder(Index n, unsigned seed, double height) {
  return star(n, seed, [height](const Vec3& p) {
    const double x = 2 * p[0] - 1, y = 2 * p[1] - 1;
    return Vec3{x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2), height * p[2]};
  });
}

/// A pipe between tubes of the given radius and half of it around the unit circle, with n vertices around either, moved
/// by up to `jitter` of their distance.
inline Mesh torus(Index n, unsigned seed, double radius, double jitter = 0.2) {
  const Mesh box = grid(n);
  Random random(seed);
  std::map<std::array<Index, 2>, std::array<double, 2>> angles;
  std::map<std::array<Index, 3>, Index> welded;
  std::vector<Index> renumber;
  Mesh mesh;
  const auto step = [n](double x) { return static_cast<Index>(std::lround(x * n)); };
  for (const Point& p : box.points) {
    const std::array<Index, 2> column = {step(p[0]) % n, step(p[1]) % n};
    const auto angle = [&](double x) { return 2 * std::numbers::pi * (x + jitter / n * random.uniform(-1, 1)); };
    const auto [u, v] = angles.try_emplace(column, std::array{angle(p[0]), angle(p[1])}).first->second;
    const auto [at, is_new] =
        welded.try_emplace({column[0], column[1], step(p[2])}, static_cast<Index>(mesh.points.size()));
    renumber.push_back(at->second);
    const double r = radius * (1 + p[2]) / 2, from_axis = 1 + r * std::cos(v);
    if (is_new) mesh.points.push_back({from_axis * std::cos(u), from_axis * std::sin(u), r * std::sin(v)});
  }
  for (auto tet : box.tetrahedra) {
    for (Index& v : tet) v = renumber[v];
    mesh.tetrahedra.push_back(tet);
  }
  return mesh;
}

/// Distance from the circle around which the tube of a torus runs.
inline double from_unit_circle(const Point& p) {
  return std::hypot(std::hypot(p[0], p[1]) - 1, p[2]);
}

}  // namespace taut::test
