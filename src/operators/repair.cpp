#include "operators/repair.hpp"

#include "operators/collapse.hpp"
#include "operators/lift.hpp"
#include "operators/swap.hpp"

namespace taut {

Outcome repair(Kernel& kernel, TetId t, const RepairRules& rules) {
  const CollapseRules collapse{
      .longest_new_edge = rules.longest_new_edge, .worst_quality = 1, .share_of_old = rules.gain};
  bool put_off = false;
  Outcome outcome = Outcome::no_candidate;
  for (VertexId v : kernel.mesh.tets[t].v) {
    outcome = lift(kernel, v, rules.gain);
    if (outcome == Outcome::accepted) return outcome;
    put_off |= outcome == Outcome::put_off;
  }
  for (int e = 0; rules.may_collapse && e < 6; ++e) {
    outcome = collapse_edge(kernel, t, e, collapse);
    if (outcome == Outcome::accepted) return outcome;
    put_off |= outcome == Outcome::put_off;
  }
  const SwapRules swap{.gain = rules.gain, .longest_new_edge = rules.longest_new_edge};
  for (int e = 0; e < 6; ++e) {
    outcome = swap_edge(kernel, t, e, swap);
    if (outcome == Outcome::accepted) return outcome;
    put_off |= outcome == Outcome::put_off;
  }
  if (put_off) return Outcome::put_off;
  kernel.mesh.tets[t].state.tried.set(Trial::repair, 0);
  return outcome;
}

}  // namespace taut
