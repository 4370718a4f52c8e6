// The inner control points of a cubic edge between two points of a curved surface or curve.
#pragma once

#include "base/vec3.hpp"

namespace taut {

/// The unit tangent at the start of the edge along e, in the plane across the unit normal n: the projected chord. The
/// chord itself if it stands on the plane.
[[nodiscard]] inline Vec3 projected_chord(const Vec3& e, const Vec3& n) {
  const Vec3 along = e - dot(e, n) / dot(n, n) * n;
  const double length = norm(along), chord = norm(e);
  return length > 1e-3 * chord ? 1 / length * along : 1 / chord * e;
}

/// From the start of the edge along e, whose unit tangent there is t, to its handle. Cubic edges with such handles
/// at both ends are as close to circles as cubic curves that meet their ends in position, tangent and middle can be.
[[nodiscard]] inline Vec3 handle_along(const Vec3& e, const Vec3& t) {
  const double length = norm(e), cosine = dot(t, e) / length;
  return 2 * length / (3 * (1 + (cosine > 0 ? cosine : 0.0))) * t;
}

}  // namespace taut
