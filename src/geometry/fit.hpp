// How well flat triangles stand for curved patches.
#pragma once

#include <array>

#include "geometry/model.hpp"

namespace taut {

/// How far the triangle is from what is fair: up to 1 it is fair, and of two triangles the one with the smaller number
/// fits better. Infinite if it is folded over. Of a patch that is not curved it is 0.
///
/// Compared are the angle between the triangle and the surface above its centre with that by which the surface turns
/// along its longest edge, at most 40 degrees; and the distance there with 2.5 times the sag of a chord as long.
[[nodiscard]] double misfit(const Model& model, PatchId patch, const std::array<Vec3, 3>& triangle);

}  // namespace taut
