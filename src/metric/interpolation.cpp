#include "metric/interpolation.hpp"

#include <cassert>
#include <cmath>

#include "metric/spectral.hpp"

namespace taut {
namespace {

/// M^(-1/2), whose eigenvalues are the sizes.
Sym3 sizes_of(const Sym3& m) {
  return map_eigenvalues(m, [](double lambda) { return 1 / std::sqrt(lambda); });
}

}  // namespace

Sym3 interpolate_linear_in_size(const Sym3& mp, const Sym3& mq, double t) {
  const Sym3 sizes = (1 - t) * sizes_of(mp) + t * sizes_of(mq);
  return map_eigenvalues(sizes, [](double h) { return 1 / (h * h); });
}

Sym3 interpolate_logarithms(std::span<const Sym3> logarithms, std::span<const double> weights) {
  assert(logarithms.size() == weights.size());
  Sym3 sum{};
  for (std::size_t i = 0; i < logarithms.size(); ++i) sum = sum + weights[i] * logarithms[i];
  return exp_metric(sum);
}

Sym3 interpolate_log_euclidean(std::span<const Sym3> metrics, std::span<const double> weights) {
  assert(metrics.size() == weights.size());
  Sym3 sum{};
  for (std::size_t i = 0; i < metrics.size(); ++i) sum = sum + weights[i] * log_metric(metrics[i]);
  return exp_metric(sum);
}

}  // namespace taut
