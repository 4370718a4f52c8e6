// The links between faces.
#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Fills the face links of the tetrahedra and the sides of the triangles of `mesh`, whose triangles are those of
/// `input` in its order. Appends the triangles that are missing on the boundary and between regions of different
/// reference. Throws InputError for a face of three tetrahedra, and for a triangle that is not a face or occurs twice.
void connect(TetMesh& mesh, const Mesh& input, const std::vector<int>& region_refs);

}  // namespace taut
