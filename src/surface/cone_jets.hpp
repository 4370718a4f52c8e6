// Normals and curvatures next to the apexes of cones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/derivatives.hpp"
#include "surface/facets.hpp"
#include "surface/sectors.hpp"

namespace taut {

/// Replaces the jets of the sectors that share smooth edges with apexes. The directions from an apex to three
/// neighbours in a row lie on one circular cone around the apex: exact for circular cones, of second order for others.
/// Polynomials cannot have an apex nearby, because the curvature of a cone grows with 1 over the distance from it.
void set_cone_jets(const Facets& facets, const Sectors& sectors, std::span<const std::uint8_t> is_apex,
                   std::vector<Derivatives>& jets);

}  // namespace taut
