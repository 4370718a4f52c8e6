// Renumbering of a mesh under work.
#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// For each old id the new one; `none` for what was dead.
struct Renumbering {
  std::vector<VertexId> vertex;
  std::vector<TetId> tet;
  std::vector<TriangleId> triangle;
};

/// Renumbers the vertices along a Hilbert curve, the tetrahedra and triangles by their smallest vertex, and drops dead
/// entities. Locality decays as a mesh grows: a miss costs as much as a hundred operations.
Renumbering reorder(TetMesh& mesh);

}  // namespace taut
