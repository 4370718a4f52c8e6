// Renumbering of a mesh under work.
#pragma once

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Renumbers the vertices along a Hilbert curve, the tetrahedra and triangles by their smallest vertex, and drops dead
/// entities. Locality decays as a mesh grows: a miss costs as much as a hundred operations.
void reorder(TetMesh& mesh);

}  // namespace taut
