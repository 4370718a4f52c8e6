// Relocation: moves a vertex so that its edges are nearer to unit and its ball is better.
#pragma once

#include "operators/kernel.hpp"
#include "operators/vertex_move.hpp"

namespace taut {

struct RelocationRules {
  double factor = 0.3;     ///< of the forces: 0.7 converges to worse meshes, 0.4 stalls tau at .899
  double good_enough = 1;  ///< a ball whose worst 1/Q is above this is not changed
  MoveRules move{};
};

/// If the ball of v is decent, moves v by edge-length forces (Bossen and Heckbert 1996), which may reduce the quality
/// slightly. Otherwise moves it toward the mean of the points at unit length from its neighbours (Dobrzynski and Frey
/// 2008, 4.2), which must improve the worst quality. A vertex on a patch or line stays on it. Clears `restless` of v
/// unless it moved far.
Outcome relocate(Kernel& kernel, VertexId v, const RelocationRules& rules);

}  // namespace taut
