#include "taut/geometry.hpp"

#include <fmt/format.h>

#include <cmath>

#include "surface/principal_curvatures.hpp"
#include "surface/reference_surface.hpp"
#include "surface/ridge_angle.hpp"
#include "taut/error.hpp"

namespace taut {
Geometry::Geometry(const Mesh& mesh, const GeometryOptions& options) {
  if (options.ridge_angle) require_ridge_angle(*options.ridge_angle);
  surface_ = std::make_shared<const ReferenceSurface>(surface_of(mesh), options.ridge_angle);
}

ClosestPoint Geometry::closest(const Point& x) const {
  for (const double coordinate : x)
    if (!std::isfinite(coordinate)) throw InputError(fmt::format("coordinate {} is not finite", coordinate));
  const OnPatch at = surface_->closest(x);
  const Spectrum bent = principal_curvatures({at.normal, surface_->shape_operator(at)});
  return {.point = at.point,
          .normal = at.normal,
          .distance = at.distance,
          .triangle = at.triangle,
          .weights = at.weights,
          .reference = surface_->patches()[surface_->patch_of(at.triangle)].ref,
          .curvatures = {bent.values[0], bent.values[1]},
          .directions = {bent.vectors[0], bent.vectors[1]}};
}

std::size_t Geometry::patches() const {
  return surface_->patches().size();
}

std::size_t Geometry::ridges() const {
  return surface_->curves().size();
}

std::size_t Geometry::corners() const {
  return surface_->corners().size();
}

}  // namespace taut
