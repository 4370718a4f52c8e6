#include "sizing/surface_curvatures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "geometry/features.hpp"
#include "mesh/build.hpp"
#include "metric/intersection.hpp"
#include "surface/principal_curvatures.hpp"
#include "surface/sector_jets.hpp"

namespace taut {
namespace {

/// The chord of a circle of the radius that is `deviation` from it, unless it turns by more than `turn` (radians).
double chord(double radius, double deviation, double turn) {
  const double longest = 2 * radius * std::sin(turn / 2);
  return deviation < radius ? std::min(2 * std::sqrt(deviation * (2 * radius - deviation)), longest) : longest;
}

/// The longest edge that is at most 0.18 `across` from a circle of the radius. Triangles tilt by about the ratio of the
/// two.
double longest_without_tilt(double radius, double across) {
  return std::sqrt(8 * 0.18 * across * radius);
}

/// The edges that part nothing: given ones too, unless they are sharp.
std::vector<EdgePair> smooth_edges(const Mesh& mesh, const Built& built, const Facets& facets, double ridge_angle) {
  const auto uses = edge_uses(facets.triangles);
  const std::vector<std::uint8_t> none_required(facets.triangles.size(), 0);
  std::vector<Feature> features = find_features(mesh, built, uses, none_required, {.angle = ridge_angle}).surface;
  std::erase_if(features, [](const Feature& f) { return !f.sharp; });
  std::vector<EdgePair> edges;
  for_each_smooth_edge(uses, features, [&](const EdgeUse& s, const EdgeUse& t) { edges.push_back({s, t}); });
  return edges;
}

/// The reference of the triangles of each sector, all of which have the same.
std::vector<int> refs_of(const Sectors& sectors, std::span<const int> triangle_refs) {
  std::vector<int> refs(sectors.vertices.size());
  for (std::size_t t = 0; t < triangle_refs.size(); ++t)
    for (const std::uint32_t sector : sectors.of_triangle[t]) refs[sector] = triangle_refs[t];
  return refs;
}

}  // namespace

SurfaceCurvatures surface_curvatures(const Mesh& mesh, double ridge_angle) {
  const Built built = build(mesh);
  Facets facets = facets_of(built.mesh);
  const auto edges = orient(facets.triangles, smooth_edges(mesh, built, facets, ridge_angle));
  const Sectors sectors = find_sectors(facets.triangles, edges);
  const std::vector<Derivatives> jets = sector_jets(facets, sectors, flatness_tolerance(facets));
  SurfaceCurvatures found{std::vector<Index>(jets.size()), refs_of(sectors, built.triangle_refs),
                          std::vector<Spectrum>(jets.size())};
  for_each_index(jets.size(), [&](std::size_t s) {
    found.points[s] = built.mesh.origin_of_vertex[sectors.vertices[s]];
    found.curvatures[s] = principal_curvatures(jets[s]);
  });
  return found;
}

SurfaceCurvatures surface_curvatures(const TetMesh& mesh, const Model& model) {
  SurfaceCurvatures found;
  if (!model.surface.exists()) return found;
  std::vector<std::pair<VertexId, PatchId>> places;
  for (const VertexId v : mesh.vertex_ids())
    if (mesh.is_vertex_alive(v))
      model.for_each_patch_at(mesh.tag_of_vertex[v], [&](PatchId p) {
        if (model.patches[p].curved() != nullptr) places.emplace_back(v, p);
      });
  found = {std::vector<Index>(places.size()), std::vector<int>(places.size()), std::vector<Spectrum>(places.size())};
  for_each_index(places.size(), [&](std::size_t i) {
    const auto& [v, p] = places[i];
    const Curved& patch = *model.patches[p].curved();
    const OnPatch at = model.surface.closest_on(patch, mesh.x(v));
    found.points[i] = mesh.origin_of_vertex[v];
    found.refs[i] = model.patches[p].ref;
    found.curvatures[i] = principal_curvatures({at.normal, model.surface.shape_operator(patch, at)});
  });
  return found;
}

Tensors with_curvatures(Tensors metric, const SurfaceCurvatures& found, const CurvatureOptions& options) {
  const auto at_point = gather<Index>(found.points.size(), metric.size(),
                                      [&](std::size_t i, auto put) { put(found.points[i], static_cast<Index>(i)); });
  for_each_index(metric.size(), [&](std::size_t p) {
    for (const Index i : at_point[p])
      metric[p] = intersect(metric[p], metric_of_curvatures(found.curvatures[i], options));
  });
  return metric;
}

Sym3 metric_of_curvatures(const Spectrum& s, const CurvatureOptions& o) {
  const Vec3 radius = {1 / std::abs(s.values[0]), 1 / std::abs(s.values[1]), 0};
  Vec3 size{};
  for (std::size_t i = 0; i < 2; ++i)
    size[i] = std::min(chord(radius[i], o.deviation, o.turn * std::numbers::pi / 180), o.limits.hmax);
  size[2] = std::min(size[0], size[1]);
  for (std::size_t i = 0; i < 2; ++i) size[i] = std::min(size[i], longest_without_tilt(radius[i], size[2]));
  return assemble({{std::pow(size[0], -2), std::pow(size[1], -2), std::pow(size[2], -2)}, s.vectors});
}

}  // namespace taut
