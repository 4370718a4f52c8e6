#include "geometry/classify.hpp"

#include <algorithm>
#include <utility>

#include "geometry/features.hpp"
#include "geometry/frozen.hpp"
#include "geometry/lines.hpp"
#include "geometry/patches.hpp"
#include "geometry/reference.hpp"
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

// What a reference surface knows to be the tip of something has no normal.
void fix_corners_of(const ReferenceSurface& surface, std::vector<std::uint8_t>& fixed) {
  for (const ReferenceCorner& corner : surface.corners()) fixed[corner.vertex] = 1;
}

// Patches that are neither planar nor required become parts of those of the reference.
void bend_patches(const Reference& reference, const TetMesh& mesh, Model& model) {
  model.surface = reference.surface();
  for (const TriangleId t : mesh.triangle_ids()) {
    const Triangle& triangle = mesh.triangles[t];
    Patch& patch = model.patches[triangle.patch];
    if (patch.required || !patch.frozen()) continue;
    patch.shape = Curved{reference.surface()->patch_of(t), reference.has_sense_of(mesh, t) ? 1.0 : -1.0,
                         triangle.side[1] != outside};
  }
}

bool any_bent(const std::vector<Patch>& patches) {
  return std::ranges::any_of(patches, [](const Patch& patch) { return patch.frozen() && !patch.required; });
}

void freeze_surface(Model& model, TetMesh& mesh) {
  for (Patch& patch : model.patches) patch.shape = Frozen{};
  for (Line& line : model.lines) line.frozen = true;
  model.corners.assign(1, {});
  for (Tag& tag : mesh.tag_of_vertex)
    if (!tag.is_in_volume()) tag = Tag::at_corner(shared_corner);
}

}  // namespace

Model classify(const Mesh& input, Built& built, Surface surface, std::optional<double> ridge_angle) {
  TetMesh& mesh = built.mesh;
  const double tolerance = flatness_tolerance(mesh);
  const auto required = required_triangles(input, built);
  const auto uses = edge_uses(corners_of(mesh.triangles));

  Model model;
  std::optional<Reference> reference;
  RidgeTest ridges;
  if (ridge_angle) ridges.angle = *ridge_angle;
  Features features = find_features(input, built, uses, required, ridges);
  const auto part = [&] {
    model.patches = group_patches(mesh, uses, features.surface, built.triangle_refs, required);
    find_shapes(mesh, model.patches, tolerance);
  };
  part();
  if (surface == Surface::adapt && any_bent(model.patches)) {
    reference.emplace(input, built, ridge_angle);
    ridges.reference = &*reference;
    features = find_features(input, built, uses, required, ridges);
    part();
    bend_patches(*reference, mesh, model);
  }
  model.regions = find_regions(built, features.inner);
  model.has_frozen_region = std::ranges::any_of(model.regions, &Region::frozen);
  model.inner_edges = inner_edges(mesh, features.inner);

  auto fixed = find_fixed_vertices(input, built, model, features);
  if (reference) fix_corners_of(*reference->surface(), fixed);
  const FeatureGraph graph(mesh, features.surface, fixed, tolerance, reference ? &*reference : nullptr);
  Lines lines = find_lines(mesh, graph);
  model.lines = std::move(lines.lines);
  set_tags(mesh, model, graph, lines.line_of_feature);
  if (surface == Surface::fixed) freeze_surface(model, mesh);
  return model;
}

}  // namespace taut
