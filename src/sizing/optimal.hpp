// The metric that is optimal for an L^p norm, up to a factor.
#pragma once

#include <vector>

#include "metric/spectral.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// Throws InputError for options that make no sense.
void require_options(const LpOptions& options);

/// The power of det|H| in the metric, -1 / (2p+3): 0 for the maximum norm, which weighs all places alike.
[[nodiscard]] double lp_exponent(double norm);

/// det|H|^(-1/(2p+3)) |H| at each point, |H| positive definite (Alauzet and Loseille 2010).
[[nodiscard]] std::vector<Spectrum> optimal_spectra(std::vector<Spectrum> absolute, double norm);

/// The same of Hessians whose flat places are raised.
[[nodiscard]] std::vector<Spectrum> optimal_spectra(const Tensors& hessian, double norm);

}  // namespace taut
