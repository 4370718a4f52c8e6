// The anisotropic Delaunay criterion (Dobrzynski and Frey 2008, section 3, eq. (4)).
#pragma once

#include <array>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Whether tetrahedron K (positive) conflicts with a point p: with delta_M(p, K) = |Op|_M / r_K, O and r_K circumcentre
/// and radius of K in the metric M, delta_{Mp} < 1 and the sum of delta over Mp and the metrics of K's vertices < 5.
[[nodiscard]] bool in_conflict(const Vertex& p, const std::array<const Vertex*, 4>& k);

}  // namespace taut
