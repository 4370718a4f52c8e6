// A tetrahedron as a system of coordinates.
#pragma once

#include <array>

#include "base/vec3.hpp"

namespace taut {

/// A positive tetrahedron, with what gives the weights (barycentric coordinates) of any point in it.
struct TetFrame {
  std::array<Vec3, 4> corners;
  std::array<Vec3, 4> gradients;  ///< of the weights
  double volume;

  explicit TetFrame(const std::array<Vec3, 4>& x) : corners(x) {
    const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    const Vec3 bc = cross(b, c);
    const double six = dot(a, bc);
    volume = six / 6;
    const double scale = 1 / six;
    gradients[0] = scale * cross(x[3] - x[1], x[2] - x[1]);
    gradients[1] = scale * bc;
    gradients[2] = scale * cross(c, a);
    gradients[3] = scale * cross(a, b);
  }

  /// Each weight is measured from a corner where it is 0, so that it is exactly 0 there.
  [[nodiscard]] std::array<double, 4> weights_of(const Vec3& x) const {
    const Vec3 from0 = x - corners[0], from1 = x - corners[1];
    return {dot(gradients[0], from1), dot(gradients[1], from0), dot(gradients[2], from0), dot(gradients[3], from0)};
  }
};

}  // namespace taut
