// Linear interpolation at places that are known.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "locate/places.hpp"
#include "transfer/values.hpp"

namespace taut {

/// The sums of weights times values, one for each component, kept between the least and the greatest of the values:
/// rounding must not make a new extremum. `row(k)` are the values at vertex k.
template <class Row>
void interpolate_at(const std::array<double, 4>& weights, const Row& row, std::span<double> result) {
  for (std::size_t c = 0; c < result.size(); ++c) {
    const std::array<double, 4> u = {row(0)[c], row(1)[c], row(2)[c], row(3)[c]};
    const double sum = weights[0] * u[0] + weights[1] * u[1] + weights[2] * u[2] + weights[3] * u[3];
    const double low = std::min(std::min(u[0], u[1]), std::min(u[2], u[3]));
    const double high = std::max(std::max(u[0], u[1]), std::max(u[2], u[3]));
    result[c] = std::clamp(sum, low, high);
  }
}

/// `values` at the vertices of `mesh`, interpolated at each place.
[[nodiscard]] Values interpolated(const Background& mesh, const Values& values, std::span<const Place> places);

}  // namespace taut
