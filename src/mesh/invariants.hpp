// The invariants of a working mesh, which hold between any two operations.
#pragma once

#include <span>
#include <string>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// The first fault of the mesh, naming the entity; empty if there is none. Checked: tetrahedra are exactly positive;
/// faces that meet have the same vertices in opposite orientation and link to each other; the sides of triangles link
/// back, and side 0 sees its triangle outward; regions meet only at triangles; each living vertex knows one of its
/// tetrahedra; arrays of one kind of entity have equal length; the free lists hold as many entities as are dead.
///
/// `region_refs` holds the reference of each region. Regions of the same reference, such as required and other
/// tetrahedra, may meet anywhere. If it is empty, no two regions may.
[[nodiscard]] std::string first_broken_invariant(const TetMesh& mesh, std::span<const int> region_refs = {});

/// The same for some living tetrahedra, their vertices and triangles, and the adjacent faces. Regions are compared only
/// among these tetrahedra. For use after an operation.
[[nodiscard]] std::string first_broken_invariant(const TetMesh& mesh, std::span<const TetId> tets);

}  // namespace taut
