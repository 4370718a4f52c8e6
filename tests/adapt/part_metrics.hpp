// The metrics to which parts from CAD are adapted.
#pragma once

#include <ostream>

#include "adapt/checks.hpp"
#include "taut/sizing.hpp"

namespace taut::test {

enum class Wanted { finer, coarser, random, deviation, curvature };

inline std::ostream& operator<<(std::ostream& out, Wanted wanted) {
  constexpr std::array<const char*, 5> names = {"finer", "coarser", "random", "deviation", "curvature"};
  return out << names[static_cast<std::size_t>(wanted)];
}

/// The mean length of the edges of triangles.
inline double size_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) sum += norm(mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]);
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

/// Smooth, with sizes up to ten times as small in one direction, which turns over the length of the part.
inline MetricFunction random_waves(double size, double length, unsigned seed) {
  Random random(seed);
  std::array<Vec3, 4> waves;
  std::array<double, 4> phases;
  for (Vec3& wave : waves) wave = (3 / length) * random.point();
  for (double& phase : phases) phase = random.uniform(0, 6);
  return [=](const Point& x) {
    std::array<double, 4> s;
    for (std::size_t k = 0; k < 4; ++k) s[k] = std::sin(dot(waves[k], x) + phases[k]);
    const Vec3 n = {s[0] + 1.5, s[1], s[2]};
    const double aspect = std::pow(10, 0.5 + 0.5 * s[3]);
    return std::pow(size, -2) * (identity3 + (aspect * aspect - 1) / dot(n, n) * outer(n));
  };
}

/// How far triangles may be from the surface if a deviation is asked for.
inline double deviation_for(const Mesh& mesh) {
  return 0.03 * size_of(mesh);
}

inline Tensors metric_for(const Mesh& mesh, Wanted wanted, double length) {
  const double h = size_of(mesh);
  switch (wanted) {
    case Wanted::finer:
      return Tensors(mesh.points.size(), metric_of_size(0.75 * h));
    case Wanted::coarser:
      return Tensors(mesh.points.size(), metric_of_size(2 * h));
    case Wanted::random:
      return sampled(mesh, random_waves(1.6 * h, length, 5));
    case Wanted::deviation:
      return Tensors(mesh.points.size(), metric_of_size(1.5 * h));
    case Wanted::curvature:
      return curvature_metric(
          mesh, {.deviation = deviation_for(mesh), .limits = {.hmax = 2 * h, .gradation = Gradation{.beta = 1.5}}});
  }
  return {};
}

}  // namespace taut::test
