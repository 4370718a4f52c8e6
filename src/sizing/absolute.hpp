// |H|: Hessians with positive eigenvalues.
#pragma once

#include <span>
#include <vector>

#include "metric/spectral.hpp"
#include "taut/metric.hpp"

namespace taut {

/// With the absolute values of the eigenvalues, ascending.
[[nodiscard]] std::vector<Spectrum> absolute_spectra(const Tensors& hessian);

/// Of the whole field.
[[nodiscard]] double largest_eigenvalue(std::span<const Spectrum> spectra);

/// Divides all eigenvalues: the unit of a field makes no difference to its metric.
void divide(std::vector<Spectrum>& spectra, double by);

/// Raises all eigenvalues to at least 1e-10 of `largest`, or to 1 if that is 0: where a field is linear in some
/// direction the eigenvalue is zero but for rounding, and no power of it means anything.
void raise_flat(std::vector<Spectrum>& spectra, double largest);

}  // namespace taut
