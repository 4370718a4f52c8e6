#include "geometry/tags.hpp"

namespace taut {
namespace {

Corner corner_at(VertexId v, Tag tag, const FeatureGraph& graph, std::span<const LineId> line_of_feature) {
  Corner corner;
  if (tag.is_on_patch()) corner.patches.push_back(tag.patch());
  for (const auto f : graph.at(v)) {
    corner.lines.push_back(line_of_feature[f]);
    for (PatchId p : graph.patches_of(f)) corner.patches.push_back(p);
  }
  return corner;
}

}  // namespace

void set_tags(TetMesh& mesh, Model& model, const FeatureGraph& graph, std::span<const LineId> line_of_feature) {
  auto& tags = mesh.tag_of_vertex;
  for (Tag& tag : tags) tag = {};
  for (const Triangle& t : mesh.triangles)
    for (VertexId v : t.v) tags[v] = Tag::on_patch(t.patch);
  for (std::size_t f = 0; f < graph.features().size(); ++f)
    for (const EdgeUse& use : graph.features()[f].uses)
      mesh.triangles[use.triangle].line[use.corner] = line_of_feature[f];
  for (const VertexId v : mesh.vertex_ids()) {
    if (!graph.is_fixed(v) && graph.at(v).empty()) continue;
    tags[v] = graph.is_on_line(v) ? Tag::on_line(line_of_feature[graph.at(v)[0]])
                                  : Tag::at_corner(model.add_corner(corner_at(v, tags[v], graph, line_of_feature)));
  }
}

}  // namespace taut
