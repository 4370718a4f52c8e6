#include "metric/intersection.hpp"

#include <algorithm>
#include <limits>

#include "metric/spectral.hpp"

namespace taut {
namespace {

/// The error of a comparison with m: its condition number times the rounding of its entries.
double comparison_tolerance(const Sym3& m) {
  const Vec3 d = ldl(m).pivots;
  const double condition = (m[0] + m[3] + m[5]) / std::min({d[0], d[1], d[2]});
  return 1e-12 + 32 * std::numeric_limits<double>::epsilon() * condition;
}

/// With M = C C^T, the eigenvalues of C^-1 N C^-T are nu_i / mu_i, a symmetric and hence stable problem, and C times
/// its orthonormal eigenvectors are the columns of P^-T scaled by sqrt(mu_i). choose(ratio) is the eigenvalue of the
/// result.
template <class Choose>
Sym3 combined(const Sym3& m, const Sym3& n, Choose&& choose) {
  const Cholesky c = cholesky(m);
  Spectrum s = spectrum(congruent(n, [&](const Vec3& b) { return solve(c, b); }));
  for (int i = 0; i < 3; ++i) {
    s.values[i] = choose(s.values[i]);
    s.vectors[i] = multiply(c, s.vectors[i]);
  }
  return assemble(s);
}

}  // namespace

Sym3 intersect(const Sym3& m, const Sym3& n) {
  if (is_dominated(n, m, 1 + comparison_tolerance(m))) return m;
  if (is_dominated(m, n, 1 + comparison_tolerance(n))) return n;
  return combined(m, n, [](double ratio) { return std::max(ratio, 1.0); });
}

Sym3 capped(const Sym3& m, const Sym3& bound) {
  if (is_dominated(m, bound, 1 + comparison_tolerance(bound))) return m;
  if (is_dominated(bound, m, 1 + comparison_tolerance(m))) return bound;
  return combined(bound, m, [](double ratio) { return std::min(ratio, 1.0); });
}

}  // namespace taut
