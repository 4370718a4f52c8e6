// A triangulated surface as users hold it, and its measures.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "taut/export.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A surface of triangles. The sense of rotation of a triangle gives its normal, by the rule of the right hand.
struct SurfaceMesh {
  std::vector<Point> points;                    ///< coordinates
  std::vector<std::array<Index, 3>> triangles;  ///< indices into `points`
};

/// How large a surface is.
struct SurfaceMeasures {
  double area = 0;  ///< sum over the triangles
  /// Enclosed by the surface if it is closed: positive if its normals point outward, negative if they point inward. 0
  /// if the surface is not closed.
  double volume = 0;
  std::size_t open_edges =
      0;  ///< edges that triangles do not pass equally often in both directions; none: it is closed
};

/// Measures `surface`. Throws InputError if an index is out of range or a coordinate is not finite.
[[nodiscard]] TAUT_EXPORT SurfaceMeasures measure(const SurfaceMesh& surface);

}  // namespace taut
