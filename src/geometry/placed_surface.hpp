// The reference surface where its parts lie now.
#pragma once

#include <memory>
#include <utility>

#include "base/placement.hpp"
#include "surface/reference_surface.hpp"

namespace taut {

/// A patch of the reference surface, where its body has taken it. Its normals have the sense of the patch's triangles
/// times `sign`.
struct Curved {
  PatchId patch;
  double sign = 1;
  bool two_sided = false;  ///< an interface, whose triangles may have either sense
  Placement placement{};
};

/// A curve of the reference surface, or a part of one, where its body has taken it.
struct Bent {
  LineId curve;
  Placement placement{};
};

/// The surface stays where it was made; its parts are asked in the frames of their bodies. Answers are in space.
class PlacedSurface {
public:
  PlacedSurface() = default;
  explicit PlacedSurface(std::shared_ptr<const ReferenceSurface> surface) : surface_(std::move(surface)) {}

  /// Whether there is one: the rest may be asked only then.
  [[nodiscard]] bool exists() const { return surface_ != nullptr; }

  /// A good `seat`, such as that of a place nearby, makes the search faster. It becomes that of the place found.
  [[nodiscard]] OnPatch closest_on(const Curved& patch, const Vec3& x, SeatId& seat) const;
  [[nodiscard]] OnCurve closest_on(const Bent& line, const Vec3& x, SeatId& seat) const;
  [[nodiscard]] OnPatch closest_on(const Curved& patch, const Vec3& x) const {
    SeatId seat = none;
    return closest_on(patch, x, seat);
  }

  /// At a place that was found on the patch.
  [[nodiscard]] Sym3 shape_operator(const Curved& patch, const OnPatch& at) const;

  /// Where they were made.
  [[nodiscard]] const Facets& facets() const { return surface_->facets(); }

private:
  std::shared_ptr<const ReferenceSurface> surface_;
};

}  // namespace taut
