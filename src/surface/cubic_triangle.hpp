// A curved triangle: a cubic Bezier patch over three corners (Vlachos et al. 2001, "Curved PN Triangles").
#pragma once

#include <array>
#include <cstddef>

#include "base/vec3.hpp"

namespace taut {

/// A point of a patch, with the derivatives by the weights of its second and its third corner.
struct SurfacePoint {
  Vec3 x, u, v, uu, uv, vv;
};

/// Bezier points: the corners, then of each edge from corner k to the next one the handle at k and the one at the
/// next corner, then the centre.
struct CubicTriangle {
  std::array<Vec3, 3> corner;
  std::array<std::array<Vec3, 2>, 3> handle;
  Vec3 centre;
};

/// With the centre of Vlachos et al., eq. 3: a quadratic patch is reproduced.
[[nodiscard]] CubicTriangle with_centre(const std::array<Vec3, 3>& corner,
                                        const std::array<std::array<Vec3, 2>, 3>& handle);

/// `weights` of the corners have the sum 1.
[[nodiscard]] SurfacePoint evaluate(const CubicTriangle& t, const std::array<double, 3>& weights);

/// No point of the patch is farther from the flat triangle between its corners: the distance from a convex set is
/// largest at a Bezier point, here of the quarters of the patch.
[[nodiscard]] double deviation_bound(const CubicTriangle& t);

}  // namespace taut
