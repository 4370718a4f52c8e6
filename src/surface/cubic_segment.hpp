// A cubic curve between two points.
#pragma once

#include <array>

#include "base/vec3.hpp"

namespace taut {

/// A point of a curve with its derivatives by the parameter, which runs from 0 to 1.
struct CurvePoint {
  Vec3 x, first, second;
};

/// By its Bezier points.
using CubicSegment = std::array<Vec3, 4>;

[[nodiscard]] inline CurvePoint evaluate(const CubicSegment& b, double s) {
  const double r = 1 - s;
  const Vec3 d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  return {b[0] + (s * (3 - s * (3 - s))) * d0 + (s * s * (3 - 2 * s)) * d1 + (s * s * s) * d2,
          3 * (r * r * d0 + (2 * r * s) * d1 + s * s * d2), 6 * (r * (d1 - d0) + s * (d2 - d1))};
}

}  // namespace taut
