#include "sizing/scaling.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/edges.hpp"
#include "sizing/complexity.hpp"
#include "sizing/limits.hpp"
#include "sizing/root.hpp"
#include "sizing/truncation.hpp"

namespace taut {
namespace {

constexpr double tolerance = 2e-3;  // relative, of the complexity
constexpr int most_evaluations = 40;

double product(const Vec3& v) {
  return v[0] * v[1] * v[2];
}

/// A metric up to a factor, on a mesh.
class Shape {
public:
  Shape(const Mesh& mesh, std::vector<Spectrum> spectra, const Limits& limits)
      : mesh_(mesh), spectra_(std::move(spectra)), limits_(limits), volumes_(volumes_of_points(mesh)) {
    if (limits.gradation) edges_ = edges_of(mesh.tetrahedra);
  }

  [[nodiscard]] double volume() const {
    return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) { sum += volumes_[v]; });
  }

  /// Without gradation, which takes most of the time.
  [[nodiscard]] double ungraded_complexity(double factor) const {
    return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) {
      sum += volumes_[v] * std::sqrt(product(truncate(factor * spectra_[v].values, limits_)));
    });
  }

  [[nodiscard]] std::vector<Sym3> metric(double factor) const {
    std::vector<Sym3> metrics(spectra_.size());
    for_each_index(metrics.size(), [&](std::size_t v) {
      const Vec3 values = truncate(factor * spectra_[v].values, limits_);
      metrics[v] = assemble({values, spectra_[v].vectors});
    });
    return graded(mesh_, edges_, std::move(metrics), limits_);
  }

  [[nodiscard]] double complexity_of(const std::vector<Sym3>& metrics) const {
    return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) {
      sum += volumes_[v] * std::sqrt(determinant_spd(metrics[v]));
    });
  }

private:
  const Mesh& mesh_;
  std::vector<Spectrum> spectra_;
  Limits limits_;
  std::vector<double> volumes_;
  std::vector<std::array<Index, 2>> edges_;
};

/// What the bounds leave of the wanted complexity, and the bound that takes the rest.
std::pair<double, const char*> reachable(double wanted, double volume, const Limits& limits) {
  const double most =
      limits.hmin > 0 ? volume / (limits.hmin * limits.hmin * limits.hmin) : std::numeric_limits<double>::infinity();
  const double least = volume / (limits.hmax * limits.hmax * limits.hmax);
  if (wanted > most) return {most, "hmin"};
  if (wanted < least) return {least, "hmax"};
  return {wanted, ""};
}

}  // namespace

ScaledMetric scaled_to(double wanted, const Mesh& mesh, std::vector<Spectrum> spectra, const Limits& limits) {
  const Shape shape(mesh, std::move(spectra), limits);
  ScaledMetric result;
  const auto [goal, bound] = reachable(wanted, shape.volume(), limits);
  result.stopped_by = bound;

  RootSearch ungraded(tolerance, most_evaluations);
  while (!ungraded.done()) ungraded.add(std::log(shape.ungraded_complexity(std::exp(ungraded.next())) / goal));
  RootSearch graded(tolerance, most_evaluations, ungraded.next());
  while (!graded.done()) {
    result.metric = shape.metric(std::exp(graded.next()));
    result.complexity = shape.complexity_of(result.metric);
    ++result.evaluations;
    graded.add(std::log(result.complexity / goal));
  }
  return result;
}

}  // namespace taut
