// Quality of a tetrahedron and of an edge length in a metric (Dobrzynski and Frey 2008, 2.3).
#pragma once

#include <cmath>
#include <numbers>

#include "base/sym3.hpp"
#include "base/vec3.hpp"
#include "metric/cholesky.hpp"

namespace taut {

/// Sum over the six edges of e^T M e.
constexpr double sum_of_squared_lengths(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, const Sym3& m) {
  return quadratic_form(m, p1 - p0) + quadratic_form(m, p2 - p0) + quadratic_form(m, p3 - p0) +
         quadratic_form(m, p2 - p1) + quadratic_form(m, p3 - p1) + quadratic_form(m, p3 - p2);
}

/// 1/Q = 72 sqrt(3) |K| sqrt(det M) / (sum over 6 edges of e^T M e)^(3/2): 1 for an element that is regular in M, 0 for
/// a flat one; the sign is that of the volume.
inline double shape_quality(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, const Sym3& m) {
  const double sum = sum_of_squared_lengths(p0, p1, p2, p3, m);
  const double six_metric_volumes = six_volumes(p0, p1, p2, p3) * std::sqrt(determinant_spd(m));
  return 12 * std::numbers::sqrt3 * six_metric_volumes / (sum * std::sqrt(sum));
}

/// The same with the mean of the metrics of the four vertices.
inline double shape_quality(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, const Sym3& m0,
                            const Sym3& m1, const Sym3& m2, const Sym3& m3) {
  return shape_quality(p0, p1, p2, p3, 0.25 * ((m0 + m1) + (m2 + m3)));
}

/// Mean ratio Q^(-2/3) in one metric: 12 (3 |K| sqrt(det M))^(2/3) / sum of e^T M e, with the sign of the volume.
inline double mean_ratio(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, const Sym3& m) {
  const double root = std::cbrt(0.5 * six_volumes(p0, p1, p2, p3) * std::sqrt(determinant_spd(m)));
  return std::copysign(12 * root * root, root) / sum_of_squared_lengths(p0, p1, p2, p3, m);
}

/// Contribution of an edge of length l to the efficiency index, eq. (2): tau = exp(mean of phi over all edges).
constexpr double efficiency_phi(double l) {
  return l < 1 ? l - 1 : 1 / l - 1;
}

}  // namespace taut
