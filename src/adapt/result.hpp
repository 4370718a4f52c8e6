// From the working mesh back to plain arrays.
#pragma once

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Fills mesh, metric, hosts, new_of_old and the report's hash and quality. The mesh must be without dead entities. The
/// session ends here, so that its memory can go to the result.
void assemble(Session session, const Mesh& input, AdaptResult& result);

}  // namespace taut
