// Groups triangles into patches and finds their shapes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/features.hpp"
#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// How far from its plane or line a vertex may lie.
[[nodiscard]] double flatness_tolerance(const TetMesh& mesh);

/// Sets the patch of each triangle: those that meet at an edge are of one patch unless it is a feature edge. `refs` and
/// `required` have an entry per triangle. The shapes are not known yet.
[[nodiscard]] std::vector<Patch> group_patches(TetMesh& mesh, const std::vector<EdgeUse>& uses,
                                               std::span<const Feature> features, std::span<const int> refs,
                                               std::span<const std::uint8_t> required);

/// Sets the shape of each patch. One none of whose vertices is farther than `tolerance` from the plane of its largest
/// triangle is planar; others, and those of required triangles, are frozen.
void find_shapes(const TetMesh& mesh, std::vector<Patch>& patches, double tolerance);

}  // namespace taut
