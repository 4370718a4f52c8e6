// Where each vertex lives on the geometry.
#pragma once

#include <span>

#include "geometry/lines.hpp"
#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Sets the lines of the triangles' edges and the tags of the vertices, and adds the corners to the model, which has
/// its patches and lines.
void set_tags(TetMesh& mesh, Model& model, const FeatureGraph& graph, std::span<const LineId> line_of_feature);

}  // namespace taut
