#include "surface/principal_curvatures.hpp"

#include <algorithm>
#include <cmath>

namespace taut {

// They are the eigenvalues of P H P / |g| with P = I - n n^T, besides the one of n, which is zero.
Spectrum principal_curvatures(const Derivatives& d) {
  const double slope = norm(d.gradient);
  const Vec3 normal = 1 / slope * d.gradient;
  const auto project = [&](const Vec3& b) { return b - dot(normal, b) * normal; };
  const Sym3 tangential = 1 / slope * congruent(d.hessian, project);
  // n is made the eigenvector of the largest eigenvalue, so that it is found whatever the curvatures are.
  const double apart =
      4 * std::max({std::abs(tangential[0]), std::abs(tangential[3]), std::abs(tangential[5]), 1e-300});
  return spectrum(tangential + 4 * apart * outer(normal));
}

}  // namespace taut
