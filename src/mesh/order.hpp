// Renumbering of a working mesh.
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

/// Renumbers the vertices along a Hilbert curve and the tetrahedra and triangles by their smallest vertex, and removes
/// dead entities. Locality decays as a mesh grows, and a cache miss costs as much as a hundred arithmetic operations.
Renumbering reorder(TetMesh& mesh);

}  // namespace taut
