#include "geometry/reference.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/largest_plane.hpp"
#include "surface/surface_input.hpp"

namespace taut {
namespace {

// If no vertex is farther from it than the tolerance.
std::optional<Plane> plane_of(const ReferenceSurface& surface, const ReferencePatch& patch, double tolerance) {
  LargestPlane largest;
  for (const TriangleId t : patch.triangles) largest.add(surface.cubic_of(t).corner);
  const bool is_planar = std::ranges::all_of(patch.triangles, [&](TriangleId t) {
    return std::ranges::all_of(surface.cubic_of(t).corner,
                               [&](const Vec3& x) { return distance(largest.plane(), x) <= tolerance; });
  });
  return is_planar ? std::optional<Plane>{largest.plane()} : std::nullopt;
}

bool is_straight_curve(const ReferenceCurve& curve, double tolerance) {
  const Vec3 begin = curve.segments.front()[0], along = curve.segments.back()[3] - begin;
  const double length = norm(along);
  return length > tolerance && std::ranges::all_of(curve.segments, [&](const CubicSegment& segment) {
           return std::ranges::all_of(
               segment, [&](const Vec3& x) { return norm(cross(x - begin, along)) <= tolerance * length; });
         });
}

// Of the mesh's own triangle, which may have been turned round.
double sense_of_own(const ReferenceSurface& surface, const TetMesh& mesh, TriangleId t) {
  const Corners &ours = mesh.triangles[t].v, &theirs = surface.facets().triangles[t];
  const auto first = std::ranges::find(theirs, ours[0]) - theirs.begin();
  return theirs[static_cast<std::size_t>(first + 1) % 3] == ours[1] ? 1 : -1;
}

std::vector<CurveMatch> own_ridges(const ReferenceSurface& surface) {
  std::vector<CurveMatch> ridges;
  for (const LineId l : ids<LineId>(surface.curves().size())) {
    const ReferenceCurve& curve = surface.curves()[l];
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) {
      const auto [a, b] = std::minmax(curve.vertices[i], curve.vertices[i + 1]);
      ridges.push_back({{a, b}, l});
    }
  }
  std::ranges::sort(ridges, {}, &CurveMatch::edge);
  return ridges;
}

}  // namespace

Reference::Reference(const Mesh& input, const Built& built, std::optional<double> angle)
    : surface_(std::make_shared<const ReferenceSurface>(
          with_marks({facets_of(built.mesh), built.triangle_refs, {}, {}}, input, built.vertex_of_point), angle)),
      ridges_(own_ridges(*surface_)),
      in_plane_(built.mesh.triangles.size(), 1) {
  for (const TriangleId t : built.mesh.triangle_ids())
    matches_.push_back({surface_->patch_of(t), sense_of_own(*surface_, built.mesh, t)});
  for (const ReferenceCorner& corner : surface_->corners())
    corners_.push_back({corner.vertex, surface_->facets().points[corner.vertex]});
  find_planes();
  find_straight_curves();
}

Reference::Reference(std::shared_ptr<const ReferenceSurface> given, const Mesh& input, const Built& built,
                     const std::vector<Patch>& patches, const std::vector<EdgeUse>& uses)
    : surface_(std::move(given)),
      matches_(match_patches(*surface_, built, patches, uses)),
      ridges_(match_curves(*surface_, input, built, matches_, uses)),
      corners_(match_corners(*surface_, built, matches_, ridges_)) {
  find_planes();
  find_straight_curves();
  const TetMesh& mesh = built.mesh;
  const double tolerance = flatness_tolerance(surface_->facets());
  for (const TriangleId t : mesh.triangle_ids()) {
    const auto is_near = [&](VertexId v) {
      const Plane& plane = *planes_[patch_of(t)];
      return distance(plane, mesh.x(v)) <= tolerance;
    };
    const bool is_in = patch_of(t) == none || (is_planar(t) && std::ranges::all_of(mesh.triangles[t].v, is_near));
    in_plane_.push_back(is_in ? 1 : 0);
  }
  // A line of the mesh that is elsewhere has to be moved there.
  for (const CurveMatch& match : ridges_)
    for (const VertexId v : match.edge)
      if (is_straight(match.curve) && surface_->closest_on(match.curve, mesh.x(v)).distance > tolerance)
        straight_[match.curve] = 0;
}

void Reference::find_planes() {
  const double tolerance = flatness_tolerance(surface_->facets());
  for (const ReferencePatch& patch : surface_->patches()) planes_.push_back(plane_of(*surface_, patch, tolerance));
}

void Reference::find_straight_curves() {
  const double tolerance = flatness_tolerance(surface_->facets());
  for (const ReferenceCurve& curve : surface_->curves()) straight_.push_back(is_straight_curve(curve, tolerance));
}

LineId Reference::curve_of(const std::array<VertexId, 2>& edge) const {
  const auto at = std::ranges::lower_bound(ridges_, edge, {}, &CurveMatch::edge);
  return at != ridges_.end() && at->edge == edge ? at->curve : LineId{none};
}

}  // namespace taut
