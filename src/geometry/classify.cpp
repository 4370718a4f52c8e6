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
void fix_corners_of(const Reference& reference, std::vector<std::uint8_t>& fixed) {
  for (const CornerMatch& corner : reference.corners()) fixed[corner.vertex] = 1;
}

// Patches that are neither planar nor required become parts of those of the reference; so do planar ones that are not
// in the reference's plane.
void bend_patches(const Reference& reference, const TetMesh& mesh, Model& model) {
  model.surface = PlacedSurface(reference.surface());
  std::vector<std::uint8_t> bends(model.patches.size(), 0);
  std::vector<double> sense(model.patches.size(), 0);  // that of most triangles
  for (const TriangleId t : mesh.triangle_ids()) {
    const PatchId p = mesh.triangles[t].patch;
    sense[p] += reference.sense_of(t);
    if (model.patches[p].frozen() || !reference.is_in_plane(t)) bends[p] = 1;
  }
  for (const TriangleId t : mesh.triangle_ids()) {
    const Triangle& triangle = mesh.triangles[t];
    Patch& patch = model.patches[triangle.patch];
    if (patch.required || bends[triangle.patch] == 0 || reference.patch_of(t) == none) continue;
    patch.shape = Curved{.patch = reference.patch_of(t),
                         .sign = sense[triangle.patch] < 0 ? -1.0 : 1.0,
                         .two_sided = triangle.side[1] != outside};
  }
}

// Vertices that the input lets move go to the corners of a given reference.
void place_corners(const Reference& reference, const TetMesh& mesh, const std::vector<std::uint8_t>& stays,
                   Model& model) {
  for (const auto& [vertex, place] : reference.corners())
    if (const Tag tag = mesh.tag_of_vertex[vertex]; stays[vertex] == 0 && tag.corner() != shared_corner)
      model.corners[tag.corner()].place = place;
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

Model classify(const Mesh& input, Built& built, Surface surface, std::optional<double> ridge_angle,
               const std::shared_ptr<const ReferenceSurface>& given) {
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
  model.surface_is_given = given != nullptr && surface == Surface::adapt;
  if (model.surface_is_given || (surface == Surface::adapt && any_bent(model.patches))) {
    if (model.surface_is_given)
      reference.emplace(given, input, built, model.patches, uses);
    else
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
  const std::vector<std::uint8_t> stays = fixed;
  if (reference) fix_corners_of(*reference, fixed);
  const FeatureGraph graph(mesh, features.surface, fixed, tolerance, reference ? &*reference : nullptr);
  Lines lines = find_lines(mesh, graph);
  model.lines = std::move(lines.lines);
  set_tags(mesh, model, graph, lines.line_of_feature);
  if (model.surface_is_given) place_corners(*reference, mesh, stays, model);
  if (surface == Surface::fixed) freeze_surface(model, mesh);
  return model;
}

}  // namespace taut
