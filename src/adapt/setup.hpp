// From the caller's arrays to a mesh that can be worked on.
#pragma once

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Throws InputError for an option out of its range.
void require_options(const AdaptOptions& options);

/// Throws InputError for whatever cannot be used. Fills the report's counts of what was mended.
[[nodiscard]] Session set_up(const Mesh& mesh, const Metric& metric, const AdaptOptions& options, Report& report);

}  // namespace taut
