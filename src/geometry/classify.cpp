#include "geometry/classify.hpp"

#include <algorithm>
#include <utility>

#include "geometry/features.hpp"
#include "geometry/frozen.hpp"
#include "geometry/lines.hpp"
#include "geometry/patches.hpp"
#include "geometry/tags.hpp"
#include "surface/surface_edges.hpp"

namespace taut {
namespace {

std::vector<std::uint8_t> required_triangles(const Mesh& input, const Built& built) {
  std::vector<std::uint8_t> required(built.mesh.triangles.size(), 0);
  for (Index t : input.required_triangles) required[built.triangle_of_input[t]] = 1;
  return required;
}

std::vector<InnerEdge> inner_edges(const TetMesh& mesh, const std::vector<Feature>& features) {
  std::vector<InnerEdge> edges;
  edges.reserve(features.size());
  for (const Feature& f : features)
    edges.push_back({{mesh.origin_of_vertex[f.edge[0]], mesh.origin_of_vertex[f.edge[1]]}, f.ref, f.sharp, f.required});
  return edges;
}

void freeze_surface(Model& model, TetMesh& mesh) {
  for (Patch& patch : model.patches) patch.shape = Frozen{};
  for (Line& line : model.lines) line.frozen = true;
  model.corners.assign(1, {});
  for (Tag& tag : mesh.tag_of_vertex)
    if (!tag.is_in_volume()) tag = Tag::at_corner(shared_corner);
}

}  // namespace

Model classify(const Mesh& input, Built& built, Surface surface, double ridge_angle) {
  TetMesh& mesh = built.mesh;
  const double tolerance = flatness_tolerance(mesh);
  const auto required = required_triangles(input, built);
  const auto uses = edge_uses(corners_of(mesh.triangles));
  const Features features = find_features(input, built, uses, required, ridge_angle);

  Model model;
  model.regions = find_regions(built, features.inner);
  model.has_frozen_region = std::ranges::any_of(model.regions, &Region::frozen);
  model.inner_edges = inner_edges(mesh, features.inner);
  model.patches = group_patches(mesh, uses, features.surface, built.triangle_refs, required);
  find_shapes(mesh, model.patches, tolerance);

  const auto fixed = find_fixed_vertices(input, built, model, features);
  const FeatureGraph graph(mesh, features.surface, fixed, tolerance);
  Lines lines = find_lines(mesh, graph);
  model.lines = std::move(lines.lines);
  set_tags(mesh, model, graph, lines.line_of_feature);
  if (surface == Surface::fixed) freeze_surface(model, mesh);
  return model;
}

}  // namespace taut
