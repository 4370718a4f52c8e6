// The last resort for a bad tetrahedron.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct RepairRules {
  double bad = 0.4;               ///< tetrahedra with 1/Q up to this are repaired
  double gain = 1.05;             ///< the worst 1/Q of what changes must grow by this factor
  double longest_new_edge = 1.8;  ///< unless there was a longer one
  double shortest_new_edge = 0.3;
  bool may_collapse = true;  ///< otherwise no vertex goes
  bool may_insert = true;    ///< otherwise none comes
};

/// Moves one of its vertices away from the opposite face, or collapses one of its edges regardless of length, if that
/// improves the worst element around. If only lengths decided, a sliver with unit edges would remain.
Outcome repair(Kernel& kernel, TetId t, const RepairRules& rules);

}  // namespace taut
