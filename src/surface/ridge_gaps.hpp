// Ridges followed to their ends.
#pragma once

#include <vector>

#include "surface/ridge_rule.hpp"
#include "surface/spokes.hpp"

namespace taut {

/// Where a single ridge ends at a vertex, it goes on along the edge that continues it best, if the rule allows that and
/// it turns by less than 45 degrees; and so on from there, but only if it comes to another ridge or to a border within
/// three edges: along the rows of a coarse mesh noise would go on around all of a smooth surface. `parting` is by pair.
void extend_ridges(const Facets& facets, std::span<const EdgePair> pairs, const RidgeRule& rule,
                   std::vector<Parting>& parting);

}  // namespace taut
