#include "surface/closest_on_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace taut {
namespace {

constexpr int most_iterations = 30;
constexpr int most_halvings = 12;
constexpr double rounding = 1 + 1e-14;  ///< of the squared distance: near the minimum it hides what a step gains
constexpr double smallest_step = 1e-7;  ///< Newton's method squares the error: the step after it is not seen

using Weights = std::array<double, 3>;
using Step = std::array<double, 3>;  ///< of the weights: its sum is 0

/// A quadratic form of the weights of corners 1 and 2.
struct Form {
  double uu, uv, vv;

  [[nodiscard]] double determinant() const { return uu * vv - uv * uv; }
  [[nodiscard]] double along(const Step& s) const { return uu * s[1] * s[1] + 2 * uv * s[1] * s[2] + vv * s[2] * s[2]; }
};

/// Half of the squared distance near a place on the patch.
struct Model {
  double u, v;                 ///< gradient
  Form hessian, gauss_newton;  ///< the second one is positive definite, and takes the place of the first if that is not
};

constexpr double least_share_of_form = 1e-3;  ///< of the second form that the first one must have to be used

Model model_at(const SurfacePoint& s, const Vec3& from) {
  const Form flat{dot(s.u, s.u), dot(s.u, s.v), dot(s.v, s.v)};
  const double regular = 1e-10 * (flat.uu + flat.vv);  // a patch without area has a singular matrix
  return {dot(from, s.u),
          dot(from, s.v),
          {flat.uu + dot(from, s.uu), flat.uv + dot(from, s.uv), flat.vv + dot(from, s.vv)},
          {flat.uu + regular, flat.uv, flat.vv + regular}};
}

Step newton_step(const Model& m) {
  const bool is_minimum =
      m.hessian.uu > 0 && m.hessian.determinant() > least_share_of_form * m.gauss_newton.determinant();
  const Form& f = is_minimum ? m.hessian : m.gauss_newton;
  if (!(f.determinant() > 0)) return {};
  const double u = (f.uv * m.v - f.vv * m.u) / f.determinant(), v = (f.uv * m.u - f.uu * m.v) / f.determinant();
  return {-u - v, u, v};
}

bool leaves(const Weights& w, const Step& step) {
  for (std::size_t k = 0; k < 3; ++k)
    if (w[k] <= 0 && step[k] < 0) return true;
  return false;
}

/// The step along the edges at which w lies that gains most. None if each of them leads out of the triangle.
Step step_on_border(const Weights& w, const Model& m) {
  Step best{};
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (w[k] > 0) continue;
    Step along{};
    along[(k + 1) % 3] = 1, along[(k + 2) % 3] = -1;
    const double slope = m.u * along[1] + m.v * along[2];
    const double full = m.hessian.along(along), flat = m.gauss_newton.along(along);
    const double curvature = full > least_share_of_form * flat ? full : flat;
    if (!(curvature > 0)) continue;
    for (double& a : along) a *= -slope / curvature;
    const double gain = slope * slope / curvature;
    if (gain > most && !leaves(w, along)) best = along, most = gain;
  }
  return best;
}

Weights moved(const Weights& w, const Step& step) {
  double share = 1;
  std::optional<std::size_t> hit;
  for (std::size_t k = 0; k < 3; ++k)
    if (w[k] + share * step[k] < 0) share = w[k] / -step[k], hit = k;
  Weights to{};
  for (std::size_t k = 0; k < 3; ++k) to[k] = std::max(w[k] + share * step[k], 0.0);
  if (hit) to[*hit] = 0;
  const double sum = to[0] + to[1] + to[2];
  for (double& t : to) t /= sum;
  return to;
}

double largest_of(const Step& step) {
  return std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
}

/// The step of a bounded Newton method for half of the squared distance to a curve.
double step_on_curve(const CurvePoint& c, const Vec3& from, double parameter) {
  const double slope = dot(from, c.first), square = dot(c.first, c.first), full = square + dot(from, c.second);
  const double curvature = full > 1e-2 * square ? full : square;
  if (!(curvature > 0)) return 0;
  return std::clamp(parameter - slope / curvature, 0.0, 1.0) - parameter;
}

}  // namespace

OnCubicTriangle closest_on(const CubicTriangle& patch, const Vec3& x, const Weights& weights) {
  Weights w = weights;
  SurfacePoint s = evaluate(patch, w);
  double square = dot(s.x - x, s.x - x);
  int iterations = 0;
  while (iterations < most_iterations) {
    const Model model = model_at(s, s.x - x);
    Step step = newton_step(model);
    if (leaves(w, step)) step = step_on_border(w, model);
    const double size = largest_of(step);
    if (!(size > 0)) break;
    ++iterations;
    bool is_closer = false;
    for (int halving = 0; halving < most_halvings && !is_closer; ++halving) {
      const Weights to = moved(w, step);
      const SurfacePoint there = evaluate(patch, to);
      const double square_there = dot(there.x - x, there.x - x);
      is_closer = square_there <= rounding * square;
      if (is_closer) w = to, s = there, square = square_there;
      for (double& d : step) d *= 0.5;
      if (size < smallest_step) break;
    }
    if (!is_closer || size < smallest_step) break;
  }
  return {s.x, cross(s.u, s.v), w, square, iterations};
}

OnCubicSegment closest_on(const CubicSegment& curve, const Vec3& x, double parameter) {
  CurvePoint c = evaluate(curve, parameter);
  double square = dot(c.x - x, c.x - x);
  for (int i = 0; i < most_iterations; ++i) {
    double step = step_on_curve(c, c.x - x, parameter);
    const double size = std::abs(step);
    bool is_closer = false;
    for (int halving = 0; halving < most_halvings && !is_closer && size > 0; ++halving) {
      const CurvePoint there = evaluate(curve, parameter + step);
      const double square_there = dot(there.x - x, there.x - x);
      is_closer = square_there <= rounding * square;
      if (is_closer) parameter += step, c = there, square = square_there;
      step *= 0.5;
    }
    if (!is_closer || size < smallest_step) break;
  }
  return {c.x, parameter, square};
}

}  // namespace taut
