// From the caller's arrays to a mesh that can be worked on.
#pragma once

#include <memory>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"
#include "sizing/target.hpp"
#include "taut/adapt.hpp"

namespace taut {

struct Problem {
  TetMesh mesh;  ///< with metrics and qualities
  Model model;
  std::unique_ptr<Target> target;
};

/// Throws InputError for an option out of its range.
void require_options(const AdaptOptions& options);

/// Throws InputError for whatever cannot be used. Fills the report's counts of what was mended.
[[nodiscard]] Problem set_up(const Mesh& mesh, const Metric& metric, const AdaptOptions& options, Report& report);

}  // namespace taut
