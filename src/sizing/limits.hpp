// Limits on a metric.
#pragma once

#include <span>
#include <vector>

#include "base/sym3.hpp"
#include "taut/limits.hpp"

namespace taut {

/// Throws InputError for limits that make no sense.
void require_limits(const Limits& limits);

/// Grades metrics that are within the bounds, if the limits say so. The intersection of metrics in oblique directions
/// can have smaller sizes than either, hence the bounds are applied again.
[[nodiscard]] std::vector<Sym3> graded(const Mesh& mesh, std::span<const std::array<Index, 2>> edges,
                                       std::vector<Sym3> metrics, const Limits& limits);

/// Applies the bounds, then the gradation.
[[nodiscard]] std::vector<Sym3> apply_limits(const Mesh& mesh, std::vector<Sym3> metrics, const Limits& limits);

/// The same limits; an infinite hmax becomes the diagonal of the bounding box of the mesh.
[[nodiscard]] Limits within_domain(const Mesh& mesh, Limits limits);

}  // namespace taut
