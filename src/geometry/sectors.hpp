// A surface split at its ridges, so that each part of it is smooth.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/features.hpp"
#include "geometry/surface_edges.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// A sector is a vertex as the triangles see it that one can reach around it without crossing a sharp edge. Inside a
/// smooth surface a vertex has one sector, on a ridge two or more: normals and curvatures are one-sided there.
struct Sectors {
  std::vector<VertexId> vertices;                         ///< of each sector
  std::vector<std::array<std::uint32_t, 3>> of_triangle;  ///< the sectors at the corners of each triangle
};

/// The sectors that the sharp ones among `features` part, which are those of the surface, ascending.
[[nodiscard]] Sectors find_sectors(const TetMesh& mesh, const std::vector<EdgeUse>& uses,
                                   std::vector<Feature> features);

}  // namespace taut
