// The vertices that bodies have taken along.
#pragma once

#include "geometry/carry.hpp"
#include "motion/goal.hpp"

namespace taut {

/// After this share of the step. Bodies that move by the same motion count as one.
[[nodiscard]] RigidMoves rigid_moves(const Boundary& boundary, const Goal& goal, double share);

}  // namespace taut
