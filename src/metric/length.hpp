// Length of an edge in the metrics of its two end points (Dobrzynski and Frey 2008, 2.2).
#pragma once

#include <cmath>
#include <numbers>

#include "base/sym3.hpp"

namespace taut {

inline constexpr double longest_unit = std::numbers::sqrt2;       ///< a longer edge is split
inline constexpr double shortest_unit = std::numbers::sqrt2 / 2;  ///< a shorter one is collapsed

/// Whether an edge of this length needs no change.
constexpr bool is_unit(double length) {
  return length >= shortest_unit && length <= longest_unit;
}

/// sqrt(e^T M e).
inline double length_in(const Sym3& m, const Vec3& e) {
  return std::sqrt(quadratic_form(m, e));
}

/// (a - b) / log(a / b), a and b positive: the integral over [0, 1] of a^(1-t) b^t.
inline double logarithmic_mean(double a, double b) {
  const double sum = a + b;
  if (!(sum > 0)) return 0;
  const double r = (a - b) / sum;
  // r / atanh r; above, the quotient of two small differences would lose digits.
  const double rr = r * r;
  if (rr < 1e-4) return 0.5 * sum * (1 - rr * (1.0 / 3 + rr * (4.0 / 45 + rr * (44.0 / 945))));
  return (a - b) / std::log(a / b);
}

/// Simpson's rule for the same integral: within 1e-4 of it for a/b up to 2, 1 % up to 10; no logarithm.
inline double simpson_mean(double a, double b) {
  return (2 * std::sqrt(a * b) + 0.5 * (a + b)) / 3;
}

/// Length of pq where the size varies geometrically along it; for reports.
inline double edge_length(const Vec3& p, const Vec3& q, const Sym3& mp, const Sym3& mq) {
  const Vec3 e = q - p;
  return logarithmic_mean(length_in(mp, e), length_in(mq, e));
}

/// The same by Simpson's rule; for decisions.
inline double edge_length_fast(const Vec3& p, const Vec3& q, const Sym3& mp, const Sym3& mq) {
  const Vec3 e = q - p;
  return simpson_mean(length_in(mp, e), length_in(mq, e));
}

}  // namespace taut
