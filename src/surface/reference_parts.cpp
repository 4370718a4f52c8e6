#include "surface/reference_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "base/each_once.hpp"
#include "base/grouping.hpp"

namespace taut {
namespace {

/// Rounding of the bounds must not hide a patch from a search.
constexpr double safety_of_bound = 1e-12;

TriangleTree tree_of(const Facets& facets, std::span<const CubicTriangle> cubics,
                     const std::vector<TriangleId>& triangles) {
  std::vector<std::array<Index, 3>> corners;
  std::vector<double> slack;
  for (const TriangleId t : triangles) {
    corners.push_back(indices(facets.triangles[t]));
    const auto& v = cubics[t].corner;
    slack.push_back(deviation_bound(cubics[t]) + safety_of_bound * (norm(v[1] - v[0]) + norm(v[2] - v[0])));
  }
  return {facets.points, corners, slack};
}

/// No point of the segment is farther from its chord than its handles are.
double deviation_of_segment(const CubicSegment& b) {
  const Vec3 e = b[3] - b[0];
  double farthest = 0;
  for (const std::size_t k : {1, 2}) {
    const Vec3 from = b[k] - b[0];
    farthest = std::max(farthest, norm(from - std::clamp(dot(from, e) / dot(e, e), 0.0, 1.0) * e));
  }
  return farthest + safety_of_bound * norm(e);
}

/// Segments are triangles of two corners.
TriangleTree tree_of(const Facets& facets, const RidgeCurve& curve) {
  std::vector<std::array<Index, 3>> chords;
  std::vector<double> slack;
  for (std::size_t i = 0; i < curve.segments.size(); ++i) {
    chords.push_back({curve.vertices[i], curve.vertices[i + 1], curve.vertices[i + 1]});
    slack.push_back(deviation_of_segment(curve.segments[i]));
  }
  return {facets.points, chords, slack};
}

}  // namespace

RidgesOfTriangles ridges_of_triangles(std::span<const Corners> triangles, std::span<const RidgeEdge> ridges) {
  RidgesOfTriangles found(triangles.size(), {none, none, none});
  Index next = 0;
  for_each_edge(edge_uses(triangles), [&](std::span<const EdgeUse> uses) {
    if (next == ridges.size() || ridges[next].edge != uses[0].edge) return;
    for (const EdgeUse& use : uses) found[use.triangle][use.corner] = next;
    ++next;
  });
  return found;
}

std::vector<PatchId> find_patches(std::size_t triangles, std::span<const EdgePair> smooth_edges) {
  DisjointSets sets(triangles);
  for (const auto& [s, t] : smooth_edges) sets.join(s.triangle, t.triangle);
  std::vector<PatchId> patch_of(triangles);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::uint32_t root = sets.root(t);
    patch_of[t] = root == t ? PatchId{count++} : patch_of[root];
  }
  return patch_of;
}

std::optional<Index> ReferencePatch::place_of(TriangleId t) const {
  const auto at = std::ranges::lower_bound(triangles, t);
  if (at == triangles.end() || *at != t) return std::nullopt;
  return static_cast<Index>(at - triangles.begin());
}

std::vector<ReferencePatch> make_patches(const Facets& facets, std::span<const int> refs,
                                         std::span<const CubicTriangle> cubics, std::span<const PatchId> patch_of) {
  const std::uint32_t count = *std::max_element(patch_of.begin(), patch_of.end()) + 1;
  const auto members = group<TriangleId>({patch_of.begin(), patch_of.end()}, count);
  std::vector<ReferencePatch> patches;
  patches.reserve(count);
  for (const auto& triangles : members)
    patches.push_back({refs[triangles[0]], triangles, tree_of(facets, cubics, triangles)});
  return patches;
}

std::vector<ReferenceCurve> make_curves(const Facets& facets, RidgeCurves ridges, const RidgesOfTriangles& ridges_of,
                                        std::span<const PatchId> patch_of) {
  std::vector<LineId> curve_of_ridge(ridges.of_edge.size(), none);
  std::vector<ReferenceCurve> curves;
  curves.reserve(ridges.curves.size());
  for (RidgeCurve& curve : ridges.curves) {
    for (const Index e : curve.edges) curve_of_ridge[e] = static_cast<LineId>(curves.size());
    TriangleTree tree = tree_of(facets, curve);
    curves.push_back({curve.ref, std::move(curve.vertices), std::move(curve.segments), {}, std::move(tree)});
  }
  for (std::size_t t = 0; t < ridges_of.size(); ++t)
    for (const Index ridge : ridges_of[t])
      if (ridge != none) curves[curve_of_ridge[ridge]].patches.push_back(patch_of[t]);
  for (ReferenceCurve& curve : curves) keep_each_once(curve.patches);
  return curves;
}

std::vector<ReferenceCorner> make_corners(const Facets& facets, std::span<const std::uint8_t> is_corner,
                                          std::span<const ReferenceCurve> curves, std::span<const PatchId> patch_of) {
  std::vector<ReferenceCorner> corners;
  std::vector<Index> corner_at(facets.points.size(), none);
  for (const VertexId v : ids<VertexId>(facets.points.size())) {
    if (is_corner[v] == 0) continue;
    corner_at[v] = static_cast<Index>(corners.size());
    corners.push_back({v, {}, {}});
  }
  for (const LineId l : ids<LineId>(curves.size()))
    for (const VertexId end : {curves[l].vertices.front(), curves[l].vertices.back()})
      if (corner_at[end] != none) corners[corner_at[end]].curves.push_back(l);
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const VertexId v : facets.triangles[t])
      if (corner_at[v] != none) corners[corner_at[v]].patches.push_back(patch_of[t]);
  for (ReferenceCorner& corner : corners) {
    keep_each_once(corner.curves);
    keep_each_once(corner.patches);
  }
  return corners;
}

}  // namespace taut
