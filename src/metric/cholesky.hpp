// Factorisation of a symmetric tensor, and what follows from its pivots.
#pragma once

#include <cmath>

#include "base/sym3.hpp"

namespace taut {

/// M = L D L^T with unit lower triangular L. M is positive definite if and only if all `pivots` are positive.
struct Ldl {
  Vec3 pivots;
  double l10, l20, l21;
};

constexpr Ldl ldl(const Sym3& m) {
  const double inverse = 1 / m[0];
  const double l10 = m[1] * inverse, l20 = m[2] * inverse;
  const double d1 = m[3] - l10 * m[1];
  const double rest = m[4] - l20 * m[1];
  const double l21 = rest / d1;
  return {{m[0], d1, m[5] - l20 * m[2] - l21 * rest}, l10, l20, l21};
}

/// det M of a positive definite M. On a rotated metric, expansion by cofactors loses (h_max/h_min)^4 units in the last
/// place, which is everything at a ratio of 1e4. The pivots lose (h_max/h_min)^2, and six doubles cannot hold more.
constexpr double determinant_spd(const Sym3& m) {
  const Vec3 d = ldl(m).pivots;
  return d[0] * d[1] * d[2];
}

/// Also false if an entry is not finite.
constexpr bool is_positive_definite(const Sym3& m) {
  for (const double entry : m) {
    if (!(entry - entry == 0)) return false;
  }
  const Vec3 d = ldl(m).pivots;
  return d[0] > 0 && d[1] > 0 && d[2] > 0;
}

/// n <= bound * m in the Loewner order: in no direction is the length in n above sqrt(bound) times the length in m.
constexpr bool is_dominated(const Sym3& n, const Sym3& m, double bound = 1) {
  const Vec3 d = ldl(bound * m + (-1.0) * n).pivots;
  return d[0] > 0 && d[1] > 0 && d[2] > 0;
}

/// The lower triangular factor of M = C C^T.
struct Cholesky {
  double c00, c10, c11, c20, c21, c22;
};

/// M must be positive definite.
inline Cholesky cholesky(const Sym3& m) {
  const Ldl f = ldl(m);
  const double r0 = std::sqrt(f.pivots[0]), r1 = std::sqrt(f.pivots[1]), r2 = std::sqrt(f.pivots[2]);
  return {r0, f.l10 * r0, r1, f.l20 * r0, f.l21 * r1, r2};
}

/// C^-1 b.
constexpr Vec3 solve(const Cholesky& c, const Vec3& b) {
  const double x0 = b[0] / c.c00;
  const double x1 = (b[1] - c.c10 * x0) / c.c11;
  return {x0, x1, (b[2] - c.c20 * x0 - c.c21 * x1) / c.c22};
}

/// C^-T b.
constexpr Vec3 solve_transposed(const Cholesky& c, const Vec3& b) {
  const double x2 = b[2] / c.c22;
  const double x1 = (b[1] - c.c21 * x2) / c.c11;
  return {(b[0] - c.c10 * x1 - c.c20 * x2) / c.c00, x1, x2};
}

/// C x.
constexpr Vec3 multiply(const Cholesky& c, const Vec3& x) {
  return {c.c00 * x[0], c.c10 * x[0] + c.c11 * x[1], c.c20 * x[0] + c.c21 * x[1] + c.c22 * x[2]};
}

/// A N A^T, where apply(b) is A b.
template <class Apply>
constexpr Sym3 congruent(const Sym3& n, Apply&& apply) {
  const Vec3 x = apply(Vec3{n[0], n[1], n[2]}), y = apply(Vec3{n[1], n[3], n[4]}), z = apply(Vec3{n[2], n[4], n[5]});
  // (x, y, z) holds A N by columns; A is applied to its rows in the same way.
  const Vec3 r0 = apply(Vec3{x[0], y[0], z[0]}), r1 = apply(Vec3{x[1], y[1], z[1]}), r2 = apply(Vec3{x[2], y[2], z[2]});
  return {r0[0], r1[0], r2[0], r1[1], r2[1], r2[2]};
}

}  // namespace taut
