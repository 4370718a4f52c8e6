// A metric up to a factor, on a mesh.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "metric/spectral.hpp"
#include "sizing/optimal.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// Gives the optimal metric for |H| and any factor, within limits whose hmax is finite. The mesh must outlive it.
class Shape {
public:
  Shape(const Mesh& mesh, std::vector<Spectrum> absolute, const Optimum& optimum, const Limits& limits);

  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] double volume() const;

  /// Without gradation, which takes most of the time.
  [[nodiscard]] double ungraded_complexity(double log_factor) const;

  [[nodiscard]] std::vector<Sym3> metric(double log_factor) const;
  [[nodiscard]] double complexity_of(std::span<const Sym3> metrics) const;

private:
  [[nodiscard]] Vec3 eigenvalues(std::size_t v, double log_factor) const;

  const Mesh* mesh_;
  std::vector<Spectrum> absolute_;
  Optimum optimum_;
  Limits limits_;
  std::vector<double> volumes_;              ///< of the points
  std::vector<std::array<Index, 2>> edges_;  ///< only if there is a gradation
};

}  // namespace taut
