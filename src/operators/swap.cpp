#include "operators/swap.hpp"

#include <algorithm>

#include "operators/ring_table.hpp"

namespace taut {
namespace {

constexpr double least_swapped_quality = 1e-6;  // a sliver is never worth creating

// A ring vertex can take over the triangles of the shell only if it lies on their patches. A feature edge is never
// swapped.
bool may_take_triangles(const Kernel& k, VertexId v) {
  for (int i = 0; i < k.shell.triangle_count; ++i)
    if (!k.model.on_patch(k.mesh.tag_of_vertex[v], k.mesh.triangles[k.shell.triangles[i]].patch)) return false;
  return true;
}

bool is_feature_edge(const Kernel& k) {
  for (int i = 0; i < k.shell.triangle_count; ++i) {
    const Triangle& triangle = k.mesh.triangles[k.shell.triangles[i]];
    for (int c = 0; c < 3; ++c)
      if (triangle.v[c] != k.shell.a && triangle.v[c] != k.shell.b && triangle.line[c] != none) return true;
  }
  return false;
}

struct Fan {
  int first = -1;
  double quality = 0;
};

class EdgeSwap {
public:
  EdgeSwap(Kernel& kernel, const SwapRules& rules)
      : k_(kernel), rules_(rules), n_(kernel.shell.ring_size), table_(ring_tables[n_ - RingTable::smallest]) {}

  Outcome run() {
    double old_quality = 1;
    for (TetId t : k_.shell_tets()) old_quality = std::min(old_quality, double{k_.mesh.tets[t].state.quality});
    if (old_quality > rules_.good_enough) return Outcome::no_candidate;
    if (k_.any_frozen(k_.shell_tets()) || is_feature_edge(k_)) return Outcome::frozen;
    evaluate();
    longest_ = std::max(rules_.longest_new_edge, k_.length(k_.shell.a, k_.shell.b));
    const double bound = std::max(old_quality * rules_.gain, least_swapped_quality);
    Outcome outcome = Outcome::no_candidate;
    std::array<Fan, RingTable::largest> fans;
    const int count = better_fans(bound, fans);
    for (int i = 0; i < count && outcome != Outcome::accepted && outcome != Outcome::put_off; ++i)
      outcome = apply(fans[i]);
    return outcome;
  }

private:
  // The quality of every triangle connected to both ends of the edge.
  void evaluate() {
    FaceBatch& batch = k_.batch;
    const Shell& shell = k_.shell;
    batch.clear();
    const auto at = [&](int i) -> const Vertex& { return k_.mesh.vertices[shell.ring[i]]; };
    for (int i = 0; i < table_.triangle_count; ++i) {
      const auto& t = table_.triangles[i];
      batch.push(at(t[0]), at(t[1]), at(t[2]));
    }
    batch.evaluate(k_.mesh.vertices[shell.a]);
    for (int i = 0; i < batch.size(); ++i) quality_[i] = batch.quality[i];
    batch.evaluate(k_.mesh.vertices[shell.b]);  // on the other side, where volumes have the other sign
    for (int i = 0; i < batch.size(); ++i) quality_[i] = std::min(quality_[i], -batch.quality[i]);
  }

  // The fans above the bound, best first; equal ones in the order of the ring.
  int better_fans(double bound, std::array<Fan, RingTable::largest>& fans) const {
    int count = 0;
    const int distinct = n_ == 4 ? 2 : n_ == 3 ? 1 : n_;
    const bool surface = k_.shell.triangle_count > 0;
    for (int p = 0; p < (surface ? n_ : distinct); ++p) {
      double worst = 1;
      for (int i = 0; i < n_ - 2; ++i) worst = std::min(worst, quality_[table_.fans[p][i]]);
      if (!(worst > bound) || (surface && !may_take_triangles(k_, k_.shell.ring[p]))) continue;
      int at = count++;
      for (; at > 0 && fans[at - 1].quality < worst; --at) fans[at] = fans[at - 1];
      fans[at] = {p, worst};
    }
    return count;
  }

