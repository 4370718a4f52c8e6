#include "geometry/placed_surface.hpp"

namespace taut {

OnPatch PlacedSurface::closest_on(const Curved& patch, const Vec3& x, SeatId& seat) const {
  OnPatch at = surface_->closest_on(patch.patch, patch.placement.back(x), static_cast<TriangleId>(seat));
  seat = static_cast<SeatId>(at.triangle);
  at.point = patch.placement.there(at.point);
  at.normal = patch.placement.turned(at.normal);
  return at;
}

OnCurve PlacedSurface::closest_on(const Bent& line, const Vec3& x, SeatId& seat) const {
  OnCurve at = surface_->closest_on(line.curve, line.placement.back(x), seat);
  seat = static_cast<SeatId>(at.segment);
  at.point = line.placement.there(at.point);
  at.tangent = line.placement.turned(at.tangent);
  return at;
}

Sym3 PlacedSurface::shape_operator(const Curved& patch, const OnPatch& at) const {
  return patch.placement.turned(surface_->shape_operator(at));
}

}  // namespace taut
