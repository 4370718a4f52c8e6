// A vertex moved onto the surface that was given for the boundary.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

/// Moves v to its place on the geometry or, if tetrahedra would become flat, half, a quarter or an eighth of the way.
Outcome snap(Kernel& kernel, VertexId v);

}  // namespace taut
