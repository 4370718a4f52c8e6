#include "sizing/complexity.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "metric/cholesky.hpp"

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

}  // namespace taut
