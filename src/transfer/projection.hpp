// The conservative projection from the integrals.
#pragma once

#include "transfer/system.hpp"

namespace taut {

/// The moments divided by the volumes: an average with no negative weight, bounded and conservative, but too smooth. A
/// vertex around which nothing is covered has the value in `otherwise`.
[[nodiscard]] Values lumped(const System& system, Values otherwise);

/// The lumped solution plus the fluxes m_ij (u_i - u_j) of the consistent one, which lead back to it and cancel out in
/// the sum. Limited, only the part of each flux that keeps all vertices within their bounds (Zalesak 1979; Farrell et
/// al. 2009 for projections): still conservative, because both ends of a flux change by the same amount.
[[nodiscard]] Values corrected(const System& system, const Values& lumped, const Values& consistent, bool is_limited);

}  // namespace taut
