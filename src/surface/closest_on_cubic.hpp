// The closest points on one curved triangle and on one curved edge.
#pragma once

#include <array>

#include "surface/cubic_segment.hpp"
#include "surface/cubic_triangle.hpp"

namespace taut {

struct OnCubicTriangle {
  Vec3 point;
  Vec3 across;                    ///< perpendicular to the patch there, of any length; zero where the patch has no area
  std::array<double, 3> weights;  ///< of the corners: none negative, of sum 1
  double squared_distance;
  int iterations;  ///< steps of Newton's method
};

/// The point of the patch where the distance to x has the local minimum that Newton's method, bounded to the triangle,
/// finds from `weights`: those of the closest point on the flat triangle lead to the closest point as long as x is
/// nearer to the patch than its centres of curvature are.
[[nodiscard]] OnCubicTriangle closest_on(const CubicTriangle& patch, const Vec3& x,
                                         const std::array<double, 3>& weights);

struct OnCubicSegment {
  Vec3 point;
  double parameter;  ///< from 0 to 1
  double squared_distance;
};

/// Likewise on a curve.
[[nodiscard]] OnCubicSegment closest_on(const CubicSegment& curve, const Vec3& x, double parameter);

}  // namespace taut
