// Groups triangles into patches and fits planes to them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Sets the patch of each triangle: those joined, directly or through others, are of one. A patch none of whose
/// vertices is farther than `tolerance` from the plane of its largest triangle is planar; others, and those of required
/// triangles, are frozen. `refs` and `required` have an entry a triangle.
[[nodiscard]] std::vector<Patch> make_patches(TetMesh& mesh, std::span<const std::array<TriangleId, 2>> joined,
                                              std::span<const int> refs, std::span<const std::uint8_t> required,
                                              double tolerance);

}  // namespace taut
