// Pairs of meshes of one domain, and fields on them.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "adapt/fields.hpp"
#include "mesh/shapes.hpp"
#include "taut/adapt.hpp"
#include "taut/transfer.hpp"

namespace taut::test {

/// Moves the points inside by up to `amount` in each direction. The mesh gets its triangles.
inline Mesh shaken(Mesh mesh, double amount, unsigned seed) {
  if (mesh.triangles.empty()) add_triangles(mesh);
  std::set<Index> fixed;
  for (const auto& t : mesh.triangles) fixed.insert(t.begin(), t.end());
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Index p = 0; p < mesh.points.size(); ++p)
    if (!fixed.contains(p))
      for (double& x : mesh.points[p]) x += shift(generator);
  return mesh;
}

/// n^3 boxes of a cube whose points inside are moved.
inline Mesh shaken_cube(Index n, unsigned seed) {
  return shaken(cube(n), 0.2 / n, seed);
}

/// A cube with tetrahedra up to 50 times longer than thick, around a sphere of the given radius.
inline Mesh stretched_cube(double radius) {
  return adapt(cube(6), front(0.3, radius), {.max_rounds = 6}).mesh;
}

/// Three arms of a U, n a multiple of 8; the slot is an eighth wide.
inline Mesh u_shape(Index n) {
  return restricted(grid(n), [](const Vec3& c) { return c[0] < 0.5 || c[0] > 0.625 || c[1] < 0.25; });
}

/// Two slabs with a gap between them, n a multiple of 8.
inline Mesh two_slabs(Index n) {
  return restricted(grid(n), [](const Vec3& c) { return c[0] < 0.375 || c[0] > 0.5; });
}

/// Two meshes of one domain. They are made when needed, because every test runs in a process of its own.
struct Pair {
  const char* name;
  Mesh (*from)();
  Mesh (*to)();
};

inline const std::vector<Pair>& pairs() {
  static const std::vector<Pair> all = {
      {"shaken", [] { return shaken_cube(5, 1); }, [] { return shaken_cube(6, 2); }},
      {"finer", [] { return shaken_cube(3, 1); }, [] { return shaken_cube(8, 2); }},
      {"coarser", [] { return shaken_cube(8, 1); }, [] { return shaken_cube(2, 2); }},
      {"the_same", [] { return shaken_cube(4, 1); }, [] { return shaken_cube(4, 1); }},
      {"the_same_grid", [] { return cube(4); }, [] { return cube(4); }},
      {"nested_grids", [] { return cube(3); }, [] { return cube(6); }},
      {"stretched", [] { return stretched_cube(0.6); }, [] { return stretched_cube(0.9); }},
      {"stretched_to_fair", [] { return stretched_cube(0.6); }, [] { return shaken_cube(6, 1); }},
      {"fair_to_stretched", [] { return shaken_cube(6, 1); }, [] { return stretched_cube(0.6); }},
      {"u", [] { return shaken(u_shape(8), 0.02, 1); }, [] { return shaken(u_shape(16), 0.01, 2); }},
      {"u_coarser", [] { return shaken(u_shape(16), 0.01, 1); }, [] { return shaken(u_shape(8), 0.02, 2); }},
      {"l", [] { return shaken(l_shape(8), 0.02, 1); }, [] { return shaken(l_shape(6), 0.02, 2); }},
      {"slabs", [] { return shaken(two_slabs(8), 0.02, 1); }, [] { return shaken(two_slabs(16), 0.01, 2); }},
      {"slabs_coarser", [] { return shaken(two_slabs(16), 0.01, 1); }, [] { return shaken(two_slabs(8), 0.02, 2); }}};
  return all;
}

using Function = std::function<double(const Point&)>;

inline double linear_function(const Point& p) {
  return 1 + 2 * p[0] - 3 * p[1] + 0.5 * p[2];
}
inline double smooth_function(const Point& p) {
  return 2 + std::sin(3 * p[0] + p[1]) * std::cos(2 * p[2]) + p[1] * p[1];
}
inline double step_function(const Point& p) {
  return p[0] + 0.3 * p[1] > 0.6 ? 1 : 0;
}

inline Field sampled_field(const Mesh& mesh, const Function& f) {
  Field field;
  for (const Point& p : mesh.points) field.values.push_back(f(p));
  return field;
}

inline double largest_error(const Mesh& mesh, const Field& field, const Function& f) {
  double worst = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    worst = std::max(worst, std::abs(field.values[i] - f(mesh.points[i])));
  return worst;
}

/// In L2, by a rule of four points in each tetrahedron.
inline double error_norm(const Mesh& mesh, const Field& field, const Function& f) {
  constexpr double near = 0.5854101966249685, far = 0.1381966011250105;
  double sum = 0;
  for (const auto& t : mesh.tetrahedra) {
    const double volume = six_volumes(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) / 6;
    for (std::size_t q = 0; q < 4; ++q) {
      Point x{};
      double u = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = k == q ? near : far;
        x = x + weight * mesh.points[t[k]];
        u += weight * field.values[t[k]];
      }
      sum += volume / 4 * std::pow(u - f(x), 2);
    }
  }
  return std::sqrt(sum);
}

}  // namespace taut::test
