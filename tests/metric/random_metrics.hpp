// Metrics and rotations for property tests.
#pragma once

#include <cmath>
#include <random>

#include "metric/spectral.hpp"

namespace taut::test {

using Rotation = std::array<Vec3, 3>;  // rows

inline Vec3 rotate(const Rotation& r, const Vec3& x) {
  return {dot(r[0], x), dot(r[1], x), dot(r[2], x)};
}

/// R M R^T.
inline Sym3 rotate(const Rotation& r, const Sym3& m) {
  const Vec3 c0 = m * r[0], c1 = m * r[1], c2 = m * r[2];
  return {dot(r[0], c0), dot(r[0], c1), dot(r[0], c2), dot(r[1], c1), dot(r[1], c2), dot(r[2], c2)};
}

class Random {
public:
  explicit Random(unsigned seed) : generator_(seed) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }

  Vec3 point() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }

  Rotation rotation() {
    const Vec3 a = direction(), b = cross(a, direction());
    const Vec3 c = (1 / norm(b)) * b;
    return {a, c, cross(a, c)};
  }

  /// Sizes drawn geometrically from [smallest, 1], in random directions.
  Sym3 metric(double smallest) {
    Spectrum s{{}, rotation()};
    for (double& value : s.values) value = std::exp(-2 * uniform(std::log(smallest), 0));
    return assemble(s);
  }

private:
  Vec3 direction() {
    std::normal_distribution<double> normal;
    const Vec3 x = {normal(generator_), normal(generator_), normal(generator_)};
    return (1 / norm(x)) * x;
  }
  std::mt19937_64 generator_;
};

/// Largest difference of two entries over the largest entry.
inline double distance(const Sym3& a, const Sym3& b) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return difference / largest;
}

}  // namespace taut::test
