// The anisotropic Delaunay criterion (Dobrzynski and Frey 2008, section 3, eq. (4)).
#pragma once

#include <array>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Whether the positive tetrahedron K is in conflict with a point p: delta_{Mp} < 1, and the sum of delta over Mp and
/// the metrics of K's vertices is below 5. Here delta_M(p, K) = |Op|_M / r_K, where O and r_K are the circumcentre and
/// the radius of K in the metric M.
[[nodiscard]] bool in_conflict(const Vertex& p, const std::array<const Vertex*, 4>& k);

}  // namespace taut
