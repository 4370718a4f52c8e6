#include "cavity/repair.hpp"

#include "cavity/collapse.hpp"
#include "cavity/relocation.hpp"

namespace taut {

Refusal repair(Kernel& kernel, TetId t, const RepairRules& rules) {
  const CollapseRules collapse{
      .longest_new_edge = rules.longest_new_edge, .worst_quality = 1, .share_of_old = rules.gain};
  bool put_off = false;
  Refusal refusal = Refusal::no_candidate;
  for (VertexId v : kernel.mesh.tets[t].v) {
    refusal = lift(kernel, v, rules.gain);
    if (refusal == Refusal::accepted) return refusal;
    put_off |= refusal == Refusal::put_off;
  }
  for (int e = 0; e < 6; ++e) {
    refusal = collapse_edge(kernel, t, e, collapse);
    if (refusal == Refusal::accepted) return refusal;
    put_off |= refusal == Refusal::put_off;
  }
  return put_off ? Refusal::put_off : refusal;
}

}  // namespace taut
