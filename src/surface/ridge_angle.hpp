// The check of an angle from which on edges are ridges.
#pragma once

namespace taut {

/// Throws InputError unless it is above 0 and below 180 degrees.
void require_ridge_angle(double degrees);

}  // namespace taut
