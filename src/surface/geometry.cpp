#include "taut/geometry.hpp"

#include <fmt/format.h>

#include <cmath>

#include "surface/principal_curvatures.hpp"
#include "surface/reference_surface.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require(const GeometryOptions& options) {
  const auto& angle = options.ridge_angle;
  if (angle && !(*angle > 0 && *angle < 180))
    throw InputError(fmt::format("ridge angle {} found, expected between 0 and 180 degrees", *angle));
}

}  // namespace

Geometry::Geometry(const Mesh& mesh, const GeometryOptions& options) {
  require(options);
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
