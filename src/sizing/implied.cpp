#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/incidence.hpp"
#include "metric/spectral.hpp"
#include "sizing/limits.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

/// The metric in which all six edges of the tetrahedron have length 1: J^-T G J^-1, where J has the edges from the
/// first vertex as columns and G is their Gram matrix in a regular tetrahedron, 1 on the diagonal and 1/2 elsewhere.
/// The rows of J^-1 are the gradients of the barycentric coordinates.
Sym3 metric_of_tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double scale = 1 / dot(cross(a, b), c);
  const Vec3 x = scale * cross(b, c), y = scale * cross(c, a), z = scale * cross(a, b), sum = x + y + z;
  return 0.5 * (outer(x) + outer(y) + outer(z) + outer(sum));
}

struct Weighted {
  Sym3 log;
  double volume;
};

Weighted weighted_log(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.tetrahedra[t];
  const Vec3 o = mesh.points[v[0]], a = mesh.points[v[1]] - o, b = mesh.points[v[2]] - o, c = mesh.points[v[3]] - o;
  const double volume = std::abs(dot(cross(a, b), c)) / 6;
  if (volume == 0) throw_flat(t, v);
  return {volume * log_metric(metric_of_tetrahedron(a, b, c)), volume};
}

}  // namespace

Tensors implied_metric(const Mesh& mesh) {
  require_sound_arrays(mesh);
  std::vector<Weighted> logs(mesh.tetrahedra.size());
  for_each_index(logs.size(), [&](std::size_t t) { logs[t] = weighted_log(mesh, t); });
  const auto tets_of_point = tets_of_points(mesh.tetrahedra, mesh.points.size());
  const Sym3 coarsest = metric_of_size(within_domain(mesh, {}).hmax);
  Tensors metric(mesh.points.size());
  for_each_index(metric.size(), [&](std::size_t p) {
    Weighted sum{};
    for (const Index t : tets_of_point[p]) sum = {sum.log + logs[t].log, sum.volume + logs[t].volume};
    metric[p] = sum.volume > 0 ? exp_metric(1 / sum.volume * sum.log) : coarsest;
  });
  return metric;
}

}  // namespace taut
