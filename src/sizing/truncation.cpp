#include "sizing/truncation.hpp"

#include <algorithm>

#include "metric/spectral.hpp"

namespace taut {

Vec3 truncate(const Vec3& eigenvalues, const Limits& limits) {
  // A margin for the rounding of the eigenvalues, so that truncating twice changes nothing.
  constexpr double slack = 1e-12;
  const double ratio = 1 / (limits.anisotropy * limits.anisotropy);
  const double lowest = 1 / (limits.hmax * limits.hmax), highest = 1 / (limits.hmin * limits.hmin);
  Vec3 values = eigenvalues;
  for (double& lambda : values) {
    const double least = std::max(ratio * eigenvalues[2], lowest);
    if (lambda < least * (1 - slack)) lambda = least;
    if (lambda > highest * (1 + slack)) lambda = highest;
  }
  return values;
}

Sym3 truncate(const Sym3& m, const Limits& limits) {
  Spectrum s = spectrum(m);
  const Vec3 values = truncate(s.values, limits);
  if (values == s.values) return m;
  s.values = values;
  return assemble(s);
}

}  // namespace taut
