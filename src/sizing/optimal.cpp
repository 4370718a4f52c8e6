#include "sizing/optimal.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sizing/limits.hpp"
#include "taut/error.hpp"

namespace taut {

void require_options(const LpOptions& o) {
  require_limits(o.limits);
  if (!(o.complexity > 0 && std::isfinite(o.complexity)))
    throw InputError(fmt::format("complexity {} found, expected a number above 0", o.complexity));
  if (!(o.norm >= 1)) throw InputError(fmt::format("norm {} found, expected 1 or more", o.norm));
}

Vec3 optimal_eigenvalues(const Vec3& l, double log_factor, const Optimum& optimum, double hmax) {
  const double p = optimum.norm, log_hmax = std::log(hmax);
  for (int n = 3; n > 0; --n) {
    const auto smallest = static_cast<std::size_t>(3 - n);
    if (!(l[smallest] > 0)) continue;
    double log_error = -log_factor;
    if (std::isfinite(p)) {
      double log_density = std::log(optimum.price) - (3 - n) * log_hmax;
      for (std::size_t i = smallest; i < 3; ++i) log_density += 0.5 * std::log(l[i]);
      log_error = (log_density - (p + 1.5) * log_factor) / (p + 0.5 * n);
    }
    if (std::log(l[smallest]) - log_error < -2 * log_hmax) continue;
    Vec3 values = {1 / (hmax * hmax), 1 / (hmax * hmax), 1 / (hmax * hmax)};
    for (std::size_t i = smallest; i < 3; ++i) values[i] = std::exp(std::log(l[i]) - log_error);
    return values;
  }
  return {1 / (hmax * hmax), 1 / (hmax * hmax), 1 / (hmax * hmax)};
}

}  // namespace taut
