// Difficult metric fields, for domains within [-1, 1]^3.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "metric/random_metrics.hpp"
#include "taut/metric.hpp"

namespace taut::test {

/// Size `across` in the direction of the unit vector n, and `along` perpendicular to it.
inline Sym3 stretched(const Vec3& n, double across, double along) {
  const double a = std::pow(across, -2), b = std::pow(along, -2);
  return Sym3{b + (a - b) * n[0] * n[0], (a - b) * n[0] * n[1], (a - b) * n[0] * n[2],
              b + (a - b) * n[1] * n[1], (a - b) * n[1] * n[2], b + (a - b) * n[2] * n[2]};
}

inline Vec3 direction_of(const Vec3& x) {
  const double r = norm(x);
  return r > 0 ? 1 / r * x : Vec3{1, 0, 0};
}

inline MetricFunction uniform(double size) {
  return [size](const Point&) { return metric_of_size(size); };
}

/// Each of 6^3 boxes has another metric in another direction, up to 100:1, so that the metric jumps between boxes.
inline MetricFunction patchwork(double size, unsigned seed) {
  Random random(seed);
  std::vector<Sym3> metrics;
  for (int i = 0; i < 216; ++i) {
    const double thin = std::exp(random.uniform(std::log(0.01), 0)), wide = random.uniform(0.5, 1);
    metrics.push_back(rotate(random.rotation(),
                             Sym3{std::pow(thin * size, -2), 0, 0, std::pow(wide * size, -2), 0, std::pow(size, -2)}));
  }
  return [metrics](const Point& x) {
    std::size_t at = 0;
    for (const double c : x) at = 6 * at + static_cast<std::size_t>(std::clamp(std::floor(3 * (c + 1)), 0.0, 5.0));
    return metrics[at];
  };
}

/// Isotropic, except in an oblique slab, where the size across it is 100 times smaller: the size jumps at its sides.
inline MetricFunction jump(double size) {
  return [size](const Point& x) {
    const Vec3 n = {0.6, 0.48, 0.64};
    return std::abs(dot(n, x) - 0.45) > 0.1 ? metric_of_size(size) : stretched(n, size / 100, size);
  };
}

/// A front on a sphere around the origin, with sizes from size / 50 to size across it, and size along it.
inline MetricFunction front(double size, double radius) {
  return [=](const Point& x) {
    const double across = size * std::min(1.0, 0.02 + std::abs(norm(x) - radius));
    return stretched(direction_of(x), across, size);
  };
}

/// A thin shell on the sphere of radius 0.5 around the origin: sizes from 0.003 across it, and 0.1 along it. At beta
/// 1.3, gradation multiplies the complexity by 7.3 in metric space, by 1.5 with the mix 0.5, and by 1.1 in physical
/// space.
inline MetricFunction shell() {
  return [](const Point& x) {
    const double across = 0.1 * (1 - std::exp(-std::abs(norm(x) - 0.5))) + 0.003;
    return stretched(direction_of(x), across, 0.1);
  };
}

}  // namespace taut::test
