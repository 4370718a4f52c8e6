#include "geometry/match_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/each_once.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// Share of its length up to which an edge may be away from a curve along which it runs, and a vertex of that edge from
// a corner that the mesh need not have.
constexpr double near_curve = 0.1;

std::vector<std::array<VertexId, 2>> edges_of_input(const Mesh& input, const Built& built) {
  std::vector<std::array<VertexId, 2>> edges;
  for (const auto& [p, q] : input.edges) {
    const auto [a, b] = std::minmax({built.vertex_of_point[p], built.vertex_of_point[q]});
    edges.push_back({a, b});
  }
  keep_each_once(edges);
  return edges;
}

class CurveMatcher {
public:
  CurveMatcher(const ReferenceSurface& surface, const Mesh& input, const Built& built,
               std::span<const PatchMatch> matches)
      : surface_(surface),
        mesh_(built.mesh),
        matches_(matches),
        given_(edges_of_input(input, built)),
        curves_of_(surface.patches().size()) {
    for (const LineId l : ids<LineId>(surface.curves().size()))
      for (const PatchId p : surface.curves()[l].patches) curves_of_[p].push_back(l);
  }

  [[nodiscard]] LineId at(std::span<const EdgeUse> uses) const {
    const auto& edge = uses[0].edge;
    std::vector<PatchId> patches;
    for (const EdgeUse& use : uses)
      if (matches_[use.triangle].patch != none) patches.push_back(matches_[use.triangle].patch);
    if (patches.empty()) return none;
    const bool is_ordinary = uses.size() == 2 && patches.size() == 2;
    keep_each_once(patches);
    const bool is_inside = is_ordinary && patches.size() == 1;
    if (is_inside && !std::ranges::binary_search(given_, edge)) return none;
    const Near near = nearest(edge, patches, is_inside);
    if (is_ordinary && !is_inside) {
      if (near.curve == none) refuse(edge);
      return near.curve;
    }
    return near.distance <= near_curve * norm(mesh_.x(edge[1]) - mesh_.x(edge[0])) ? near.curve : LineId{none};
  }

private:
  struct Near {
    LineId curve = none;
    double distance = std::numeric_limits<double>::infinity();  // the largest of the ends and the middle
    double sum = std::numeric_limits<double>::infinity();
  };

  // Of the curves that bound all these patches and, if asked for, no other.
  [[nodiscard]] Near nearest(const std::array<VertexId, 2>& edge, const std::vector<PatchId>& patches,
                             bool no_other) const {
    const Vec3 &a = mesh_.x(edge[0]), &b = mesh_.x(edge[1]);
    Near best;
    for (const LineId l : curves_of_[patches[0]]) {
      const auto& bounded = surface_.curves()[l].patches;
      if (!std::ranges::includes(bounded, patches) || (no_other && bounded.size() != patches.size())) continue;
      Near near{l, 0, 0};
      for (const Vec3& x : {a, 0.5 * (a + b), b}) {
        const double distance = surface_.closest_on(l, x).distance;
        near.distance = std::max(near.distance, distance);
        near.sum += distance;
      }
      if (near.sum < best.sum) best = near;
    }
    return best;
  }

  [[noreturn]] void refuse(const std::array<VertexId, 2>& edge) const {
    throw InputError(fmt::format(
        "geometry: no ridge found between the patches of the two triangles at edge {}, expected one along the edge",
        place_of(mesh_, edge)));
  }

  const ReferenceSurface& surface_;
  const TetMesh& mesh_;
  std::span<const PatchMatch> matches_;
  std::vector<std::array<VertexId, 2>> given_;  // ascending
  std::vector<std::vector<LineId>> curves_of_;  // by patch
};

// By vertex: the longest edge of its triangles on patches, or of its edges on curves. 0 for other vertices.
using Reaches = std::vector<double>;

