// What the options of all adaptations to solutions have in common.
#pragma once

#include "taut/adapt.hpp"
#include "taut/sizing.hpp"

namespace taut {

/// Throws InputError for options that make no sense, before any work begins. Limits of the adaptation are refused: they
/// would change the metric after it was scaled to the complexity.
void require_sound(const LpOptions& sizing, const AdaptOptions& adapt);

}  // namespace taut
