#include "sizing/optimal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "sizing/absolute.hpp"
#include "sizing/limits.hpp"
#include "taut/error.hpp"

namespace taut {

void require_options(const LpOptions& o) {
  require_limits(o.limits);
  if (!(o.complexity > 0 && std::isfinite(o.complexity)))
    throw InputError(fmt::format("complexity {} found, expected a number above 0", o.complexity));
  if (!(o.norm >= 1)) throw InputError(fmt::format("norm {} found, expected 1 or more", o.norm));
}

double lp_exponent(double norm) {
  return std::isfinite(norm) ? -1 / (2 * norm + 3) : 0;
}

std::vector<Spectrum> optimal_spectra(std::vector<Spectrum> absolute, double norm) {
  const double exponent = lp_exponent(norm);
  for_each_index(absolute.size(), [&](std::size_t v) {
    Vec3& l = absolute[v].values;
    l = std::pow(l[0] * l[1] * l[2], exponent) * l;
  });
  return absolute;
}

std::vector<Spectrum> optimal_spectra(const Tensors& hessian, double norm) {
  std::vector<Spectrum> absolute = absolute_spectra(hessian);
  raise_flat(absolute, largest_eigenvalue(absolute));
  return optimal_spectra(std::move(absolute), norm);
}

}  // namespace taut
