#include "metric/intersection.hpp"

#include <algorithm>
#include <limits>

#include "metric/spectral.hpp"

namespace taut {
namespace {

/// The lower triangular factor of M = C C^T.
struct Cholesky {
  double c00, c10, c11, c20, c21, c22;
};

Cholesky cholesky(const Sym3& m) {
  const Ldl f = ldl(m);
  const double r0 = std::sqrt(f.pivots[0]), r1 = std::sqrt(f.pivots[1]), r2 = std::sqrt(f.pivots[2]);
  return {r0, f.l10 * r0, r1, f.l20 * r0, f.l21 * r1, r2};
}

Vec3 solve(const Cholesky& c, const Vec3& b) {
  const double x0 = b[0] / c.c00;
  const double x1 = (b[1] - c.c10 * x0) / c.c11;
  return {x0, x1, (b[2] - c.c20 * x0 - c.c21 * x1) / c.c22};
}

Vec3 multiply(const Cholesky& c, const Vec3& x) {
  return {c.c00 * x[0], c.c10 * x[0] + c.c11 * x[1], c.c20 * x[0] + c.c21 * x[1] + c.c22 * x[2]};
}

/// C^-1 N C^-T.
Sym3 reduce(const Cholesky& c, const Sym3& n) {
  const Vec3 x = solve(c, {n[0], n[1], n[2]}), y = solve(c, {n[1], n[3], n[4]}), z = solve(c, {n[2], n[4], n[5]});
  // (x, y, z) holds C^-1 N by columns; its rows are solved in the same way.
  const Vec3 r0 = solve(c, {x[0], y[0], z[0]}), r1 = solve(c, {x[1], y[1], z[1]}), r2 = solve(c, {x[2], y[2], z[2]});
  return {r0[0], r1[0], r2[0], r1[1], r2[1], r2[2]};
}

/// The error of a comparison with m: its condition number times the rounding of its entries.
double comparison_tolerance(const Sym3& m) {
  const Vec3 d = ldl(m).pivots;
  const double condition = (m[0] + m[3] + m[5]) / std::min({d[0], d[1], d[2]});
  return 1e-12 + 32 * std::numeric_limits<double>::epsilon() * condition;
}

}  // namespace

// With M = C C^T, the eigenvalues of C^-1 N C^-T are nu_i / mu_i, a symmetric and hence stable problem, and C times its
// orthonormal eigenvectors are the columns of P^-T scaled by sqrt(mu_i).
Sym3 intersect(const Sym3& m, const Sym3& n) {
  if (is_dominated(n, m, 1 + comparison_tolerance(m))) return m;
  if (is_dominated(m, n, 1 + comparison_tolerance(n))) return n;
  const Cholesky c = cholesky(m);
  Spectrum s = spectrum(reduce(c, n));
  for (int i = 0; i < 3; ++i) {
    s.values[i] = std::max(s.values[i], 1.0);
    s.vectors[i] = multiply(c, s.vectors[i]);
  }
  return assemble(s);
}

}  // namespace taut
