// Smooth functions with their derivatives, and irregular meshes to sample them on.
#pragma once

#include <cmath>
#include <vector>

#include "mesh/shapes.hpp"
#include "metric/random_metrics.hpp"
#include "taut/metric.hpp"

namespace taut::test {

/// A cube of n^3 boxes whose inner points are moved at random.
inline Mesh irregular_cube(Index n, unsigned seed) {
  Mesh mesh = cube(n);
  Random random(seed);
  for (Point& p : mesh.points)
    for (double& x : p)
      if (x != 0 && x != 1) x += 0.2 / n * random.uniform(-1, 1);
  return mesh;
}

template <class Function>
std::vector<double> sampled(const Mesh& mesh, Function&& f) {
  std::vector<double> values;
  for (const Point& p : mesh.points) values.push_back(f(p));
  return values;
}

struct Quadratic {
  static double value(const Point& p) {
    const auto& [x, y, z] = p;
    return 7 + x - 2 * y + 3 * x * x - 2 * x * y + 0.5 * y * y + 4 * y * z - z * z + x * z;
  }
  static constexpr Tensor hessian = {6, -2, 1, 1, 4, -2};
};

struct Wave {
  static double value(const Point& p) { return std::sin(3 * p[0] + 1) * std::sin(3 * p[1]) * std::cos(3 * p[2]); }
  static Tensor hessian(const Point& p) {
    const double sx = std::sin(3 * p[0] + 1), cx = std::cos(3 * p[0] + 1), sy = std::sin(3 * p[1]),
                 cy = std::cos(3 * p[1]), sz = std::sin(3 * p[2]), cz = std::cos(3 * p[2]);
    return {-9 * sx * sy * cz, 9 * cx * cy * cz,  -9 * cx * sy * sz,
            -9 * sx * sy * cz, -9 * sx * cy * sz, -9 * sx * sy * cz};
  }
};

}  // namespace taut::test
