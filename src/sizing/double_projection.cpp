#include "sizing/double_projection.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "base/sym3.hpp"
#include "mesh/edges.hpp"
#include "mesh/faces.hpp"
#include "mesh/incidence.hpp"
#include "mesh/neighbourhood.hpp"

namespace taut {
namespace {

/// Volume times the gradients of the four barycentric coordinates: a third of the area of each face, inward, whatever
/// the orientation.
struct Gradients {
  std::array<Vec3, 4> of;
  double volume;
};

Gradients weighted_gradients(const Mesh& mesh, const std::array<Index, 4>& tet) {
  std::array<Vec3, 4> x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = mesh.points[tet[k]];
  const double six = six_volumes(x[0], x[1], x[2], x[3]);
  Gradients g{.of = {}, .volume = std::abs(six) / 6};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [a, b, c] = face_vertices[k];
    g.of[k] = std::copysign(1.0 / 6, -six) * cross(x[b] - x[a], x[c] - x[a]);
  }
  return g;
}

/// Means of the gradients of n fields, which lie one after another at each point.
template <std::size_t n>
std::vector<std::array<Vec3, n>> mean_gradients(const Mesh& mesh, std::span<const std::array<double, n>> fields) {
  const auto tets_of_point = tets_of_points(mesh.tetrahedra, mesh.points.size());
  std::vector<std::array<Vec3, n>> means(mesh.points.size());
  for_each_index(means.size(), [&](std::size_t v) {
    double volume = 0;
    for (const Index t : tets_of_point[v]) {
      const Gradients g = weighted_gradients(mesh, mesh.tetrahedra[t]);
      volume += g.volume;
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t i = 0; i < n; ++i) means[v][i] = means[v][i] + fields[mesh.tetrahedra[t][k]][i] * g.of[k];
    }
    if (volume > 0)
      for (Vec3& mean : means[v]) mean = 1 / volume * mean;
  });
  return means;
}

std::vector<std::uint8_t> boundary_marks(const Mesh& mesh) {
  const auto faces = faces_of(mesh.tetrahedra, mesh.points.size());
  std::vector<std::uint8_t> marks(mesh.points.size(), 0);
  for (std::size_t v = 0; v < faces.keys(); ++v) {
    const auto own = faces[v];
    for (std::size_t i = 0; i < own.size(); ++i) {
      const bool is_shared = (i > 0 && own[i - 1].vertices == own[i].vertices) ||
                             (i + 1 < own.size() && own[i + 1].vertices == own[i].vertices);
      if (is_shared) continue;
      for (const Index p : own[i].vertices) marks[p] = 1;
    }
  }
  return marks;
}

void take_inner_means(const Mesh& mesh, Tensors& hessians) {
  const auto marks = boundary_marks(mesh);
  const auto neighbours = neighbours_of_vertices(edges_of(mesh.tetrahedra), mesh.points.size());
  for_each_index(hessians.size(), [&](std::size_t v) {
    if (marks[v] == 0) return;
    Sym3 sum{};
    double count = 0;
    for (const Index q : neighbours[v]) {
      if (marks[q] != 0) continue;
      sum = sum + hessians[q];
      ++count;
    }
    if (count > 0) hessians[v] = 1 / count * sum;
  });
}

std::vector<Point> gradients_of(const Mesh& mesh, std::span<const double> values) {
  std::vector<std::array<double, 1>> fields(values.size());
  for_each_index(fields.size(), [&](std::size_t v) { fields[v] = {values[v]}; });
  const auto means = mean_gradients<1>(mesh, fields);
  std::vector<Point> gradients(means.size());
  for_each_index(means.size(), [&](std::size_t v) { gradients[v] = means[v][0]; });
  return gradients;
}

}  // namespace

Tensors hessians_by_double_projection(const Mesh& mesh, std::span<const double> values) {
  const std::vector<Point> gradients = gradients_of(mesh, values);
  const auto rows = mean_gradients<3>(mesh, gradients);
  Tensors hessians(rows.size());
  for_each_index(rows.size(), [&](std::size_t v) {
    const auto& [x, y, z] = rows[v];
    hessians[v] = {x[0], 0.5 * (x[1] + y[0]), 0.5 * (x[2] + z[0]), y[1], 0.5 * (y[2] + z[1]), z[2]};
  });
  take_inner_means(mesh, hessians);
  return hessians;
}

}  // namespace taut
