// From the working mesh back to plain arrays.
#pragma once

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Fills mesh, metric and new_of_old. The mesh must be without dead entities; `input` is the one that the vertices'
/// origins are indices of.
void assemble_mesh(const Session& session, const Mesh& input, AdaptResult& result);

/// Fills mesh, metric, hosts, new_of_old and the report's hash and quality. The mesh must be without dead entities. The
/// session ends here, so that its memory can go to the result.
void assemble(Session session, const Mesh& input, AdaptResult& result);

}  // namespace taut
