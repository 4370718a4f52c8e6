// A surface near one of its points, as a polynomial height over the tangent plane.
#pragma once

#include <span>

#include "surface/derivatives.hpp"

namespace taut {

/// The derivatives, at the point, of a function that is zero on the surface: the height over the plane across `normal`,
/// less the polynomial without constant term ("jet", Cazals and Pouget 2005) that fits the heights of the neighbours
/// best. `offsets` are the places of the neighbours less that of the point.
///
/// The degree is 2, or up to 4 if that predicts each neighbour from the others better by a fifth, and turns the normal
/// by less than a slope of 0.3. Neighbours that do
/// not determine a quadratic polynomial give the one with the least coefficients: two rows of points along a cylinder
/// show no curvature along it. Heights of no more than `tolerance` are zero. Neighbours that lie on one line, or none,
/// give a plane.
[[nodiscard]] Derivatives jet(const Vec3& normal, std::span<const Vec3> offsets, double tolerance);

}  // namespace taut
