#include "operators/repair.hpp"

#include <cmath>

#include "operators/collapse.hpp"
#include "operators/insertion.hpp"
#include "operators/lift.hpp"
#include "operators/swap.hpp"

namespace taut {
namespace {

// Splits an edge that no triangle contains, at a place away from the opposite edge: where all vertices of a sliver are
// on the surface, nothing else gives it a vertex that can move.
Outcome split_away(Kernel& kernel, TetId t, int edge, const RepairRules& rules) {
  const TetMesh& mesh = kernel.mesh;
  const auto middle = [&](int e) {
    const auto& [i, j] = edge_vertices[e];
    return 0.5 * (mesh.x(mesh.tets[t].v[i]) + mesh.x(mesh.tets[t].v[j]));
  };
  const Vec3 here = middle(edge), away = here - middle(5 - edge);
  const double length = std::sqrt(quadratic_form(mesh.vertices[mesh.tets[t].v[edge_vertices[edge][0]]].m, away));
  const InsertionRules insertion{
      .shortest_new_edge = rules.shortest_new_edge, .worst_quality = 1, .share_of_old = rules.gain};
  Outcome outcome = Outcome::no_candidate;
  for (const double share : {0.5, 0.25, 0.12}) {  // of a unit length
    outcome = insert_on_edge(kernel, t, edge, here + (share / length) * away, insertion);
    if (outcome == Outcome::accepted || outcome == Outcome::put_off) return outcome;
  }
  return outcome;
}

}  // namespace

Outcome repair(Kernel& kernel, TetId t, const RepairRules& rules) {
  const CollapseRules collapse{
      .longest_new_edge = rules.longest_new_edge, .worst_quality = 1, .share_of_old = rules.gain};
  const SwapRules swap{.gain = rules.gain, .longest_new_edge = rules.longest_new_edge};
  bool put_off = false;
  Outcome outcome = Outcome::no_candidate;
  const auto succeeds = [&](Outcome found) {
    outcome = found;
    put_off |= found == Outcome::put_off;
    return found == Outcome::accepted;
  };
  for (VertexId v : kernel.mesh.tets[t].v)
    if (succeeds(lift(kernel, v, rules.gain))) return outcome;
  for (int e = 0; rules.may_collapse && e < 6; ++e)
    if (succeeds(collapse_edge(kernel, t, e, collapse))) return outcome;
  for (int e = 0; e < 6; ++e)
    if (succeeds(swap_edge(kernel, t, e, swap))) return outcome;
  for (int e = 0; rules.may_insert && e < 6; ++e)
    if (succeeds(split_away(kernel, t, e, rules))) return outcome;
  if (put_off) return Outcome::put_off;
  kernel.mesh.tets[t].state.tried.set(Trial::repair, 0);
  return outcome;
}

}  // namespace taut
