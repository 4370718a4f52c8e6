// Bounds on the wanted sizes.
#pragma once

#include "base/sym3.hpp"
#include "taut/limits.hpp"

namespace taut {

/// Eigenvalues, ascending, of a metric whose sizes are bounded: first by the anisotropy, which shortens the long ones,
/// then clipped to [hmin, hmax], that is, the eigenvalues to [hmax^-2, hmin^-2] (Dobrzynski and Frey 2008, 2.4). hmin
/// may be 0 and hmax infinite; 0 <= hmin <= hmax. The gradation of the limits is not looked at.
[[nodiscard]] Vec3 truncate(const Vec3& eigenvalues, const Limits& limits);

/// The metric with these eigenvalues. If there is nothing to clip, the result is `m` bit for bit.
[[nodiscard]] Sym3 truncate(const Sym3& m, const Limits& limits);

}  // namespace taut