  Outcome apply(const Fan& fan) {
    const VertexId p = k_.shell.ring[fan.first];
    for (int i = 2; i + 1 < n_; ++i)  // the edges of the ring already exist, except the one that closes an open ring
      if (k_.length(p, k_.shell.ring[(fan.first + i) % n_]) > longest_) return Outcome::long_edge;
    if (!k_.shell.closed && k_.length(k_.shell.ring[0], k_.shell.ring[n_ - 1]) > longest_) return Outcome::long_edge;
    k_.cavity.tets.assign(k_.shell_tets());
    return k_.rejoin(k_.apex_at(p), none, [] { return Outcome::accepted; });  // judged as a fan
  }

  Kernel& k_;
  const SwapRules& rules_;
  const int n_;
  const RingTable& table_;
  double longest_ = 0;
  std::array<double, 28> quality_;
};

// Whether the segment from p to q passes through the inside of the face: a rough check before anything is collected.
bool sees_through(const TetMesh& mesh, const std::array<VertexId, 3>& face, VertexId p, VertexId q) {
  for (int i = 0; i < 3; ++i)
    if (six_volumes(mesh.x(p), mesh.x(face[i]), mesh.x(face[(i + 1) % 3]), mesh.x(q)) <= 0) return false;
  return true;
}

// Replaces a face by an edge; `link` is behind the face and leads to a tetrahedron of the same block.
Outcome turn_face(Kernel& kernel, TetId t, int face, FaceLink link, const SwapRules& rules) {
  TetMesh& mesh = kernel.mesh;
  const Tet &here = mesh.tets[t], &there = mesh.tets[link.tet()];
  const double old_quality = std::min(here.state.quality, there.state.quality);
  if (old_quality > rules.good_enough) return Outcome::no_candidate;
  const VertexId p = here.v[face], q = there.v[link.face()];
  if (!sees_through(mesh, mesh.face(t, face), p, q)) return Outcome::inverted;
  if (kernel.length(p, q) > rules.longest_new_edge) return Outcome::long_edge;
  const std::array<TetId, 2> both = {t, link.tet()};
  if (kernel.any_frozen(both)) return Outcome::frozen;
  kernel.cavity.tets.assign(both);
  return kernel.rejoin(kernel.apex_at(p), none, [&] {
    const double bound = std::max(old_quality * rules.gain, least_swapped_quality);
    return kernel.cavity.batch.all_above(bound) ? Outcome::accepted : Outcome::quality;
  });
}

}  // namespace

Outcome swap_edge(Kernel& kernel, TetId t, int edge, const SwapRules& rules) {
  const Outcome collected = collect_shell(kernel.mesh, *kernel.block, t, edge, kernel.shell);
  if (collected == Outcome::put_off) return collected;
  const int n = kernel.shell.ring_size;
  const bool fits = collected == Outcome::accepted && n >= RingTable::smallest && n <= RingTable::largest;
  return kernel.mark_shell(Trial::edge_swap, fits ? EdgeSwap(kernel, rules).run() : Outcome::too_large);
}

Outcome swap_face(Kernel& kernel, TetId t, int face, const SwapRules& rules) {
  auto& tets = kernel.mesh.tets;
  const FaceLink link = tets[t].n[face];
  if (!link.is_triangle() && !kernel.block->owns(tets[link.tet()].v[link.face()])) return Outcome::put_off;
  const Outcome outcome = link.is_triangle() ? Outcome::no_candidate : turn_face(kernel, t, face, link, rules);
  if (outcome == Outcome::accepted || outcome == Outcome::put_off) return outcome;
  tets[t].state.tried.set(Trial::face_swap, face);
  if (!link.is_triangle()) tets[link.tet()].state.tried.set(Trial::face_swap, link.face());
  return outcome;
}

}  // namespace taut
