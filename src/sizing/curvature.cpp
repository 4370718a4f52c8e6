#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "sizing/limits.hpp"
#include "sizing/surface_curvatures.hpp"
#include "surface/ridge_angle.hpp"
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
  require_ridge_angle(o.ridge_angle);
}

}  // namespace

Tensors curvature_metric(const Mesh& mesh, const CurvatureOptions& options) {
  require(options);
  const SurfaceCurvatures found = surface_curvatures(mesh, options.ridge_angle);
  CurvatureOptions o = options;
  if (o.relative) o.deviation *= within_domain(mesh, {}).hmax;
  o.limits = within_domain(mesh, options.limits);
  Tensors flat(mesh.points.size(), metric_of_size(o.limits.hmax));
  return limited(mesh, with_curvatures(std::move(flat), found, o), o.limits);
}

}  // namespace taut
