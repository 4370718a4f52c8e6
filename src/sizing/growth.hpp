// How fast the size wanted at one vertex may grow towards another.
#pragma once

#include "base/sym3.hpp"
#include "metric/cholesky.hpp"
#include "metric/spectral.hpp"
#include "taut/gradation.hpp"

namespace taut {

/// What a metric M_p demands of the metric at q along an edge e = q - p: M_p with each eigenvalue lambda divided by
/// (1 + l ln beta)^(2 (1 - mix)) (1 + sqrt(lambda) |e| ln beta)^(2 mix), where l is the length of e in M_p (Alauzet
/// 2010).
class Growth {
public:
  explicit Growth(const Gradation& gradation);

  /// The demand of the metric with the spectrum `s` along e.
  [[nodiscard]] Sym3 demand(Spectrum s, const Vec3& e) const;

  /// Whether mq meets the demand of mp along e, by a quick test without the spectrum: true is certain, false is not.
  [[nodiscard]] bool surely_met(const Sym3& mp, const Sym3& mq, const Vec3& e) const;

private:
  double log_beta_, of_metric_, of_physical_;  ///< the logarithm and the two exponents
};

/// Whether `m` meets the demand, up to a thousandth of an eigenvalue: smaller corrections would take many more visits.
constexpr bool meets(const Sym3& m, const Sym3& demand, double factor = 1) {
  constexpr double tolerance = 1e-3;
  return is_dominated(demand, m, factor * (1 + tolerance));
}

}  // namespace taut
