// The metric that is optimal for an L^p norm, up to a factor.
#pragma once

#include <vector>

#include "metric/spectral.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// Throws InputError for options that make no sense.
void require_options(const LpOptions& options);

/// How the density of elements follows from the error, up to the factor that all places have in common.
struct Optimum {
  double norm = 2;   ///< p, may be infinite: the error is then the same everywhere
  double price = 1;  ///< of an element: the number of time steps for which it is computed
};

/// The eigenvalues, ascending, of the metric that is optimal where |H| has these eigenvalues l_i, ascending, none
/// negative, and no size may be above hmax. With n sizes below it, the error s = l_i h_i^2 along these is such that
/// s^(p + n/2) is proportional to the density of elements times s^(n/2), that is, to price sqrt(product of these l_i)
/// hmax^(n-3). For n = 3 this is det|H|^(-1/(2p+3)) |H| (Alauzet and Loseille 2010), which has no meaning where a field
/// is linear in some direction: there det|H| is rounding, and yet would decide on the size across a front.
[[nodiscard]] Vec3 optimal_eigenvalues(const Vec3& l, double log_factor, const Optimum& optimum, double hmax);

}  // namespace taut
