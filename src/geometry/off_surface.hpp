// Vertices of the boundary that are not on the surface that was given for it.
#pragma once

#include <vector>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Those that are farther from their patch, line or corner of the given surface than rounding explains, ascending. None
/// without a given surface.
[[nodiscard]] std::vector<VertexId> vertices_off_surface(const TetMesh& mesh, const Model& model);

/// Throws InputError for a vertex that is farther from its patch, line or corner of the given surface than half the
/// longest edge of its triangles.
void require_near_surface(const TetMesh& mesh, const Model& model);

}  // namespace taut
