// Metrics between points (Dobrzynski and Frey 2008, 2.2).
#pragma once

#include <span>

#include "base/sym3.hpp"

namespace taut {

/// Eq. (1), ((1-t) Mp^(-1/2) + t Mq^(-1/2))^(-2): the sizes vary linearly from p to q, t in [0, 1].
[[nodiscard]] Sym3 interpolate_linear_in_size(const Sym3& mp, const Sym3& mq, double t);

/// exp(sum of w_i L_i), L_i the logarithms of the metrics of any number of points, w_i weights of sum 1: the sizes vary
/// geometrically (log-Euclidean; Arsigny, Fillard, Pennec and Ayache 2006).
[[nodiscard]] Sym3 interpolate_logarithms(std::span<const Sym3> logarithms, std::span<const double> weights);

/// The same from the metrics themselves; slower, for it takes the logarithms.
[[nodiscard]] Sym3 interpolate_log_euclidean(std::span<const Sym3> metrics, std::span<const double> weights);

}  // namespace taut
