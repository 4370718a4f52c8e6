#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "metric/intersection.hpp"
#include "metric/spectral.hpp"
#include "sizing/derivatives.hpp"
#include "sizing/limits.hpp"
#include "sizing/nodal.hpp"
#include "surface/principal_curvatures.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

void require(const LevelSetOptions& o) {
  require_limits(o.limits);
  if (!(o.error > 0 && std::isfinite(o.error)))
    throw InputError(fmt::format("error {} found, expected a number above 0", o.error));
  if (!(o.growth >= 0)) throw InputError(fmt::format("growth {} found, expected 0 or more", o.growth));
  if (!(o.across >= 0)) throw InputError(fmt::format("across {} found, expected 0 or more", o.across));
  if (!(o.refinement > 1))
    throw InputError(fmt::format("refinement {} found, expected a number above 1", o.refinement));
}

/// 1 for the vertices of the tetrahedra that the surface crosses or touches.
std::vector<std::uint8_t> crossed_marks(const Mesh& mesh, std::span<const double> values) {
  std::vector<std::uint8_t> marks(mesh.points.size(), 0);
  for (const auto& tet : mesh.tetrahedra) {
    const auto [low, high] = std::ranges::minmax(tet, {}, [&](Index v) { return values[v]; });
    if (values[low] > 0 || values[high] < 0) continue;
    for (const Index v : tet) marks[v] = 1;
  }
  return marks;
}

/// The sizes at the surface, along the normal and in the directions of curvature, grown with the distance from it.
Sym3 metric_near(const Derivatives& d, double distance, const LevelSetOptions& o) {
  const Spectrum s = principal_curvatures(d);
  const auto along = [&](double curvature) {
    return std::min(std::sqrt(o.error / std::abs(curvature)), o.limits.hmax);
  };
  const double first = along(s.values[0]), second = along(s.values[1]);
  const double across = std::max(o.error, o.across * std::min(first, second));
  const double factor = 1 + o.growth * distance / across;
  const auto eigenvalue = [&](double size) { return std::pow(std::min(factor * size, o.limits.hmax), -2); };
  return assemble({{eigenvalue(first), eigenvalue(second), eigenvalue(across)}, s.vectors});
}

Sym3 metric_at(const Derivatives& d, double value, bool is_crossed, const LevelSetOptions& o) {
  const double slope = norm(d.gradient);
  if (!(slope * o.limits.hmax > 1e-12 * std::abs(value)) || slope == 0) return metric_of_size(o.limits.hmax);
  return metric_near(d, is_crossed ? 0 : std::abs(value) / slope, o);
}

}  // namespace

Tensors level_set_metric(const Mesh& mesh, std::span<const double> values, const LevelSetOptions& options) {
  require_sound_arrays(mesh);
  require(options);
  require_values(values, mesh.points.size());
  LevelSetOptions o = options;
  o.limits = within_domain(mesh, options.limits);
  const auto crossed = crossed_marks(mesh, values);
  const auto derivatives = derivatives_of(mesh, values);
  Tensors metric = implied_metric(mesh);
  for_each_index(metric.size(), [&](std::size_t v) {
    const Sym3 finest = o.refinement * o.refinement * metric[v];
    metric[v] = capped(metric_at(derivatives[v], values[v], crossed[v] != 0, o), finest);
  });
  return limited(mesh, std::move(metric), o.limits);
}

}  // namespace taut
