// The closest point on one triangle.
#pragma once

#include <algorithm>
#include <array>

#include "base/vec3.hpp"

namespace taut {

/// A point of a triangle, and how far it is from another point.
struct OnTriangle {
  Vec3 point;
  std::array<double, 3> weights;  ///< of the three vertices: none negative, of sum 1
  double squared_distance;
};

namespace detail {

/// Rounding must not carry the point out of the triangle's bounding box: a search by boxes compares both distances.
inline OnTriangle at_weights(const Vec3& x, const std::array<Vec3, 3>& v, const std::array<double, 3>& w) {
  OnTriangle at{w[0] * v[0] + w[1] * v[1] + w[2] * v[2], w, 0};
  for (std::size_t d = 0; d < 3; ++d) {
    const auto [low, high] = std::minmax({v[0][d], v[1][d], v[2][d]});
    at.point[d] = std::clamp(at.point[d], low, high);
  }
  const Vec3 away = x - at.point;
  at.squared_distance = dot(away, away);
  return at;
}

inline OnTriangle on_edge(const Vec3& x, const std::array<Vec3, 3>& v, std::size_t edge) {
  const std::size_t i = edge, j = (edge + 1) % 3;
  const Vec3 along = v[j] - v[i];
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(x - v[i], along) / square, 0.0, 1.0) : 0.0;
  std::array<double, 3> w{};
  w[i] = 1 - t;
  w[j] = t;
  return at_weights(x, v, w);
}

}  // namespace detail

/// The point of the triangle `v` that is closest to x. The triangle may be flat or a single point.
[[nodiscard]] inline OnTriangle closest_on_triangle(const Vec3& x, const std::array<Vec3, 3>& v) {
  const Vec3 a = v[0] - x, b = v[1] - x, c = v[2] - x;
  const Vec3 n = cross(v[1] - v[0], v[2] - v[0]);
  std::array<double, 3> w = {dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)};
  OnTriangle best = detail::on_edge(x, v, 0);
  for (const std::size_t edge : {1, 2}) {
    const OnTriangle other = detail::on_edge(x, v, edge);
    if (other.squared_distance < best.squared_distance) best = other;
  }
  // The weights of a nearly flat triangle are mostly rounding, so its edges count too.
  if (!(w[0] > 0 && w[1] > 0 && w[2] > 0)) return best;
  const double scale = 1 / (w[0] + w[1] + w[2]);
  for (double& weight : w) weight *= scale;
  const OnTriangle inside = detail::at_weights(x, v, w);
  return inside.squared_distance < best.squared_distance ? inside : best;
}

}  // namespace taut
