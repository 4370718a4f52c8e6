// Bounds on the wanted sizes.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// The metric with its sizes clipped to [hmin, hmax], that is, its eigenvalues to [hmax^-2, hmin^-2] (Dobrzynski and
/// Frey 2008, 2.4). hmin may be 0 and hmax infinite; 0 <= hmin <= hmax. If there is nothing to clip, the result is `m`
/// bit for bit.
[[nodiscard]] Sym3 truncate(const Sym3& m, double hmin, double hmax);

}  // namespace taut
