// The curvature of the surface of a mesh.
#pragma once

#include <vector>

#include "geometry/sectors.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/spectral.hpp"

namespace taut {

/// The principal curvatures of each sector, as principal_curvatures() gives them, from jets through the neighbours
/// within three edges in the sector's smooth part of the surface, or more if they are few. A sector's normal has the
/// sense of its triangles.
[[nodiscard]] std::vector<Spectrum> curvatures_of(const TetMesh& mesh, const Sectors& sectors);

}  // namespace taut
