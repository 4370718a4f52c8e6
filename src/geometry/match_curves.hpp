// The curves and corners of a given surface on which the edges and vertices of a mesh lie.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/match_patches.hpp"
#include "mesh/build.hpp"
#include "surface/reference_surface.hpp"
#include "surface/surface_edges.hpp"
#include "taut/mesh.hpp"

namespace taut {

struct CurveMatch {
  std::array<VertexId, 2> edge{};  ///< of the mesh, ascending
  LineId curve = none;
};

struct CornerMatch {
  VertexId vertex = none;  ///< of the mesh
  Vec3 place{};            ///< of the surface's corner
};

/// In ascending order of edges. Where triangles of two patches meet, it is the curve between these that is closest to
/// the edge; where other than two triangles meet, or one that lies on no patch, a curve of their patches that runs
/// along the edge; and so for edges that are given in `input` inside one patch. Throws InputError where no curve runs
/// between two patches that meet.
[[nodiscard]] std::vector<CurveMatch> match_curves(const ReferenceSurface& surface, const Mesh& input,
                                                   const Built& built, std::span<const PatchMatch> patches,
                                                   const std::vector<EdgeUse>& uses);

/// For each corner of the patches that the mesh has the nearest vertex: of the edges of curves, or else of any edges.
/// An end of a curve inside a patch that the mesh does not have needs none. Throws InputError for any other corner
/// without a vertex of its own within half an edge.
[[nodiscard]] std::vector<CornerMatch> match_corners(const ReferenceSurface& surface, const Built& built,
                                                     std::span<const PatchMatch> patches,
                                                     std::span<const CurveMatch> curves);

}  // namespace taut
