#include "sizing/truncation.hpp"

#include <algorithm>

#include "metric/spectral.hpp"

namespace taut {

Sym3 truncate(const Sym3& m, double hmin, double hmax) {
  // A margin for the rounding of the eigenvalues, so that truncating twice changes nothing.
  constexpr double slack = 1e-12;
  const double lowest = 1 / (hmax * hmax), highest = 1 / (hmin * hmin);
  Spectrum s = spectrum(m);
  if (s.values[0] >= lowest * (1 - slack) && s.values[2] <= highest * (1 + slack)) return m;
  for (double& lambda : s.values) lambda = std::clamp(lambda, lowest, highest);
  return assemble(s);
}

}  // namespace taut
