// The mesh as users hold it: plain arrays with zero-based indices and nothing derived.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace taut {

using Index = std::uint32_t;          ///< of a point or of another entity of a mesh, from 0
using Point = std::array<double, 3>;  ///< coordinates x, y, z

/// A tetrahedral mesh with its marked lower-dimensional entities.
///
/// Every `*_refs` array is either empty (all references are 0) or as long as the array it belongs to. A tetrahedron is
/// positively oriented if det(p1-p0, p2-p0, p3-p0) > 0. Triangles on the boundary are oriented outward; triangles
/// between two regions may have either orientation.
struct Mesh {
  std::vector<Point> points;    ///< coordinates
  std::vector<int> point_refs;  ///< the reference of each point

  std::vector<std::array<Index, 4>> tetrahedra;  ///< indices into `points`
  std::vector<int> tetrahedron_refs;             ///< the region of each tetrahedron

  std::vector<std::array<Index, 3>> triangles;  ///< boundary faces and faces between regions
  std::vector<int> triangle_refs;               ///< the surface patch of each triangle

  std::vector<std::array<Index, 2>> edges;  ///< feature lines
  std::vector<int> edge_refs;               ///< the line of each edge

  std::vector<Index> corners;              ///< points that may not move
  std::vector<Index> required_points;      ///< points that must be kept
  std::vector<Index> ridges;               ///< indices into `edges`: the sharp ones
  std::vector<Index> required_edges;       ///< indices into `edges` that must be kept as they are
  std::vector<Index> required_triangles;   ///< indices into `triangles` that must be kept as they are
  std::vector<Index> required_tetrahedra;  ///< indices into `tetrahedra` that must be kept as they are
};

}  // namespace taut
