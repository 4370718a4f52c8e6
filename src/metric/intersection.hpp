// The intersection of two metrics at a point.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// The metric whose unit ball is the largest ellipsoid, in the basis common to m and n, that lies inside both unit
/// balls: P^-T diag(max(mu_i, nu_i)) P^-1, where e_i are the eigenvectors of m^-1 n, P = (e_1, e_2, e_3), mu_i =
/// e_i^T m e_i and nu_i = e_i^T n e_i (Dobrzynski and Frey 2008, 2.2). Both must be positive definite.
///
/// If one of the two is already at least the other (to 1e-12, or to rounding if that is larger), it is returned bit for
/// bit. A bound on m and n does not bound the result: if both are stretched in oblique directions, its sizes can be
/// below the smallest size of either.
[[nodiscard]] Sym3 intersect(const Sym3& m, const Sym3& n);

/// The opposite in the same basis: P^-T diag(min(mu_i, nu_i)) P^-1. No length in it is above that in `bound`.
[[nodiscard]] Sym3 capped(const Sym3& m, const Sym3& bound);

}  // namespace taut
