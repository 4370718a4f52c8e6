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
  if (!k.block->owns_ball(gone)) return Refusal::put_off;
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
  if (const Refusal refusal = cavity.validate(k.mesh, *k.block, gone); refusal != Refusal::accepted) return refusal;
  cavity.commit(k.mesh, *k.block, kept);
  k.block->remove_vertex(k.mesh, gone);
  return Refusal::accepted;
}

}  // namespace

Refusal collapse_edge(Kernel& kernel, TetId t, int edge, const CollapseRules& rules) {
  Refusal refusal = collect_shell(kernel.mesh, *kernel.block, t, edge, kernel.shell);
  if (refusal != Refusal::accepted) return refusal;
  const VertexId a = kernel.shell.a, b = kernel.shell.b;
  const Refusal first = merge(kernel, a, b, rules);
  if (first == Refusal::accepted) return first;
  refusal = merge(kernel, b, a, rules);
  if (refusal != Refusal::accepted && first == Refusal::put_off) return first;
  return kernel.mark_shell(Trial::collapse, refusal);
}

}  // namespace taut
