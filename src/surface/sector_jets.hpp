// The normal and the curvature of a surface at its vertices.
#pragma once

#include <vector>

#include "surface/derivatives.hpp"
#include "surface/facets.hpp"
#include "surface/sectors.hpp"

namespace taut {

/// The unit normal of each sector, with the weights of Max, with which those of a sphere are exact (Max 1999). Where
/// triangles cancel out it is (0, 0, 1).
[[nodiscard]] std::vector<Vec3> max_normals(const Facets& facets, const Sectors& sectors);

/// For each sector the derivatives at its vertex of a function that is zero on the surface: a jet (surface/jet.hpp)
/// through the neighbours within three edges in its smooth part of the surface, or more if they are few. The gradient
/// has about unit length and the sense of the triangles, which is one around a sector: see orient(). Heights of no more
/// than `tolerance` are zero.
[[nodiscard]] std::vector<Derivatives> sector_jets(const Facets& facets, const Sectors& sectors, double tolerance);

}  // namespace taut
