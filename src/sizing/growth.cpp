#include "sizing/growth.hpp"

#include <algorithm>
#include <cmath>

#include "metric/length.hpp"

namespace taut {
namespace {

/// x^y. The exponent is 1 by default; the library's function does not take that shortcut.
double power(double x, double y) {
  return y == 1 ? x : std::pow(x, y);
}

}  // namespace

Growth::Growth(const Gradation& gradation)
    : log_beta_(std::log(gradation.beta)), of_metric_(2 * (1 - gradation.mix)), of_physical_(2 * gradation.mix) {}

Sym3 Growth::demand(Spectrum s, const Vec3& e) const {
  // Rounding may make the smallest eigenvalue of an extremely stretched metric negative.
  for (double& lambda : s.values) lambda = std::max(lambda, 0.0);
  double squared_length = 0;
  for (int i = 0; i < 3; ++i) squared_length += s.values[i] * dot(s.vectors[i], e) * dot(s.vectors[i], e);
  const double in_metric = power(1 + std::sqrt(squared_length) * log_beta_, of_metric_);
  const double distance = norm(e) * log_beta_;
  for (double& lambda : s.values) lambda /= in_metric * power(1 + std::sqrt(lambda) * distance, of_physical_);
  return assemble(s);
}

bool Growth::surely_met(const Sym3& mp, const Sym3& mq, const Vec3& e) const {
  // Equal metrics demand nothing of each other, however badly conditioned they are.
  if (mp == mq || meets(mq, mp)) return true;
  return meets(mq, mp, power(1 + length_in(mp, e) * log_beta_, of_metric_));
}

}  // namespace taut
