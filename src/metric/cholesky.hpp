// Factorisation of a symmetric tensor, and what follows from its pivots.
#pragma once

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

}  // namespace taut
