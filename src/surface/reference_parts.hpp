// The parts of a reference surface: patches, the curves between them, and the corners where these end.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "locate/triangle_tree.hpp"
#include "surface/cubic_segment.hpp"
#include "surface/cubic_triangle.hpp"
#include "surface/facets.hpp"
#include "surface/ridge_curves.hpp"

namespace taut {

/// A smooth part of the surface: triangles of one reference that smooth edges connect. It ends at a ridge, unless one
/// can go around the ridge.
struct ReferencePatch {
  int ref = 0;
  std::vector<TriangleId> triangles;  ///< ascending
  TriangleTree tree;                  ///< of these, in this order

  /// In `triangles`; nothing if it is of another patch or `none`.
  [[nodiscard]] std::optional<Index> place_of(TriangleId t) const;
};

/// A smooth ridge between two corners, or a closed one.
struct ReferenceCurve {
  int ref = 0;
  std::vector<VertexId> vertices;      ///< along it
  std::vector<CubicSegment> segments;  ///< between these
  std::vector<PatchId> patches;        ///< that it bounds, ascending
  TriangleTree tree;                   ///< of the segments
};

/// A vertex where curves end, or the apex of a patch.
struct ReferenceCorner {
  VertexId vertex = none;
  std::vector<LineId> curves;    ///< that end here, ascending
  std::vector<PatchId> patches;  ///< that meet here, ascending
};

/// For each triangle the ridge on the edge opposite to each corner, or `none`.
using RidgesOfTriangles = std::vector<std::array<Index, 3>>;

[[nodiscard]] RidgesOfTriangles ridges_of_triangles(std::span<const Corners> triangles,
                                                    std::span<const RidgeEdge> ridges);

/// For each triangle the number of its patch, which are those of connected triangles, by their first one.
[[nodiscard]] std::vector<PatchId> find_patches(std::size_t triangles, std::span<const EdgePair> smooth_edges);

/// `refs`, `cubics` and `patch_of` are by triangle.
[[nodiscard]] std::vector<ReferencePatch> make_patches(const Facets& facets, std::span<const int> refs,
                                                       std::span<const CubicTriangle> cubics,
                                                       std::span<const PatchId> patch_of);

[[nodiscard]] std::vector<ReferenceCurve> make_curves(const Facets& facets, RidgeCurves ridges,
                                                      const RidgesOfTriangles& ridges_of,
                                                      std::span<const PatchId> patch_of);

/// Of the vertices that are marked.
[[nodiscard]] std::vector<ReferenceCorner> make_corners(const Facets& facets, std::span<const std::uint8_t> is_corner,
                                                        std::span<const ReferenceCurve> curves,
                                                        std::span<const PatchId> patch_of);

}  // namespace taut
