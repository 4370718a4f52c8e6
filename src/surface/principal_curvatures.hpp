// How a level set is curved.
#pragma once

#include "metric/spectral.hpp"
#include "surface/derivatives.hpp"

namespace taut {

/// Of the level set through the point where a function has these derivatives; its gradient is not zero. The first two
/// values are the principal curvatures with their directions. The last vector is the normal, its value means nothing.
/// The curvatures are positive where the level set bends away from the gradient, as a sphere does from its outward
/// normal.
[[nodiscard]] Spectrum principal_curvatures(const Derivatives& d);

}  // namespace taut
