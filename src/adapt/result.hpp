// From the mesh under work back to plain arrays.
#pragma once

#include "adapt/setup.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Fills mesh, metric, new_of_old and the report's hash and quality. The mesh must be without dead entities.
void assemble(const Problem& problem, const Mesh& input, AdaptResult& result);

}  // namespace taut
