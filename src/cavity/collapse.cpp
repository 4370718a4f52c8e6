#include "cavity/collapse.hpp"

#include <algorithm>

namespace taut {
namespace {

// Whether the edge of the shell lies on the patch or line of the vertex that is to slide along it.
bool along_geometry(const Kernel& k, VertexId gone) {
  const Tag tag = k.mesh.tag_of_vertex[gone];
  if (tag.dimension == 3) return true;
  if (tag.dimension == 0) return false;
  for (int i = 0; i < k.shell.triangle_count; ++i) {
    const Triangle& triangle = k.mesh.triangles[k.shell.triangles[i]];
    if (tag.dimension == 2 && triangle.patch == tag.id) return true;
    for (int c = 0; c < 3; ++c) {
      const bool opposite = triangle.v[c] != k.shell.a && triangle.v[c] != k.shell.b;
      if (tag.dimension == 1 && opposite && triangle.line[c] == tag.id) return true;
    }
  }
  return false;
}

double longest_edge_at(const Kernel& k, VertexId v) {
  double longest = 0;
  for (TetId t : k.cavity.tets.span())
    for (VertexId u : k.mesh.tets[t].v)
      if (u != v) longest = std::max(longest, k.length(u, v));
  return longest;
}

Refusal merge(Kernel& k, VertexId gone, VertexId kept, const CollapseRules& rules) {
  if (!along_geometry(k, gone)) return Refusal::geometry;
  Cavity& cavity = k.cavity;
  if (!collect_ball(k.mesh, gone, cavity.tets)) return Refusal::too_large;
  if (k.any_frozen(cavity.tets.span())) return Refusal::frozen;
  const Apex apex{kept, k.mesh.vertices[kept], k.mesh.tag_of_vertex[kept]};
  if (const Refusal refusal = cavity.propose(k.mesh, k.model, apex, gone); refusal != Refusal::accepted) return refusal;
  const double bound = std::min(rules.worst_quality, rules.share_of_old * cavity.worst_old_quality(k.mesh));
  if (!(cavity.worst_new_quality() > bound)) return Refusal::quality;
  const auto lengths = cavity.lengths();
  const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
  if (longest > rules.longest_new_edge && longest > longest_edge_at(k, gone)) return Refusal::long_edge;
  if (const Refusal refusal = cavity.validate(k.mesh, gone); refusal != Refusal::accepted) return refusal;
  cavity.commit(k.mesh, kept);
  k.mesh.remove_vertex(gone);
  return Refusal::accepted;
}

}  // namespace

Refusal collapse_edge(Kernel& kernel, TetId t, int edge, const CollapseRules& rules) {
  if (!collect_shell(kernel.mesh, t, edge, kernel.shell)) return Refusal::too_large;
  kernel.mark_shell(Trial::collapse);
  const VertexId a = kernel.shell.a, b = kernel.shell.b;
  if (merge(kernel, a, b, rules) == Refusal::accepted) return Refusal::accepted;
  return merge(kernel, b, a, rules);
}

}  // namespace taut
