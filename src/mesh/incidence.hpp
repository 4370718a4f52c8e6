// Which tetrahedra a point belongs to.
#pragma once

#include <span>
#include <vector>

#include "base/buckets.hpp"
#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// For each point, the last tetrahedron that it belongs to; `none` if it belongs to no tetrahedron.
[[nodiscard]] std::vector<TetId> last_tet_of_points(std::span<const std::array<Index, 4>> tets, std::size_t points);

/// For each point, all tetrahedra that it belongs to, ascending.
[[nodiscard]] Buckets<Index> tets_of_points(std::span<const std::array<Index, 4>> tets, std::size_t points);

}  // namespace taut
