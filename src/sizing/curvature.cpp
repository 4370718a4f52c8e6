#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "geometry/features.hpp"
#include "mesh/build.hpp"
#include "metric/intersection.hpp"
#include "sizing/limits.hpp"
#include "surface/principal_curvatures.hpp"
#include "surface/sector_jets.hpp"
#include "taut/error.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

void require(const CurvatureOptions& o) {
  require_limits(o.limits);
  if (!(o.deviation > 0 && std::isfinite(o.deviation)))
    throw InputError(fmt::format("deviation {} found, expected a number above 0", o.deviation));
  if (!(o.turn > 0 && o.turn <= 90))
    throw InputError(fmt::format("turn {} found, expected degrees above 0, at most 90", o.turn));
  if (!(o.ridge_angle > 0 && o.ridge_angle < 180))
    throw InputError(fmt::format("ridge angle {} found, expected between 0 and 180 degrees", o.ridge_angle));
}

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

/// Sizes along the surface by its curvatures, and the smaller of them across it.
Sym3 metric_of_curvatures(const Spectrum& s, const CurvatureOptions& o) {
  const Vec3 radius = {1 / std::abs(s.values[0]), 1 / std::abs(s.values[1]), 0};
  Vec3 size{};
  for (std::size_t i = 0; i < 2; ++i)
    size[i] = std::min(chord(radius[i], o.deviation, o.turn * std::numbers::pi / 180), o.limits.hmax);
  size[2] = std::min(size[0], size[1]);
  for (std::size_t i = 0; i < 2; ++i) size[i] = std::min(size[i], longest_without_tilt(radius[i], size[2]));
  return assemble({{std::pow(size[0], -2), std::pow(size[1], -2), std::pow(size[2], -2)}, s.vectors});
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

/// The principal curvatures of a surface at some of its points, those of a ridge more than once.
struct SurfaceCurvatures {
  std::vector<VertexId> vertices;
  std::vector<Spectrum> curvatures;
};

SurfaceCurvatures curvatures_of(const Mesh& mesh, const Built& built, double ridge_angle) {
  Facets facets = facets_of(built.mesh);
  const auto edges = orient(facets.triangles, smooth_edges(mesh, built, facets, ridge_angle));
  Sectors sectors = find_sectors(facets.triangles, edges);
  const std::vector<Derivatives> jets = sector_jets(facets, sectors, flatness_tolerance(facets));
  std::vector<Spectrum> curvatures(jets.size());
  for_each_index(jets.size(), [&](std::size_t s) { curvatures[s] = principal_curvatures(jets[s]); });
  return {std::move(sectors.vertices), std::move(curvatures)};
}

}  // namespace

Tensors curvature_metric(const Mesh& mesh, const CurvatureOptions& options) {
  require(options);
  const Built built = build(mesh);
  CurvatureOptions o = options;
  if (o.relative) o.deviation *= within_domain(mesh, {}).hmax;
  o.limits = within_domain(mesh, options.limits);
  const SurfaceCurvatures found = curvatures_of(mesh, built, o.ridge_angle);
  const auto sectors_at = gather<Index>(found.curvatures.size(), mesh.points.size(), [&](std::size_t s, auto put) {
    put(built.mesh.origin_of_vertex[found.vertices[s]], static_cast<Index>(s));
  });
  Tensors metric(mesh.points.size(), metric_of_size(o.limits.hmax));
  for_each_index(metric.size(), [&](std::size_t p) {
    for (const Index s : sectors_at[p]) metric[p] = intersect(metric[p], metric_of_curvatures(found.curvatures[s], o));
  });
  return limited(mesh, std::move(metric), o.limits);
}

}  // namespace taut
