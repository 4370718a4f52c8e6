// How far two surfaces are from each other.
#pragma once

#include <cstddef>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/surface_mesh.hpp"

namespace taut {

/// Where distances are taken: at the nodes of a regular subdivision of each triangle.
struct DistanceOptions {
  /// Largest distance between neighbouring samples on a triangle; 0: a five-hundredth of the diagonal of the box around
  /// both surfaces.
  double spacing = 0;
  /// Every edge is divided into at least this many parts, so that small triangles are sampled inside, too. A multiple
  /// of 3 has a sample at the centre of the triangle. 1 will do for a surface much finer than the distance to be found.
  int divisions = 3;
};

/// How far one surface is from another. The distance of a sample to the other surface is exact but for rounding.
struct Deviation {
  double worst = 0;         ///< of all samples
  Point where{};            ///< the sample that is farthest
  double mean = 0;          ///< over the area of the surface
  double area = 0;          ///< of the surface
  std::size_t samples = 0;  ///< number of them
};

/// The distances between two surfaces, both ways: a part that only one of them has shows in one way only.
struct SurfaceDistance {
  Deviation from_first;   ///< of the first surface to the second
  Deviation from_second;  ///< of the second surface to the first
  double worst = 0;       ///< the larger of both: the Hausdorff distance, but for what lies between samples
  double mean = 0;        ///< over the areas of both
};

/// Samples each surface and measures how far it is from the other. Throws InputError if a surface has no triangles, an
/// index is out of range, a coordinate is not finite, or an option is out of range.
[[nodiscard]] TAUT_EXPORT SurfaceDistance distance(const SurfaceMesh& first, const SurfaceMesh& second,
                                                   const DistanceOptions& options = {});

}  // namespace taut
