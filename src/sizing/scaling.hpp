// The factor that gives metrics a wanted complexity.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sizing/shape.hpp"

namespace taut {

/// Metrics of several meshes that have one factor in common.
struct Scaled {
  std::vector<std::vector<Sym3>> metrics;
  std::vector<double> complexities;
  double total = 0;  ///< the weighted sum of the complexities
  int evaluations = 0;
  std::string stopped_by;
};

/// The shapes times the factor for which the sum of weight times complexity is `wanted` after the limits are applied.
/// The complexity never falls as the factor grows, so there is one unless hmin or hmax forbids it. All shapes have the
/// same limits.
[[nodiscard]] Scaled scaled_to(double wanted, std::span<const Shape> shapes, std::span<const double> weights);

/// The same for one mesh.
[[nodiscard]] ScaledMetric scaled_to(double wanted, const Shape& shape);

}  // namespace taut
