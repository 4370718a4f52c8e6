// From the caller's arrays to a working mesh with its geometry and target.
#pragma once

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Throws InputError for an option that is out of range.
void require_options(const AdaptOptions& options);

/// The mesh as it is now becomes the place where metrics are looked up; `input` is the same with the numbers that its
/// vertices have as origins, for which the metric is given. Throws InputError if the metric cannot be used.
void set_target(Session& session, const Mesh& input, const Metric& metric, const AdaptOptions& options);

/// Throws InputError if the mesh or the metric cannot be used. Fills the report's counts of corrections to the input.
[[nodiscard]] Session set_up(const Mesh& mesh, const Metric& metric, const AdaptOptions& options, Report& report);

}  // namespace taut
