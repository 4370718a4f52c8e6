// Order along a Hilbert curve: what is near in space becomes near in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace taut {

/// A permutation: the result's entry i is the index of the point that comes i-th along the Hilbert curve through the
/// points' bounding box (each direction scaled to it). Ties keep the order of the input.
[[nodiscard]] std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points);

}  // namespace taut
