// The mesh as the caller sees it, with numbers that last.
#pragma once

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// The session's mesh and metric as plain arrays. Points that were there in `before` keep their order and come first;
/// `new_of_old` maps their numbers. The session's vertices remember the new numbers. Its mesh must be without dead
/// entities.
[[nodiscard]] AdaptResult numbered(Session& session, const Mesh& before);

}  // namespace taut
