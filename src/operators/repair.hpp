// The last resort for a bad tetrahedron.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct RepairRules {
  double bad = 0.4;               ///< 1/Q up to which a tetrahedron is worth the effort
  double gain = 1.05;             ///< the worst 1/Q of what changes must grow by this factor
  double longest_new_edge = 1.8;  ///< unless there was a longer one
  bool may_collapse = true;       ///< otherwise no vertex goes
};

/// Moves one of its vertices off its opposite face, or collapses one of its edges whatever their length, if that
/// improves the worst element around: where lengths alone decide, a sliver with unit edges would stay.
Outcome repair(Kernel& kernel, TetId t, const RepairRules& rules);

}  // namespace taut
