// Order along a Hilbert curve: neighbours in space become neighbours in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace taut {

/// A permutation: entry i of the result is the index of the i-th point along the Hilbert curve through the points'
/// bounding box (each direction is scaled to the box). Ties keep the order of the input.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points);

}  // namespace taut
