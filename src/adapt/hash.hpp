// A number that tells results apart.
#pragma once

#include <cstdint>

#include "taut/adapt.hpp"

namespace taut {

/// Of all arrays of the mesh, and of the metric. Equal hashes mean equal bits, but for a chance of 2^-64.
[[nodiscard]] std::uint64_t hash_of(const Mesh& mesh, const Tensors& metric);

}  // namespace taut
