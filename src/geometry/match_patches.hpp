// The patches of a given surface on which the triangles of a mesh lie.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/model.hpp"
#include "mesh/build.hpp"
#include "surface/reference_surface.hpp"
#include "surface/surface_edges.hpp"

namespace taut {

struct PatchMatch {
  PatchId patch = none;
  double sense = 1;  ///< of the triangle, compared with that of the patch: 1 or -1
};

/// How far from the given surface the mesh may be, as a share of the longest edge there.
inline constexpr double farthest_share = 0.5;

/// For each triangle the patch of its reference that is closest to its centre, unless it is perpendicular to it; where
/// several are about as close, that of most neighbours. Without patches of that reference, if it is 0 or the surface
/// has no references at all, all patches count. Triangles that are required or on a planar patch of the mesh (of
/// `patches`, by angle) may be none of the surface's. Throws InputError for any other triangle without a patch.
[[nodiscard]] std::vector<PatchMatch> match_patches(const ReferenceSurface& surface, const Built& built,
                                                    const std::vector<Patch>& patches,
                                                    const std::vector<EdgeUse>& uses);

/// "1 2 3 of the mesh at (x y z)", the numbers of vertices as in files.
[[nodiscard]] std::string place_of(const TetMesh& mesh, std::span<const VertexId> vertices);

}  // namespace taut
