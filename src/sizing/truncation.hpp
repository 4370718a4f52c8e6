// Bounds on the wanted sizes.
#pragma once

#include "base/sym3.hpp"

namespace taut {

/// The metric with its sizes brought into [hmin, hmax]: eigenvalues clipped to [hmax^-2, hmin^-2] (Dobrzynski and Frey
/// 2008, 2.4). hmin may be 0 and hmax infinite; 0 <= hmin <= hmax. Bit for bit `m` where nothing is to be clipped.
[[nodiscard]] Sym3 truncate(const Sym3& m, double hmin, double hmax);

}  // namespace taut
