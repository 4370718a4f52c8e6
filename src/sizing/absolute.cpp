#include "sizing/absolute.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace taut {
namespace {

constexpr double flatness = 1e-10;

Spectrum with_ascending_magnitudes(const Spectrum& s) {
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::abs(s.values[i]); });
  Spectrum sorted{};
  for (std::size_t i = 0; i < 3; ++i) {
    sorted.values[i] = std::abs(s.values[order[i]]);
    sorted.vectors[i] = s.vectors[order[i]];
  }
  return sorted;
}

struct Largest {
  double value = 0;
  Largest& operator+=(const Largest& other) {
    value = std::max(value, other.value);
    return *this;
  }
};

}  // namespace

std::vector<Spectrum> absolute_spectra(const Tensors& hessian) {
  std::vector<Spectrum> spectra(hessian.size());
  for_each_index(spectra.size(), [&](std::size_t v) { spectra[v] = with_ascending_magnitudes(spectrum(hessian[v])); });
  return spectra;
}

double largest_eigenvalue(std::span<const Spectrum> spectra) {
  const auto add = [&](Largest& most, std::size_t v) { most += Largest{spectra[v].values[2]}; };
  return sum_in_order<Largest>(spectra.size(), add).value;
}

void divide(std::vector<Spectrum>& spectra, double by) {
  for_each_index(spectra.size(), [&](std::size_t v) { spectra[v].values = 1 / by * spectra[v].values; });
}

void raise_flat(std::vector<Spectrum>& spectra, double largest) {
  const double least = largest > 0 ? flatness * largest : 1;
  for_each_index(spectra.size(), [&](std::size_t v) {
    for (double& value : spectra[v].values) value = std::max(value, least);
  });
}

}  // namespace taut
