#include "taut/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/edges.hpp"
#include "metric/field.hpp"
#include "metric/length.hpp"
#include "metric/quality.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require_indices(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    for (const Index v : mesh.tetrahedra[t]) {
      if (v >= mesh.points.size())
        throw InputError(fmt::format("mesh: tetrahedron {}: vertex {} found, expected 1..{}", t + 1, std::size_t{v} + 1,
                                     mesh.points.size()));
    }
  }
}

/// The interval of `bounds` that x lies in, the first or last for what lies outside (a flat element has Q infinite).
template <std::size_t n>
std::size_t interval(const std::array<double, n>& bounds, double x) {
  const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, x);
  return static_cast<std::size_t>(above - bounds.begin()) - 1;
}

void measure_edges(const Mesh& mesh, const std::vector<Sym3>& metrics, Quality& result) {
  const auto edges = edges_of(mesh.tetrahedra);
  result.edges = edges.size();
  if (edges.empty()) return;
  result.length_min = std::numeric_limits<double>::infinity();
  double phi = 0;
  std::size_t unit = 0;
  for (const auto& [p, q] : edges) {
    const double l = edge_length(mesh.points[p], mesh.points[q], metrics[p], metrics[q]);
    phi += efficiency_phi(l);
    unit += l >= 1 / std::numbers::sqrt2 && l <= std::numbers::sqrt2;
    result.length_min = std::min(result.length_min, l);
    result.length_max = std::max(result.length_max, l);
    ++result.length_histogram[interval(Quality::length_bounds, l)];
  }
  result.tau = std::exp(phi / static_cast<double>(edges.size()));
  result.unit_edges = static_cast<double>(unit) / static_cast<double>(edges.size());
}

/// What one tetrahedron adds to the sums.
struct Shape {
  double volume, complexity, Q, mean_ratio;
};

/// Volumes count without sign: orientation is for `defects` to judge. `roots` are sqrt(det M) at the vertices.
Shape shape_of(const Mesh& mesh, const std::array<Index, 4>& tet, const std::vector<Sym3>& metrics,
               const std::vector<double>& roots) {
  const auto& [a, b, c, d] = tet;
  const auto& x = mesh.points;
  const double volume = std::abs(six_volumes(x[a], x[b], x[c], x[d])) / 6;
  const double q = shape_quality(x[a], x[b], x[c], x[d], metrics[a], metrics[b], metrics[c], metrics[d]);
  const Index finest = *std::max_element(tet.begin(), tet.end(), [&](Index i, Index j) { return roots[i] < roots[j]; });
  return {volume, volume * 0.25 * (roots[a] + roots[b] + roots[c] + roots[d]), 1 / std::abs(q),
          std::abs(mean_ratio(x[a], x[b], x[c], x[d], metrics[finest]))};
}

void measure_tetrahedra(const Mesh& mesh, const std::vector<Sym3>& metrics, Quality& result) {
  result.tetrahedra = mesh.tetrahedra.size();
  if (mesh.tetrahedra.empty()) return;
  std::vector<double> roots(metrics.size());
  std::ranges::transform(metrics, roots.begin(), [](const Sym3& m) { return std::sqrt(determinant_spd(m)); });
  result.mean_ratio_min = std::numeric_limits<double>::infinity();
  std::size_t up_to_2 = 0, up_to_3 = 0;
  for (const auto& tet : mesh.tetrahedra) {
    const Shape shape = shape_of(mesh, tet, metrics, roots);
    result.volume += shape.volume;
    result.complexity += shape.complexity;
    result.Q_mean += shape.Q;
    result.Q_max = std::max(result.Q_max, shape.Q);
    result.mean_ratio_mean += shape.mean_ratio;
    result.mean_ratio_min = std::min(result.mean_ratio_min, shape.mean_ratio);
    up_to_2 += shape.Q <= 2;
    up_to_3 += shape.Q <= 3;
    ++result.Q_histogram[interval(Quality::Q_bounds, shape.Q)];
  }
  const auto count = static_cast<double>(mesh.tetrahedra.size());
  result.Q_mean /= count;
  result.mean_ratio_mean /= count;
  result.Q_up_to_2 = static_cast<double>(up_to_2) / count;
  result.Q_up_to_3 = static_cast<double>(up_to_3) / count;
}

}  // namespace

Quality measure(const Mesh& mesh, const Metric& metric) {
  require_indices(mesh);
  const std::vector<Sym3> metrics = tensors_at(mesh, metric);
  Quality result;
  result.vertices = mesh.points.size();
  result.triangles = mesh.triangles.size();
  measure_edges(mesh, metrics, result);
  measure_tetrahedra(mesh, metrics, result);
  return result;
}

}  // namespace taut
