// A vertex moved to where its edges are nearer to unit and its ball is better.
#pragma once

#include "cavity/kernel.hpp"

namespace taut {

struct RelocationRules {
  double factor = 0.3;     ///< of the forces
  double good_enough = 1;  ///< a ball whose worst 1/Q is above it is left alone
  double still = 0.03;     ///< a move shorter than it, in the metric, changes nothing for the neighbours
  double drift = 0.1;      ///< moves that add up to more than it make swaps around worth trying again
};

/// Moves v by edge-length forces (Bossen and Heckbert 1996) where its ball is decent: quality may then give a little;
/// otherwise toward the mean of the points at unit length from its neighbours (Dobrzynski and Frey 2008, 4.2), which
/// must improve the worst quality. On a patch or line it stays there. Clears `restless` of v unless it moved far.
Refusal relocate(Kernel& kernel, VertexId v, const RelocationRules& rules);

/// Moves v off the face opposite to it in the worst tetrahedron of its ball, if the worst 1/Q grows by the factor
/// `gain`.
Refusal lift(Kernel& kernel, VertexId v, double gain);

}  // namespace taut
