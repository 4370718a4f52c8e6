// A surface split at its ridges, so that each part of it is smooth.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/surface_edges.hpp"

namespace taut {

/// A sector is a vertex as the triangles see it that one can reach around it across smooth edges. Inside a smooth
/// surface a vertex has one sector, on a ridge two or more: normals and curvatures are one-sided there.
struct Sectors {
  std::vector<VertexId> vertices;                         ///< of each sector
  std::vector<std::array<std::uint32_t, 3>> of_triangle;  ///< the sectors at the corners of each triangle
};

[[nodiscard]] Sectors find_sectors(std::span<const Corners> triangles, std::span<const EdgePair> smooth_edges);

}  // namespace taut
