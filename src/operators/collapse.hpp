// Collapse: merges a vertex into its neighbour.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct CollapseRules {
  double longest_new_edge = 1.5;  ///< unless the removed vertex has a longer one
  /// A new tetrahedron is too bad unless its 1/Q is above `worst_quality`, or above `share_of_old` times the worst 1/Q
  /// that is removed.
  double worst_quality = 0.3, share_of_old = 0.7;
};

/// Removes one end of the edge, the first one that can be removed. Marks the shell as tried.
Outcome collapse_edge(Kernel& kernel, TetId t, int edge, const CollapseRules& rules);

}  // namespace taut
