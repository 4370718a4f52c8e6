#include "taut/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "mesh/edges.hpp"
#include "metric/field.hpp"
#include "metric/length.hpp"
#include "metric/quality.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require_indices(const Mesh& mesh) {
  for_each_index(mesh.tetrahedra.size(), [&](std::size_t t) {
    for (const Index v : mesh.tetrahedra[t]) {
      if (v >= mesh.points.size())
        throw InputError(fmt::format("mesh: tetrahedron {}: vertex {} found, expected 1..{}", t + 1, std::size_t{v} + 1,
                                     mesh.points.size()));
    }
  });
}

/// The interval of `bounds` that contains x, or the first or last one if x is outside (Q of a flat element is
/// infinite).
template <std::size_t n>
std::size_t interval(const std::array<double, n>& bounds, double x) {
  const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, x);
  return static_cast<std::size_t>(above - bounds.begin()) - 1;
}

template <std::size_t n>
void add(std::array<std::size_t, n>& histogram, const std::array<std::size_t, n>& other) {
  for (std::size_t i = 0; i < n; ++i) histogram[i] += other[i];
}

/// Sums over edges.
struct Lengths {
  double phi = 0;
  std::size_t unit = 0;
  double min = std::numeric_limits<double>::infinity(), max = 0;
  decltype(Quality::length_histogram) histogram{};

  void add_edge(double l) {
    phi += efficiency_phi(l);
    unit += is_unit(l);
    min = std::min(min, l);
    max = std::max(max, l);
    ++histogram[interval(Quality::length_bounds, l)];
  }
  Lengths& operator+=(const Lengths& other) {
    phi += other.phi;
    unit += other.unit;
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    add(histogram, other.histogram);
    return *this;
  }
};

void measure_edges(const Mesh& mesh, const std::vector<Sym3>& metrics, Quality& result) {
  const auto edges = edges_of(mesh.tetrahedra);
  result.edges = edges.size();
  if (edges.empty()) return;
  const auto lengths = sum_in_order<Lengths>(edges.size(), [&](Lengths& sum, std::size_t e) {
    const auto& [p, q] = edges[e];
    sum.add_edge(edge_length(mesh.points[p], mesh.points[q], metrics[p], metrics[q]));
  });
  const auto count = static_cast<double>(edges.size());
  result.tau = std::exp(lengths.phi / count);
  result.unit_edges = static_cast<double>(lengths.unit) / count;
  result.length_min = lengths.min;
  result.length_max = lengths.max;
  result.length_histogram = lengths.histogram;
}

/// What one tetrahedron adds to the sums.
struct Shape {
  double volume, complexity, Q, mean_ratio;
};

/// Volumes are counted without sign, because `defects` checks the orientation. `roots` are sqrt(det M) at the vertices.
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

/// Sums over tetrahedra.
struct Shapes {
  double volume = 0, complexity = 0, Q = 0, Q_max = 0, mean_ratio = 0;
  double mean_ratio_min = std::numeric_limits<double>::infinity();
  std::size_t up_to_2 = 0, up_to_3 = 0;
  decltype(Quality::Q_histogram) histogram{};

  void add_tetrahedron(const Shape& shape) {
    volume += shape.volume;
    complexity += shape.complexity;
    Q += shape.Q;
    Q_max = std::max(Q_max, shape.Q);
    mean_ratio += shape.mean_ratio;
    mean_ratio_min = std::min(mean_ratio_min, shape.mean_ratio);
    up_to_2 += shape.Q <= 2;
    up_to_3 += shape.Q <= 3;
    ++histogram[interval(Quality::Q_bounds, shape.Q)];
  }
  Shapes& operator+=(const Shapes& other) {
    volume += other.volume;
    complexity += other.complexity;
    Q += other.Q;
    Q_max = std::max(Q_max, other.Q_max);
    mean_ratio += other.mean_ratio;
    mean_ratio_min = std::min(mean_ratio_min, other.mean_ratio_min);
    up_to_2 += other.up_to_2;
    up_to_3 += other.up_to_3;
    add(histogram, other.histogram);
    return *this;
  }
};

void measure_tetrahedra(const Mesh& mesh, const std::vector<Sym3>& metrics, Quality& result) {
  result.tetrahedra = mesh.tetrahedra.size();
  if (mesh.tetrahedra.empty()) return;
  std::vector<double> roots(metrics.size());
  for_each_index(roots.size(), [&](std::size_t v) { roots[v] = std::sqrt(determinant_spd(metrics[v])); });
  const auto shapes = sum_in_order<Shapes>(mesh.tetrahedra.size(), [&](Shapes& sum, std::size_t t) {
    sum.add_tetrahedron(shape_of(mesh, mesh.tetrahedra[t], metrics, roots));
  });
  const auto count = static_cast<double>(mesh.tetrahedra.size());
  result.volume = shapes.volume;
  result.complexity = shapes.complexity;
  result.Q_mean = shapes.Q / count;
  result.Q_max = shapes.Q_max;
  result.Q_up_to_2 = static_cast<double>(shapes.up_to_2) / count;
  result.Q_up_to_3 = static_cast<double>(shapes.up_to_3) / count;
  result.mean_ratio_mean = shapes.mean_ratio / count;
  result.mean_ratio_min = shapes.mean_ratio_min;
  result.Q_histogram = shapes.histogram;
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
