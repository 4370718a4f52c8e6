// Checks of arrays with one entry per point of a mesh.
#pragma once

#include <cstddef>
#include <span>

#include "taut/metric.hpp"

namespace taut {

/// Throws InputError unless there is one value per point and all are finite.
void require_values(std::span<const double> values, std::size_t points);

/// The same for tensors that need not be positive definite.
void require_tensors(std::span<const Tensor> tensors, std::size_t points);

}  // namespace taut
