// Edges that a user wants to be ridges.
#pragma once

#include <array>
#include <span>

#include "taut/export.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// The mesh with these edges as ridges too, whatever the angle there. Each is an edge of a triangle, of one that is
/// missing on the boundary or between regions as well. An edge that the mesh has keeps its reference and is marked
/// once; others are added, with the reference 0. Throws InputError that begins with "ridges: " and names the edge if it
/// is none of these; others for a mesh that cannot be used.
[[nodiscard]] TAUT_EXPORT Mesh with_ridges(Mesh mesh, std::span<const std::array<Index, 2>> edges);

/// The same for the ridges of another mesh, or for all its edges if none is a ridge; only its points, edges and ridges
/// count. Its points are found in `mesh` by their places: that point of a triangle which is nearest, at most 1e-6 of
/// the diagonal of the bounding box away. If several points of `mesh` lie there, as on both sides of a slit, the edges
/// of all are meant. Throws InputError too, naming the point, where there is none.
[[nodiscard]] TAUT_EXPORT Mesh with_ridges(Mesh mesh, const Mesh& lines);

}  // namespace taut
