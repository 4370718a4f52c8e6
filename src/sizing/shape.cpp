#include "sizing/shape.hpp"

#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "mesh/edges.hpp"
#include "sizing/complexity.hpp"
#include "sizing/limits.hpp"
#include "sizing/truncation.hpp"

namespace taut {

Shape::Shape(const Mesh& mesh, std::vector<Spectrum> absolute, const Optimum& optimum, const Limits& limits)
    : mesh_(&mesh),
      absolute_(std::move(absolute)),
      optimum_(optimum),
      limits_(limits),
      volumes_(volumes_of_points(mesh)) {
  if (limits.gradation) edges_ = edges_of(mesh.tetrahedra);
}

double Shape::volume() const {
  return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) { sum += volumes_[v]; });
}

Vec3 Shape::eigenvalues(std::size_t v, double log_factor) const {
  return truncate(optimal_eigenvalues(absolute_[v].values, log_factor, optimum_, limits_.hmax), limits_);
}

double Shape::ungraded_complexity(double log_factor) const {
  return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) {
    const Vec3 l = eigenvalues(v, log_factor);
    sum += volumes_[v] * std::sqrt(l[0] * l[1] * l[2]);
  });
}

std::vector<Sym3> Shape::metric(double log_factor) const {
  std::vector<Sym3> metrics(absolute_.size());
  for_each_index(metrics.size(), [&](std::size_t v) {
    metrics[v] = assemble({eigenvalues(v, log_factor), absolute_[v].vectors});
  });
  return graded(*mesh_, edges_, std::move(metrics), limits_);
}

double Shape::complexity_of(std::span<const Sym3> metrics) const {
  return sum_in_order<double>(volumes_.size(), [&](double& sum, std::size_t v) {
    sum += volumes_[v] * std::sqrt(determinant_spd(metrics[v]));
  });
}

}  // namespace taut
