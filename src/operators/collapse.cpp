#include "operators/collapse.hpp"

#include <algorithm>

namespace taut {
namespace {

// Whether the edge of the shell lies on the patch or line of the vertex that would slide along it.
bool along_geometry(const Kernel& k, VertexId gone) {
  const Tag tag = k.mesh.tag_of_vertex[gone];
  if (tag.is_in_volume()) return true;
  if (tag.is_at_corner()) return false;
  for (int i = 0; i < k.shell.triangle_count; ++i) {
    const Triangle& triangle = k.mesh.triangles[k.shell.triangles[i]];
    if (tag.is_on_patch() && triangle.patch == tag.patch()) return true;
    for (int c = 0; c < 3; ++c) {
      const bool opposite = triangle.v[c] != k.shell.a && triangle.v[c] != k.shell.b;
      if (tag.is_on_line() && opposite && triangle.line[c] == tag.line()) return true;
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

Outcome merge(Kernel& k, VertexId gone, VertexId kept, const CollapseRules& rules) {
  if (!along_geometry(k, gone)) return Outcome::geometry;
  if (!k.block->owns_ball(gone)) return Outcome::put_off;
  Cavity& cavity = k.cavity;
  if (!collect_ball(k.mesh, gone, cavity.tets)) return Outcome::too_large;
  if (k.any_frozen(cavity.tets.span())) return Outcome::frozen;
  return k.rejoin(k.apex_at(kept), gone, [&] {
    const double bound = std::min(rules.worst_quality, rules.share_of_old * cavity.worst_old_quality(k.mesh));
    if (!cavity.batch.all_above(bound)) return Outcome::quality;
    const auto lengths = cavity.lengths();
    const double longest = lengths.empty() ? 0 : *std::max_element(lengths.begin(), lengths.end());
    const bool too_long = longest > rules.longest_new_edge && longest > longest_edge_at(k, gone);
    return too_long ? Outcome::long_edge : Outcome::accepted;
  });
}

}  // namespace

Outcome collapse_edge(Kernel& kernel, TetId t, int edge, const CollapseRules& rules) {
  const Outcome collected = collect_shell(kernel.mesh, *kernel.block, t, edge, kernel.shell);
  if (collected != Outcome::accepted) return collected;
  const VertexId a = kernel.shell.a, b = kernel.shell.b;
  const Outcome first = merge(kernel, a, b, rules);
  if (first == Outcome::accepted) return first;
  const Outcome second = merge(kernel, b, a, rules);
  if (second != Outcome::accepted && first == Outcome::put_off) return first;
  return kernel.mark_shell(Trial::collapse, second);
}

}  // namespace taut
