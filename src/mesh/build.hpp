// Builds the working mesh from the plain arrays of the public mesh, and checks them.
#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"
#include "taut/mesh.hpp"

namespace taut {

struct Built {
  TetMesh mesh;                           ///< in Hilbert order; no patches, lines, tags or metrics yet
  std::vector<VertexId> vertex_of_point;  ///< `none` for a point that belongs to no tetrahedron
  std::vector<TriangleId> triangle_of_input;
  std::vector<TetId> tet_of_input;
  std::vector<int> region_refs;               ///< reference of each region
  std::vector<std::uint8_t> region_required;  ///< whether it holds the required tetrahedra of that reference
  std::vector<int> triangle_refs;             ///< reference of each triangle of `mesh`; 0 for those that were missing
  std::size_t reoriented = 0;                 ///< inverted tetrahedra that were reoriented
  std::size_t triangles_built = 0;            ///< missing triangles that were added on the boundary and between regions
};

/// Throws InputError, naming the entity (counted from 1 as in files), for an index out of range, a coordinate that is
/// not finite, a tetrahedron that is flat, repeats a vertex or overlaps a neighbour, a face of three tetrahedra, a
/// triangle that is not a face or occurs twice, or reference arrays of the wrong length.
[[nodiscard]] Built build(const Mesh& input);

}  // namespace taut
