// How well flat triangles stand for curved patches.
#pragma once

#include <array>

#include "geometry/model.hpp"

namespace taut {

/// How far the triangle is from what is fair: up to 1 it is fair, and of two triangles the one with the smaller number
/// fits better. Infinite if it is folded over. Of a patch that is not curved it is 0.
///
/// Compared are the angle between the triangle and the surface above its centre with the angle by which the surface
/// turns along an edge, which itself is compared with a radian; and the distance there with 2.5 times that of an edge's
/// chord, and with the model's deviation. Where there may be contacts, no more of a chord's distance counts than that
/// of an edge that `metric` would not split. `near` is a guess at the seat of the centre, and then the one that was
/// found.
[[nodiscard]] double misfit(const Model& model, PatchId patch, const std::array<Vec3, 3>& triangle, const Sym3& metric,
                            SeatId& near);
[[nodiscard]] inline double misfit(const Model& model, PatchId patch, const std::array<Vec3, 3>& triangle,
                                   const Sym3& metric) {
  SeatId near = none;
  return misfit(model, patch, triangle, metric, near);
}

}  // namespace taut
