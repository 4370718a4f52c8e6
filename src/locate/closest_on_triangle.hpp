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
    const double low = std::min(v[0][d], std::min(v[1][d], v[2][d]));
    const double high = std::max(v[0][d], std::max(v[1][d], v[2][d]));
    at.point[d] = std::min(std::max(at.point[d], low), high);
  }
  const Vec3 away = x - at.point;
  at.squared_distance = dot(away, away);
  return at;
}

/// The closest point on the three edges.
inline OnTriangle on_edges(const Vec3& x, const std::array<Vec3, 3>& v) {
  std::array<double, 3> weights{1, 0, 0};
  double least = dot(x - v[0], x - v[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vec3 along = v[j] - v[i], from = x - v[i];
    const double square = dot(along, along);
    if (!(square > 0)) continue;
    const double t = std::min(std::max(dot(from, along) / square, 0.0), 1.0);
    const Vec3 away = from - t * along;
    const double squared_distance = dot(away, away);
    if (squared_distance >= least) continue;
    least = squared_distance;
    weights = {0, 0, 0};
    weights[i] = 1 - t;
    weights[j] = t;
  }
  return at_weights(x, v, weights);
}

}  // namespace detail

/// The point of the triangle `v` that is closest to x. The triangle may be flat or a single point.
[[nodiscard]] inline OnTriangle closest_on_triangle(const Vec3& x, const std::array<Vec3, 3>& v) {
  constexpr double flat = 1e-12;  // squared height over squared length
  const Vec3 a = v[0] - x, b = v[1] - x, c = v[2] - x;
  const Vec3 ab = v[1] - v[0], ac = v[2] - v[0], n = cross(ab, ac);
  std::array<double, 3> w = {dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)};
  if (!(w[0] > 0 && w[1] > 0 && w[2] > 0)) return detail::on_edges(x, v);
  const double scale = 1 / (w[0] + w[1] + w[2]);
  for (double& weight : w) weight *= scale;
  const OnTriangle inside = detail::at_weights(x, v, w);
  const double square = dot(ab, ab) + dot(ac, ac);
  if (dot(n, n) > flat * square * square) return inside;
  // The weights of a nearly flat triangle are mostly rounding.
  const OnTriangle edge = detail::on_edges(x, v);
  return inside.squared_distance < edge.squared_distance ? inside : edge;
}

}  // namespace taut
