// How good a mesh is: the measures of the field, and conformity.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The measures of a mesh in a metric (Dobrzynski and Frey 2008, 2.3). Lengths are the logarithmic mean of the lengths
/// in the metrics of the two end points. Q is 1 for a regular tetrahedron and grows; the mean ratio Q^(-2/3) lies in
/// (0, 1], larger is better, and uses the metric of largest determinant among the four vertices as the UGAWG does.
struct Quality {
  std::size_t vertices = 0, edges = 0, triangles = 0, tetrahedra = 0;
  double volume = 0;
  double complexity = 0;  ///< integral of sqrt(det M)
  double tau = 0;         ///< efficiency index, eq. (2) of the paper: 1 is perfect, 0.944 the practical limit
  double unit_edges = 0;  ///< share of edges of length in [1/sqrt 2, sqrt 2]
  double length_min = 0, length_max = 0;
  double Q_max = 0, Q_mean = 0, Q_up_to_2 = 0, Q_up_to_3 = 0;  ///< the last two are shares of the elements
  double mean_ratio_min = 0, mean_ratio_mean = 0;

  static constexpr std::array<double, 10> length_bounds = {
      0, 0.3, 0.6, 0.70710678118654752, 0.9, 1.3, 1.41421356237309505, 2, 5, 1e300};
  static constexpr std::array<double, 8> Q_bounds = {1, 1.25, 1.5, 2, 3, 5, 10, 1e300};
  std::array<std::size_t, 9> length_histogram{};  ///< edges with length in [bounds[i], bounds[i+1])
  std::array<std::size_t, 7> Q_histogram{};       ///< tetrahedra with Q in [bounds[i], bounds[i+1])
};

/// Measures `mesh` in `metric`, given at its points or as a function. Throws InputError if they do not fit.
[[nodiscard]] Quality measure(const Mesh& mesh, const Metric& metric);

/// Checks the mesh on its own: each string names one kind of defect, how often it occurs and the first
/// place, counted from 1 as in files.
/// Checked: indices in range, finite coordinates, orientation (exact), faces shared by more than two tetrahedra,
/// triangles that are no face, boundary faces or faces between regions without triangle, duplicates, unused points.
[[nodiscard]] std::vector<std::string> defects(const Mesh& mesh);

}  // namespace taut
