#include "sizing/complexity.hpp"

#include <cmath>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/cholesky.hpp"
#include "metric/field.hpp"
#include "taut/sizing.hpp"

namespace taut {

double expected_tetrahedra(const TetMesh& mesh) {
  constexpr double per_complexity = 10;
  const auto complexity = sum_in_order<double>(mesh.tets.size(), [&](double& sum, std::size_t t) {
    const auto& v = mesh.tets[t].v;
    double log_density = 0;  // the sum of log sqrt(det M)
    for (VertexId p : v) log_density += 0.5 * std::log(determinant_spd(mesh.vertices[p].m));
    const double volume = six_volumes(mesh.x(v[0]), mesh.x(v[1]), mesh.x(v[2]), mesh.x(v[3])) / 6;
    sum += volume * std::exp(log_density / 4);
  });
  return per_complexity * complexity;
}

std::vector<double> volumes_of_points(const Mesh& mesh) {
  const auto& x = mesh.points;
  const auto quarters = gather<double>(mesh.tetrahedra.size(), x.size(), [&](std::size_t t, auto put) {
    const auto& v = mesh.tetrahedra[t];
    const double volume = std::abs(six_volumes(x[v[0]], x[v[1]], x[v[2]], x[v[3]])) / 6;
    for (const Index p : v) put(p, volume / 4);
  });
  std::vector<double> volumes(x.size());
  for_each_index(x.size(), [&](std::size_t p) {
    for (const double quarter : quarters[p]) volumes[p] += quarter;
  });
  return volumes;
}

double complexity(const Mesh& mesh, const Tensors& metric) {
  require_sound_arrays(mesh);
  const std::vector<Sym3> metrics = tensors_at(mesh, Metric{metric});
  const std::vector<double> volumes = volumes_of_points(mesh);
  return sum_in_order<double>(
      volumes.size(), [&](double& sum, std::size_t v) { sum += volumes[v] * std::sqrt(determinant_spd(metrics[v])); });
}

}  // namespace taut
