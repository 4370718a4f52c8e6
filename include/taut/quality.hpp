// How good a mesh is: the usual measures, and conformity.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The measures of a mesh in a metric (Dobrzynski and Frey 2008, 2.3). The length of an edge is the logarithmic mean of
/// its lengths in the metrics of its two end points. Q is 1 for a regular tetrahedron, larger for any other, infinite
/// for a flat one. The mean ratio Q^(-2/3) is 1 for a regular tetrahedron, 0 for a flat one; it uses the metric with
/// the largest determinant among the four vertices, as the Unstructured Grid Adaptation Working Group (UGAWG) does.
struct Quality {
  std::size_t vertices = 0;    ///< number of points
  std::size_t edges = 0;       ///< number of edges of tetrahedra
  std::size_t triangles = 0;   ///< number of triangles that the mesh lists
  std::size_t tetrahedra = 0;  ///< number of tetrahedra
  double volume = 0;           ///< sum over the tetrahedra
  double complexity = 0;       ///< integral of sqrt(det M) over the mesh
  double tau = 0;              ///< efficiency index, eq. (2) of the paper: 1 is perfect, about 0.944 is reachable
  double unit_edges = 0;       ///< share of the edges with length in [1/sqrt 2, sqrt 2]
  double length_min = 0;       ///< length of the shortest edge
  double length_max = 0;       ///< length of the longest edge
  double Q_max = 0;            ///< Q of the worst tetrahedron
  double Q_mean = 0;           ///< mean of Q over the tetrahedra
  double Q_up_to_2 = 0;        ///< share of the tetrahedra with Q of at most 2
  double Q_up_to_3 = 0;        ///< share of the tetrahedra with Q of at most 3
  double mean_ratio_min = 0;   ///< mean ratio of the worst tetrahedron
  double mean_ratio_mean = 0;  ///< mean of the mean ratio over the tetrahedra

  /// Bounds of the classes of `length_histogram`.
  static constexpr std::array<double, 10> length_bounds = {
      0, 0.3, 0.6, 0.70710678118654752, 0.9, 1.3, 1.41421356237309505, 2, 5, std::numeric_limits<double>::infinity()};
  /// Bounds of the classes of `Q_histogram`.
  static constexpr std::array<double, 8> Q_bounds = {1, 1.25, 1.5, 2,
                                                     3, 5,    10,  std::numeric_limits<double>::infinity()};
  std::array<std::size_t, 9> length_histogram{};  ///< edges with length in [bounds[i], bounds[i+1])
  std::array<std::size_t, 7> Q_histogram{};       ///< tetrahedra with Q in [bounds[i], bounds[i+1])
};

/// Measures `mesh` in `metric`. Throws InputError if an index is out of range or the metric does not fit the mesh.
[[nodiscard]] TAUT_EXPORT Quality measure(const Mesh& mesh, const Metric& metric);

/// Checks the mesh itself, without a metric. Each string names one kind of defect, how often it occurs, and its first
/// place, counted from 1 as in files; no string means no defect.
/// Checked: indices in range, numbers of references, finite coordinates, orientation (exact), faces shared by more than
/// two tetrahedra, tetrahedra on the same side of a common face, triangles that are not a face, boundary faces and
/// faces between regions without a triangle, duplicates, unused points. If one of the first three fails, the rest is
/// not checked.
[[nodiscard]] TAUT_EXPORT std::vector<std::string> defects(const Mesh& mesh);

}  // namespace taut
