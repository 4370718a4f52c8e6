// A vertex moved off the face that the worst tetrahedron of its ball is flat on.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

/// Moves v away from the opposite face in the worst tetrahedron of its ball, if the worst 1/Q grows by the factor
/// `gain`.
Outcome lift(Kernel& kernel, VertexId v, double gain);

}  // namespace taut
