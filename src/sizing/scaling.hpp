// The factor that gives a metric a wanted complexity.
#pragma once

#include <functional>
#include <vector>

#include "metric/spectral.hpp"
#include "taut/mesh.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// The metric `shape` times the factor for which the complexity is `wanted` after the limits are applied; hmax must be
/// finite. The complexity never falls as the factor grows, so there is one unless hmin or hmax forbids it.
[[nodiscard]] ScaledMetric scaled_to(double wanted, const Mesh& mesh, std::vector<Spectrum> shape,
                                     const Limits& limits);

}  // namespace taut
