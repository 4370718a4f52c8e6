#include "sizing/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/box.hpp"
#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/edges.hpp"
#include "metric/field.hpp"
#include "sizing/gradation.hpp"
#include "sizing/truncation.hpp"
#include "taut/error.hpp"

namespace taut {

void require_limits(const Limits& l) {
  if (!(l.hmin >= 0) || !(l.hmax > 0) || !(l.hmin <= l.hmax))
    throw InputError(fmt::format("hmin {}, hmax {} found, expected 0 <= hmin <= hmax, hmax > 0", l.hmin, l.hmax));
  if (!(l.anisotropy >= 1)) throw InputError(fmt::format("anisotropy {} found, expected 1 or more", l.anisotropy));
  if (l.gradation) require_gradation(*l.gradation);
}

std::vector<Sym3> graded(const Mesh& mesh, std::span<const std::array<Index, 2>> edges, std::vector<Sym3> metrics,
                         const Limits& limits) {
  if (!limits.gradation) return metrics;
  metrics = gradate(mesh.points, edges, std::move(metrics), *limits.gradation);
  for_each_index(metrics.size(), [&](std::size_t v) { metrics[v] = truncate(metrics[v], limits); });
  return metrics;
}

Limits within_domain(const Mesh& mesh, Limits limits) {
  if (std::isfinite(limits.hmax)) return limits;
  limits.hmax = std::max(box_around(mesh.points).diagonal(), limits.hmin);
  return limits;
}

std::vector<Sym3> apply_limits(const Mesh& mesh, std::vector<Sym3> metrics, const Limits& limits) {
  for_each_index(metrics.size(), [&](std::size_t v) { metrics[v] = truncate(metrics[v], limits); });
  if (!limits.gradation) return metrics;
  return graded(mesh, edges_of(mesh.tetrahedra), std::move(metrics), limits);
}

Tensors limited(const Mesh& mesh, Tensors metric, const Limits& limits) {
  require_sound_arrays(mesh);
  require_limits(limits);
  return apply_limits(mesh, tensors_at(mesh, Metric{std::move(metric)}), limits);
}

}  // namespace taut
