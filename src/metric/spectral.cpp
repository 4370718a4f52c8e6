#include "metric/spectral.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace taut {
namespace {

/// ln 1e13: six doubles cannot hold eigenvalues that differ by more than this factor.
constexpr double largest_spread = 29.933606208922594;

/// 1/n!, n = 0..15. The first term left out is below 0.5^16/16! = 1e-18.
constexpr std::array<double, 16> inverse_factorials = [] {
  std::array<double, 16> c{1};
  for (std::size_t n = 1; n < c.size(); ++n) c[n] = c[n - 1] / static_cast<double>(n);
  return c;
}();

constexpr Sym3 square(const Sym3& a) {
  return {a[0] * a[0] + a[1] * a[1] + a[2] * a[2], a[0] * a[1] + a[1] * a[3] + a[2] * a[4],
          a[0] * a[2] + a[1] * a[4] + a[2] * a[5], a[1] * a[1] + a[3] * a[3] + a[4] * a[4],
          a[1] * a[2] + a[3] * a[4] + a[4] * a[5], a[2] * a[2] + a[4] * a[4] + a[5] * a[5]};
}

/// exp(S) for tr S = 0 and |S| <= 1/2 by the Taylor series. Cayley-Hamilton, S^3 = p S + q I with p = tr(S^2)/2 and
/// q = det S, keeps each power a combination of I, S and S^2: S^n = q z[n-1] I + (z[n+1]) S + z[n] S^2, where
/// z[n+1] = p z[n-1] + q z[n-2].
Sym3 exp_of_small(const Sym3& s, double p, double q) {
  double older = 0, old = 0, z = 1;  // z[n-2], z[n-1], z[n] at n = 2
  double of_identity = 1, of_s = 1, of_square = inverse_factorials[2];
  for (std::size_t n = 3; n < inverse_factorials.size(); ++n) {
    const double next = p * old + q * older;  // z[n]
    of_identity += inverse_factorials[n] * (q * z);
    older = old, old = z, z = next;
    of_s += inverse_factorials[n] * (p * old + q * older);  // z[n+1]
    of_square += inverse_factorials[n] * z;
  }
  return of_identity * identity3 + of_s * s + of_square * square(s);
}

/// For eigenvalues far apart: computed from the eigenvectors, with a limited spread.
Sym3 exp_by_spectrum(const Sym3& l) {
  const double lowest = spectrum(l).values[2] - largest_spread;
  return map_eigenvalues(l, [lowest](double value) { return std::exp(std::max(value, lowest)); });
}

}  // namespace

Spectrum spectrum(const Sym3& m) {
  Eigen::Matrix3d a;
  a << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  Spectrum s{};
  for (int i = 0; i < 3; ++i) {
    s.values[i] = solver.eigenvalues()[i];
    for (int k = 0; k < 3; ++k) s.vectors[i][k] = solver.eigenvectors()(k, i);
  }
  return s;
}

Sym3 assemble(const Spectrum& s) {
  Sym3 m{};
  for (int i = 0; i < 3; ++i) m = m + s.values[i] * outer(s.vectors[i]);
  return m;
}

Sym3 log_metric(const Sym3& m) {
  return map_eigenvalues(m, [](double value) { return std::log(value); });
}

// Scaling and squaring of the traceless part: there is no eigenproblem, so equal eigenvalues cause no trouble, and it
// takes a tenth of the time.
Sym3 exp_metric(const Sym3& l) {
  const double mean = (l[0] + l[3] + l[5]) / 3;
  Sym3 s = {l[0] - mean, l[1], l[2], l[3] - mean, l[4], l[5] - mean};
  double p = 0.5 * (s[0] * s[0] + s[3] * s[3] + s[5] * s[5]) + s[1] * s[1] + s[2] * s[2] + s[4] * s[4];
  // The eigenvalues of S lie within 2 sqrt(p) of each other and within sqrt(4p/3) of zero.
  if (!(4 * p <= largest_spread * largest_spread)) return exp_by_spectrum(l);
  int squarings = 0;
  double scale = 1;
  for (; p > 0.1875; p *= 0.25, scale *= 0.5) ++squarings;
  s = scale * s;
  Sym3 result = exp_of_small(s, p, determinant(s));
  for (; squarings > 0; --squarings) result = square(result);
  return std::exp(mean) * result;
}

}  // namespace taut
