// The curved triangles of a surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/cubic_segment.hpp"
#include "surface/cubic_triangle.hpp"
#include "surface/facets.hpp"
#include "surface/reference_parts.hpp"
#include "surface/sectors.hpp"

namespace taut {

/// What decides the edges of curved triangles. An edge is the same seen from both of its sides.
struct EdgeShapes {
  const Sectors& sectors;
  std::span<const Vec3> normals;          ///< of the sectors, of any length: smooth edges start across them
  std::span<const std::uint8_t> is_apex;  ///< by vertex: has no normal
  const RidgesOfTriangles& ridges_of;
  std::span<const CubicSegment> of_ridge;  ///< from the smaller vertex of each ridge to the larger
};

/// A cubic patch over each triangle. At an apex a smooth edge starts as a circle that ends with the tangent at the
/// other end: along a cone it is straight.
[[nodiscard]] std::vector<CubicTriangle> cubic_patches(const Facets& facets, const EdgeShapes& shapes);

}  // namespace taut
