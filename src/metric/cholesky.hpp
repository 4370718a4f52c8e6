// Factorisation of a symmetric tensor, and what follows from its pivots.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// M = L D L^T with unit lower triangular L; all of `pivots` positive if and only if M is positive definite.
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

/// det M of a positive definite M. Expansion by cofactors loses (h_max/h_min)^4 units in the last place on a rotated
/// metric, that is everything at the ratio 1e4; the pivots lose (h_max/h_min)^2, which is what six doubles can hold.
constexpr double determinant_spd(const Sym3& m) {
  const Vec3 d = ldl(m).pivots;
  return d[0] * d[1] * d[2];
}

/// False also if an entry is not finite.
constexpr bool is_positive_definite(const Sym3& m) {
  for (const double entry : m) {
    if (!(entry - entry == 0)) return false;
  }
  const Vec3 d = ldl(m).pivots;
  return d[0] > 0 && d[1] > 0 && d[2] > 0;
}

/// n <= bound * m in the Loewner order: no direction in which n asks for a length above sqrt(bound) times that in m.
constexpr bool is_dominated(const Sym3& n, const Sym3& m, double bound = 1) {
  const Vec3 d = ldl(bound * m + (-1.0) * n).pivots;
  return d[0] > 0 && d[1] > 0 && d[2] > 0;
}

}  // namespace taut
