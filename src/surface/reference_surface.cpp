#include "surface/reference_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "metric/cholesky.hpp"
#include "surface/apexes.hpp"
#include "surface/closest_on_cubic.hpp"
#include "surface/cone_jets.hpp"
#include "surface/cubic_patches.hpp"
#include "surface/sector_jets.hpp"

namespace taut {
namespace {

/// P H P / |g|, with the projection P to the tangent plane.
Sym3 shape_operator_of(const Derivatives& d) {
  const double slope = norm(d.gradient);
  const Vec3 normal = 1 / slope * d.gradient;
  return 1 / slope * congruent(d.hessian, [&](const Vec3& b) { return b - dot(normal, b) * normal; });
}

std::vector<Vec3> gradients_of(std::span<const Derivatives> jets) {
  std::vector<Vec3> gradients;
  for (const Derivatives& jet : jets) gradients.push_back(jet.gradient);
  return gradients;
}

Vec3 unit_normal(const Vec3& across, const std::array<Vec3, 3>& corner) {
  const Vec3 n = dot(across, across) > 0 ? across : cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double length = norm(n);
  return length > 0 ? 1 / length * n : n;
}

/// Ties go to the first triangle, so that the order of the search does not matter.
void try_triangle(const CubicTriangle& cubic, TriangleId t, const Vec3& x, const std::array<double, 3>& weights,
                  OnPatch& best) {
  const OnCubicTriangle at = closest_on(cubic, x, weights);
  ++best.visited;
  best.iterations = std::max(best.iterations, at.iterations);
  const double distance = std::sqrt(at.squared_distance);
  if (distance > best.distance || (distance == best.distance && t > best.triangle)) return;
  best.point = at.point;
  best.normal = at.across;
  best.weights = at.weights;
  best.triangle = t;
  best.distance = distance;
}

OnPatch nothing_yet() {
  OnPatch best;
  best.distance = std::numeric_limits<double>::infinity();
  return best;
}

}  // namespace

ReferenceSurface::ReferenceSurface(SurfaceInput input, std::optional<double> angle) : facets_(std::move(input.facets)) {
  const double tolerance = flatness_tolerance(facets_);
  const SplitEdges edges = split_at_ridges(facets_, input.refs, input.edges, angle);
  const Sectors sectors = find_sectors(facets_.triangles, edges.smooth);
  const auto is_apex = find_apexes(facets_, sectors, edges.ridges);
  std::vector<Derivatives> jets = sector_jets(facets_, sectors, tolerance);
  set_cone_jets(facets_, sectors, is_apex, jets);
  RidgeCurves ridges = find_ridge_curves(facets_.points, edges.ridges, input.is_corner, angle);
  const RidgesOfTriangles ridges_of = ridges_of_triangles(facets_.triangles, edges.ridges);

  cubics_ = cubic_patches(facets_, {sectors, gradients_of(jets), is_apex, ridges_of, ridges.of_edge});
  for (const Derivatives& jet : jets) shapes_.push_back(shape_operator_of(jet));
  sectors_of_ = sectors.of_triangle;
  patch_of_ = find_patches(facets_.triangles.size(), edges.smooth);
  patches_ = make_patches(facets_, input.refs, cubics_, patch_of_);
  std::vector<std::uint8_t> is_corner = ridges.is_corner;
  for (std::size_t v = 0; v < is_corner.size(); ++v) is_corner[v] |= is_apex[v];
  curves_ = make_curves(facets_, std::move(ridges), ridges_of, patch_of_);
  corners_ = make_corners(facets_, is_corner, curves_, patch_of_);
  set_tags();
}

void ReferenceSurface::set_tags() {
  tags_.resize(facets_.points.size());
  for (const TriangleId t : ids<TriangleId>(facets_.triangles.size()))
    for (const VertexId v : facets_.triangles[t]) tags_[v] = Tag::on_patch(patch_of_[t]);
  for (const LineId l : ids<LineId>(curves_.size()))
    for (const VertexId v : curves_[l].vertices) tags_[v] = Tag::on_line(l);
  for (const CornerId c : ids<CornerId>(corners_.size())) tags_[corners_[c].vertex] = Tag::at_corner(c);
}

void ReferenceSurface::search(PatchId patch, const Vec3& x, TriangleId guess, OnPatch& best) const {
  const ReferencePatch& of = patches_[patch];
  of.tree.search(x, of.place_of(guess), best.distance, [&](Index place, const OnTriangle& flat) {
    const TriangleId t = of.triangles[place];
    try_triangle(cubics_[t], t, x, flat.weights, best);
    return best.distance;
  });
}

OnPatch ReferenceSurface::closest_on(PatchId patch, const Vec3& x, TriangleId guess) const {
  OnPatch best = nothing_yet();
  search(patch, x, guess, best);
  best.normal = unit_normal(best.normal, cubics_[best.triangle].corner);
  return best;
}

OnPatch ReferenceSurface::closest(const Vec3& x) const {
  std::vector<std::pair<double, PatchId>> order;
  for (const PatchId p : ids<PatchId>(patches_.size())) order.emplace_back(patches_[p].tree.distance_bound(x), p);
  std::sort(order.begin(), order.end());
  OnPatch best = nothing_yet();
  for (const auto& [bound, patch] : order) {
    if (bound > best.distance) break;
    search(patch, x, none, best);
  }
  best.normal = unit_normal(best.normal, cubics_[best.triangle].corner);
  return best;
}

OnCurve ReferenceSurface::closest_on(LineId curve, const Vec3& x, Index guess) const {
  const auto& segments = curves_[curve].segments;
  OnCurve best;
  best.distance = std::numeric_limits<double>::infinity();
  const std::optional<Index> known = guess < segments.size() ? std::optional(guess) : std::nullopt;
  curves_[curve].tree.search(x, known, best.distance, [&](Index segment, const OnTriangle& chord) {
    const OnCubicSegment at = taut::closest_on(segments[segment], x, 1 - chord.weights[0]);
    const double distance = std::sqrt(at.squared_distance);
    if (distance < best.distance || (distance == best.distance && segment < best.segment))
      best = {at.point, {}, segment, at.parameter, distance};
    return best.distance;
  });
  const Vec3 along = evaluate(segments[best.segment], best.parameter).first;
  best.tangent = 1 / norm(along) * along;
  return best;
}

double ReferenceSurface::sag(PatchId patch, const std::array<Vec3, 3>& facet, TriangleId guess) const {
  const auto& [a, b, c] = facet;
  double farthest = 0;
  for (const Vec3& x : {(1.0 / 3) * (a + b + c), 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
    const OnPatch at = closest_on(patch, x, guess);
    farthest = std::max(farthest, at.distance);
    guess = at.triangle;
  }
  return farthest;
}

double ReferenceSurface::sag(LineId curve, const std::array<Vec3, 2>& edge, Index guess) const {
  return closest_on(curve, 0.5 * (edge[0] + edge[1]), guess).distance;
}

Sym3 ReferenceSurface::shape_operator(const OnPatch& at) const {
  Sym3 sum{};
  for (std::size_t k = 0; k < 3; ++k) sum = sum + at.weights[k] * shapes_[sectors_of_[at.triangle][k]];
  return sum;
}

}  // namespace taut
