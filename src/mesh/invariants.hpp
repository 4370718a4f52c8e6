// What holds of a mesh under work between any two operations.
#pragma once

#include <span>
#include <string>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// What is wrong with the mesh, naming the entity; empty when it is sound. Checked: tetrahedra are exactly positive,
/// faces that meet have the same vertices run through oppositely and link to each other, the sides of triangles link
/// back and side 0 sees its triangle outward, regions meet at triangles only, each living vertex knows a tetrahedron of
/// its own, arrays of one entity are equally long, and the free lists hold as many entities as are dead.
///
/// `region_refs` holds the reference of each region: regions of one reference, as the required tetrahedra and the
/// others, may meet anywhere. Empty: no two may.
[[nodiscard]] std::string first_broken_invariant(const TetMesh& mesh, std::span<const int> region_refs = {});

/// The same for some living tetrahedra, their vertices and triangles, and the faces across. Regions are compared among
/// these tetrahedra only. For use after an operation.
[[nodiscard]] std::string first_broken_invariant(const TetMesh& mesh, std::span<const TetId> tets);

}  // namespace taut
