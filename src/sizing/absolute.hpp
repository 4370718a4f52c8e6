// |H|: Hessians with positive eigenvalues.
#pragma once

#include <vector>

#include "metric/spectral.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The absolute values of the eigenvalues, ascending, each at least 1e-10 of the largest in the whole field: where a
/// field is linear in some direction the eigenvalue is zero but for rounding, and neither its sign nor a power of it
/// means anything. 1 everywhere for a field whose Hessian is zero everywhere.
[[nodiscard]] std::vector<Spectrum> absolute_spectra(const Tensors& hessian);

}  // namespace taut
