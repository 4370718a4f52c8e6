// The edges of a set of tetrahedra.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Every edge of `tets` once, smaller vertex first, in lexicographic order. Takes linear time, except for sorting the
/// few edges of each vertex.
[[nodiscard]] std::vector<std::array<Index, 2>> edges_of(std::span<const std::array<Index, 4>> tets);

}  // namespace taut
