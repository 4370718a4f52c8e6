#include "geometry/reference.hpp"

#include <algorithm>
#include <cmath>

#include "surface/surface_input.hpp"

namespace taut {
namespace {

bool is_planar_patch(const ReferenceSurface& surface, const ReferencePatch& patch, double tolerance) {
  Vec3 normal{};
  for (const TriangleId t : patch.triangles)
    if (const Vec3 n = area_normal(surface.facets(), t); norm(n) > norm(normal)) normal = n;
  normal = (1 / norm(normal)) * normal;
  const double offset = dot(normal, surface.facets().points[surface.facets().triangles[patch.triangles[0]][0]]);
  return std::ranges::all_of(patch.triangles, [&](TriangleId t) {
    return std::ranges::all_of(surface.facets().triangles[t], [&](VertexId v) {
      return std::abs(dot(normal, surface.facets().points[v]) - offset) <= tolerance;
    });
  });
}

bool is_straight_curve(const ReferenceCurve& curve, double tolerance) {
  const Vec3 begin = curve.segments.front()[0], along = curve.segments.back()[3] - begin;
  const double length = norm(along);
  return length > tolerance && std::ranges::all_of(curve.segments, [&](const CubicSegment& segment) {
           return std::ranges::all_of(
               segment, [&](const Vec3& x) { return norm(cross(x - begin, along)) <= tolerance * length; });
         });
}

}  // namespace

Reference::Reference(const Mesh& input, const Built& built, std::optional<double> angle)
    : surface_(std::make_shared<const ReferenceSurface>(
          with_marks({facets_of(built.mesh), built.triangle_refs, {}, {}}, input, built.vertex_of_point), angle)) {
  const double tolerance = flatness_tolerance(surface_->facets());
  for (const ReferencePatch& patch : surface_->patches())
    planar_.push_back(is_planar_patch(*surface_, patch, tolerance));
  for (const LineId l : ids<LineId>(surface_->curves().size())) {
    const ReferenceCurve& curve = surface_->curves()[l];
    straight_.push_back(is_straight_curve(curve, tolerance));
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) {
      const auto [a, b] = std::minmax(curve.vertices[i], curve.vertices[i + 1]);
      ridges_.push_back({{a, b}, l});
    }
  }
  std::ranges::sort(ridges_);
}

LineId Reference::curve_of(const std::array<VertexId, 2>& edge) const {
  const auto at = std::ranges::lower_bound(ridges_, edge, {}, [](const auto& ridge) { return ridge.first; });
  return at != ridges_.end() && at->first == edge ? at->second : LineId{none};
}

bool Reference::has_sense_of(const TetMesh& mesh, TriangleId t) const {
  const Corners &ours = mesh.triangles[t].v, &theirs = surface_->facets().triangles[t];
  const auto first = std::ranges::find(theirs, ours[0]) - theirs.begin();
  return theirs[static_cast<std::size_t>(first + 1) % 3] == ours[1];
}

}  // namespace taut
