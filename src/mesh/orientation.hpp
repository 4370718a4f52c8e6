// On which side of a plane a point lies, without rounding.
#pragma once

#include <cmath>
#include <limits>

#include "base/vec3.hpp"

namespace taut {

/// The sign of det(b-a, c-a, d-a) in exact arithmetic; for all finite doubles. Slow: about a microsecond.
[[nodiscard]] int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The exact sign of det(b-a, c-a, d-a): 1 for a positive tetrahedron abcd, -1 for an inverted one, 0 for four coplanar
/// points. Floating point decides if its error bound allows (Shewchuk 1997, 4.3).
[[nodiscard]] inline int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double yz = v[1] * w[2], zy = v[2] * w[1];
  const double zx = v[2] * w[0], xz = v[0] * w[2];
  const double xy = v[0] * w[1], yx = v[1] * w[0];
  const double det = u[0] * (yz - zy) + u[1] * (zx - xz) + u[2] * (xy - yx);
  const double permanent = std::abs(u[0]) * (std::abs(yz) + std::abs(zy)) +
                           std::abs(u[1]) * (std::abs(zx) + std::abs(xz)) +
                           std::abs(u[2]) * (std::abs(xy) + std::abs(yx));
  constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2;
  constexpr double relative = (7 + 56 * epsilon) * epsilon;
  // The second term covers products that lost digits to underflow. Overflow makes the comparisons false.
  const double error = relative * permanent +
                       std::numeric_limits<double>::min() * (1 + std::abs(u[0]) + std::abs(u[1]) + std::abs(u[2]));
  if (det > error) return 1;
  if (det < -error) return -1;
  // Four points with a common coordinate, as on the side of a box, need no computation.
  for (int i = 0; i < 3; ++i) {
    if (u[i] == 0 && v[i] == 0 && w[i] == 0) return 0;
  }
  return exact_orientation(a, b, c, d);
}

}  // namespace taut