void extend(Reaches& reaches, const TetMesh& mesh, VertexId a, VertexId b) {
  const double length = norm(mesh.x(b) - mesh.x(a));
  for (const VertexId v : {a, b}) reaches[v] = std::max(reaches[v], length);
}

Reaches reaches_of(const TetMesh& mesh, std::span<const PatchMatch> patches) {
  Reaches reaches(mesh.vertices.size(), 0);
  for (const TriangleId t : mesh.triangle_ids())
    if (patches[t].patch != none)
      for (std::size_t k = 0; k < 3; ++k)
        extend(reaches, mesh, mesh.triangles[t].v[k], mesh.triangles[t].v[(k + 1) % 3]);
  return reaches;
}

Reaches reaches_of(const TetMesh& mesh, std::span<const CurveMatch> curves) {
  Reaches reaches(mesh.vertices.size(), 0);
  for (const CurveMatch& match : curves) extend(reaches, mesh, match.edge[0], match.edge[1]);
  return reaches;
}

VertexId nearest_vertex(const TetMesh& mesh, const Reaches& reaches, const Vec3& x, double share) {
  VertexId nearest = none;
  double least = std::numeric_limits<double>::infinity();
  for (const VertexId v : mesh.vertex_ids()) {
    const double distance = reaches[v] > 0 ? norm(mesh.x(v) - x) : least;
    if (distance >= least || distance > share * reaches[v]) continue;
    least = distance;
    nearest = v;
  }
  return nearest;
}

}  // namespace

std::vector<CurveMatch> match_curves(const ReferenceSurface& surface, const Mesh& input, const Built& built,
                                     std::span<const PatchMatch> patches, const std::vector<EdgeUse>& uses_of_edges) {
  const CurveMatcher matcher(surface, input, built, patches);
  std::vector<CurveMatch> matches;
  for_each_edge(uses_of_edges, [&](std::span<const EdgeUse> uses) {
    if (const LineId curve = matcher.at(uses); curve != none) matches.push_back({uses[0].edge, curve});
  });
  return matches;
}

std::vector<CornerMatch> match_corners(const ReferenceSurface& surface, const Built& built,
                                       std::span<const PatchMatch> patches, std::span<const CurveMatch> curves) {
  const TetMesh& mesh = built.mesh;
  std::vector<std::uint8_t> has_patch(surface.patches().size(), 0), is_taken(mesh.vertices.size(), 0);
  for (const PatchMatch& match : patches)
    if (match.patch != none) has_patch[match.patch] = 1;
  const Reaches on_surface = reaches_of(mesh, patches), on_curves = reaches_of(mesh, curves);
  // A ridge with one patch on both sides may end anywhere: the mesh need not have it.
  const auto is_needed = [&](LineId l) {
    return surface.curves()[l].patches.size() > 1 || std::ranges::find(curves, l, &CurveMatch::curve) != curves.end();
  };
  std::vector<CornerMatch> matches;
  for (const ReferenceCorner& corner : surface.corners()) {
    if (std::ranges::none_of(corner.patches, [&](PatchId p) { return has_patch[p] != 0; })) continue;
    const Vec3& x = surface.facets().points[corner.vertex];
    const bool may_miss = !corner.curves.empty() && std::ranges::none_of(corner.curves, is_needed);
    const double share = may_miss ? near_curve : farthest_share;
    // An apex lies on no curve: near it may be vertices of curves that are none of its own.
    VertexId v = corner.curves.empty() ? VertexId{none} : nearest_vertex(mesh, on_curves, x, share);
    if (v == none) v = nearest_vertex(mesh, on_surface, x, share);
    const bool is_missing = v == none || is_taken[v] != 0;
    if (is_missing && may_miss) continue;
    if (is_missing)
      throw InputError(fmt::format(
          "geometry: no vertex found for the corner at ({:.6g} {:.6g} {:.6g}), expected one within half an edge", x[0],
          x[1], x[2]));
    is_taken[v] = 1;
    matches.push_back({v, x});
  }
  return matches;
}

}  // namespace taut
