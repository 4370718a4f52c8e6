// Points like the tip of a cone, where a surface has no normal although no ridge ends there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/ridges.hpp"
#include "surface/sectors.hpp"

namespace taut {

/// For each vertex whether it is the apex of a cone. There the triangles are tilted away from the axis as much as the
/// surface around them is; where a surface is smooth, they are tilted about half as much.
[[nodiscard]] std::vector<std::uint8_t> find_apexes(const Facets& facets, const Sectors& sectors,
                                                    std::span<const RidgeEdge> ridges);

}  // namespace taut
