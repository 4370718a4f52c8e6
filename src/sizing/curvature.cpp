#include <fmt/format.h>

#include <cmath>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "metric/intersection.hpp"
#include "sizing/limits.hpp"
#include "sizing/surface_curvatures.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

void require(const CurvatureOptions& o) {
  require_limits(o.limits);
  if (!(o.deviation > 0 && std::isfinite(o.deviation)))
    throw InputError(fmt::format("deviation {} found, expected a number above 0", o.deviation));
  if (!(o.turn > 0 && o.turn <= 90))
    throw InputError(fmt::format("turn {} found, expected degrees above 0, at most 90", o.turn));
  if (!(o.ridge_angle > 0 && o.ridge_angle < 180))
    throw InputError(fmt::format("ridge angle {} found, expected between 0 and 180 degrees", o.ridge_angle));
}

}  // namespace

Tensors curvature_metric(const Mesh& mesh, const CurvatureOptions& options) {
  require(options);
  const SurfaceCurvatures found = surface_curvatures(mesh, options.ridge_angle);
  CurvatureOptions o = options;
  if (o.relative) o.deviation *= within_domain(mesh, {}).hmax;
  o.limits = within_domain(mesh, options.limits);
  const auto sectors_at = gather<Index>(found.curvatures.size(), mesh.points.size(),
                                        [&](std::size_t s, auto put) { put(found.points[s], static_cast<Index>(s)); });
  Tensors metric(mesh.points.size(), metric_of_size(o.limits.hmax));
  for_each_index(metric.size(), [&](std::size_t p) {
    for (const Index s : sectors_at[p]) metric[p] = intersect(metric[p], metric_of_curvatures(found.curvatures[s], o));
  });
  return limited(mesh, std::move(metric), o.limits);
}

}  // namespace taut
