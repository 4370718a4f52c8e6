// The plane that a patch of triangles is on, if it is planar.
#pragma once

#include <array>
#include <cmath>

#include "geometry/model.hpp"

namespace taut {

/// The plane of the largest triangle, the normal of which has lost the fewest digits. One perpendicular to an axis
/// keeps its coordinate exactly, so that rounding never moves vertices off it.
class LargestPlane {
public:
  void add(const std::array<Vec3, 3>& triangle);

  /// Of the largest triangle so far; there is one that has an area.
  [[nodiscard]] const Plane& plane() const { return plane_; }

private:
  Plane plane_{};
  double largest_ = -1;
};

[[nodiscard]] inline double distance(const Plane& plane, const Vec3& x) {
  return std::abs(dot(plane.normal, x) - plane.offset);
}

}  // namespace taut
