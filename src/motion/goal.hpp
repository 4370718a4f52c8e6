// Where the boundary is to go in a step.
#pragma once

#include <cstdint>
#include <vector>

#include "motion/boundary.hpp"
#include "taut/rigid_motion.hpp"

namespace taut {

/// A rigid motion for each body; or, if there are no bodies, displacements of points of the mesh.
struct Goal {
  std::vector<RigidMotion> motions;
  std::vector<Vec3> displacements;      ///< by point
  std::vector<std::uint8_t> is_driven;  ///< by point: whether its displacement counts

  /// A share of it. Rigid motions are divided as screws, so that shares done one after the other add up.
  [[nodiscard]] Goal part(double share) const {
    Goal result = *this;
    for (RigidMotion& motion : result.motions) motion = motion.share(share);
    for (Vec3& d : result.displacements) d = share * d;
    return result;
  }

  /// Where a vertex that is driven by a body goes from x.
  [[nodiscard]] Vec3 place(const Role& role, std::uint32_t point, const Vec3& x) const {
    return motions.empty() ? x + displacements[point] : motions[role.body](x);
  }

  /// With which velocity it sets out, if the step takes one unit of time.
  [[nodiscard]] Vec3 velocity(const Role& role, std::uint32_t point, const Vec3& x) const {
    return motions.empty() ? displacements[point] : Vec3{motions[role.body].velocity(x)};
  }
};

}  // namespace taut
