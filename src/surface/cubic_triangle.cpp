#include "surface/cubic_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "locate/closest_on_triangle.hpp"

namespace taut {
namespace {

/// The six points of the quadratic patch that de Casteljau's first step leaves: at the corners, and between k and k
/// + 1.
struct QuadraticTriangle {
  std::array<Vec3, 3> corner, edge;
};

Vec3 mix(const std::array<double, 3>& w, const Vec3& a, const Vec3& b, const Vec3& c) {
  return w[0] * a + w[1] * b + w[2] * c;
}

QuadraticTriangle first_step(const CubicTriangle& t, const std::array<double, 3>& w) {
  const auto& h = t.handle;
  return {{mix(w, t.corner[0], h[0][0], h[2][1]), mix(w, h[0][1], t.corner[1], h[1][0]),
           mix(w, h[2][0], h[1][1], t.corner[2])},
          {mix(w, h[0][0], h[0][1], t.centre), mix(w, t.centre, h[1][0], h[1][1]), mix(w, h[2][1], t.centre, h[2][0])}};
}

/// The symmetric function of three places that is linear in each, and the patch if they are one: its values at the
/// corners of a part of the triangle are the Bezier points of that part.
Vec3 blossom(const CubicTriangle& t, const std::array<double, 3>& p, const std::array<double, 3>& q,
             const std::array<double, 3>& r) {
  const auto [corner, edge] = first_step(t, p);
  return mix(r, mix(q, corner[0], edge[0], edge[2]), mix(q, edge[0], corner[1], edge[1]),
             mix(q, edge[2], edge[1], corner[2]));
}

}  // namespace

CubicTriangle with_centre(const std::array<Vec3, 3>& corner, const std::array<std::array<Vec3, 2>, 3>& handle) {
  Vec3 handles{};
  for (const auto& edge : handle)
    for (const Vec3& h : edge) handles = handles + h;
  return {corner, handle, 0.25 * handles - (1.0 / 6) * (corner[0] + corner[1] + corner[2])};
}

SurfacePoint evaluate(const CubicTriangle& t, const std::array<double, 3>& w) {
  const QuadraticTriangle q = first_step(t, w);
  const Vec3 a = mix(w, q.corner[0], q.edge[0], q.edge[2]), b = mix(w, q.edge[0], q.corner[1], q.edge[1]),
             c = mix(w, q.edge[2], q.edge[1], q.corner[2]);
  // Second derivatives need the linear patch under the quadratic one: differences of Bezier points, mixed by weights.
  const auto& h = t.handle;
  const Vec3 &p0 = t.corner[0], &p1 = t.corner[1], &p2 = t.corner[2], &m = t.centre;
  const auto second = [&](const Vec3& at0, const Vec3& at1, const Vec3& at2) { return 6 * mix(w, at0, at1, at2); };
  const Vec3 uu = second(p0 - 2 * h[0][0] + h[0][1], h[0][0] - 2 * h[0][1] + p1, h[2][1] - 2 * m + h[1][0]);
  const Vec3 vv = second(p0 - 2 * h[2][1] + h[2][0], h[0][0] - 2 * m + h[1][1], h[2][1] - 2 * h[2][0] + p2);
  const Vec3 uv = second(p0 - h[0][0] - h[2][1] + m, h[0][0] - h[0][1] - m + h[1][0], h[2][1] - m - h[2][0] + h[1][1]);
  return {mix(w, a, b, c), 3 * (b - a), 3 * (c - a), uu, uv, vv};
}

double deviation_bound(const CubicTriangle& t) {
  using Shares = std::array<double, 3>;
  constexpr Shares a = {1, 0, 0}, b = {0, 1, 0}, c = {0, 0, 1}, ab = {0.5, 0.5, 0}, bc = {0, 0.5, 0.5},
                   ca = {0.5, 0, 0.5};
  constexpr std::array<std::array<Shares, 3>, 4> quarters = {{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}};
  double farthest = 0;
  for (const auto& corner : quarters)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        for (std::size_t k = j; k < 3; ++k) {
          const Vec3 x = blossom(t, corner[i], corner[j], corner[k]);
          farthest = std::max(farthest, closest_on_triangle(x, t.corner).squared_distance);
        }
  return std::sqrt(farthest);
}

}  // namespace taut
