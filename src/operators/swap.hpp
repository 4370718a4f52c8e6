// Swaps: replace edges and faces by better ones.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct SwapRules {
  double good_enough = 0.95;      ///< nothing is tried if the worst 1/Q is above this
  double poor = 0.3;              ///< faces are tried only on tetrahedra with 1/Q up to this
  double gain = 1.02;             ///< the worst 1/Q must grow by this factor
  double longest_new_edge = 1.6;  ///< unless the removed edge is longer
};

/// Replaces the edge's shell (of at most 7 tetrahedra) by the fan from a ring vertex whose worst element is best
/// (Dobrzynski and Frey 2008, 4.2). Marks the shell as tried.
Outcome swap_edge(Kernel& kernel, TetId t, int edge, const SwapRules& rules);

/// Replaces the face by the edge between the two vertices opposite to it. Marks both tetrahedra as tried.
Outcome swap_face(Kernel& kernel, TetId t, int face, const SwapRules& rules);

}  // namespace taut
