// What a metric is allowed to ask for.
#pragma once

#include <limits>
#include <optional>

#include "taut/export.hpp"
#include "taut/gradation.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// Limits that a metric has to respect.
struct Limits {
  double hmin = 0;  ///< smallest size: smaller ones become hmin
  /// Largest size: larger ones become hmax. If it is infinite, the functions that make a metric of a solution take the
  /// diagonal of the domain's bounding box, because a field may be linear in some direction, which asks for infinitely
  /// long edges.
  double hmax = std::numeric_limits<double>::infinity();
  double anisotropy = std::numeric_limits<double>::infinity();  ///< largest ratio (>= 1) of two sizes at one point
  std::optional<Gradation> gradation{};                         ///< how fast sizes may grow; none: no limit
};

/// The metric with all limits applied: sizes that are too small or too large are clipped, those that are too long for
/// the anisotropy are shortened, then the metric is graded. A metric within all limits keeps its bits. Throws
/// InputError if the limits, an array of `mesh` or the number of tensors cannot be used, and, naming the vertex, if a
/// tensor is not positive definite.
[[nodiscard]] TAUT_EXPORT Tensors limited(const Mesh& mesh, Tensors metric, const Limits& limits);

}  // namespace taut
