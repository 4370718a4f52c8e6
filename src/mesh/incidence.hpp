// Which tetrahedron a point belongs to.
#pragma once

#include <span>
#include <vector>

#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// The last tetrahedron of each of so many points; `none` for a point of no tetrahedron.
[[nodiscard]] std::vector<TetId> last_tet_of_points(std::span<const std::array<Index, 4>> tets, std::size_t points);

}  // namespace taut
