// Functions of a symmetric tensor that are defined by its eigenvalues.
#pragma once

#include "base/sym3.hpp"
#include "metric/cholesky.hpp"

namespace taut {

/// M = sum of values[i] vectors[i] vectors[i]^T; values in ascending order, vectors orthonormal.
struct Spectrum {
  Vec3 values;
  std::array<Vec3, 3> vectors;
};

[[nodiscard]] Spectrum spectrum(const Sym3& m);
[[nodiscard]] Sym3 assemble(const Spectrum& s);

/// Isotropic metric of the wanted size h: h^-2 I (Dobrzynski and Frey 2008, 2.2).
constexpr Sym3 metric_of_size(double h) {
  const double lambda = 1 / (h * h);
  return {lambda, 0, 0, lambda, 0, lambda};
}

/// P diag(f(l1), f(l2), f(l3)) P^T, where M = P diag(l1, l2, l3) P^T.
template <class F>
[[nodiscard]] Sym3 map_eigenvalues(const Sym3& m, F&& f) {
  Spectrum s = spectrum(m);
  for (double& value : s.values) value = f(value);
  return assemble(s);
}

/// Logarithm of a positive definite tensor.
[[nodiscard]] Sym3 log_metric(const Sym3& m);

/// Exponential of a symmetric tensor, always positive definite: eigenvalues below 1e-13 of the largest are raised to
/// that (a ratio of 3e6 in size), because the rounding of six doubles would hide them. The error is a few units in the
/// last place of the largest entry. The same input gives the same bits; a diagonal tensor stays diagonal.
[[nodiscard]] Sym3 exp_metric(const Sym3& l);

}  // namespace taut
