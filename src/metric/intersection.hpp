// Two wishes at one point: the metric that grants both.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// The metric whose unit ball is the largest ellipsoid in the basis common to m and n that lies inside both unit balls:
/// with e_i the eigenvectors of m^-1 n, P = (e_1, e_2, e_3), mu_i = e_i^T m e_i and nu_i = e_i^T n e_i,
/// P^-T diag(max(mu_i, nu_i)) P^-1 (Dobrzynski and Frey 2008, 2.2). Both must be positive definite.
///
/// Where one of the two already grants the other (to 1e-12, or to rounding where that is more), it is returned bit for
/// bit. The result is not an upper bound for what bounds m and n: where both are stretched, askew to each other, it
/// asks for sizes below the smallest of either.
[[nodiscard]] Sym3 intersect(const Sym3& m, const Sym3& n);

}  // namespace taut
