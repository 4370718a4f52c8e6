// A vertex merged into its neighbour.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct CollapseRules {
  double longest_new_edge = 1.5;  ///< unless the vanishing vertex has a longer one
  /// A new tetrahedron is too bad if its 1/Q is not above the smaller of these, the second times the worst that goes.
  double worst_quality = 0.3, share_of_old = 0.7;
};

/// Removes one end of the edge, the first that can go. Marks the shell as tried.
Outcome collapse_edge(Kernel& kernel, TetId t, int edge, const CollapseRules& rules);

}  // namespace taut
