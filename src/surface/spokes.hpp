// Edges around the tip of a cone, which only look like ridges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/facets.hpp"

namespace taut {

/// How an edge was found to part a surface.
enum class Parting : std::uint8_t { smooth, by_shape, by_input };

/// Around the tip of a cone there are only a few triangles, however fine the mesh is, and the angles between them are
/// large. Makes such edges smooth: connected ridges by shape that stay within three edges of an apex, and one of which
/// ends in a smooth part of the surface. Those of a pyramid go on to others. A ridge of one or two
/// edges by itself is noise, and smooth too. `parting` is by pair.
void drop_spokes(const Facets& facets, std::span<const EdgePair> pairs, std::vector<Parting>& parting);

}  // namespace taut
