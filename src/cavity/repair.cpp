#include "cavity/repair.hpp"

#include "cavity/collapse.hpp"
#include "cavity/relocation.hpp"

namespace taut {

Refusal repair(Kernel& kernel, TetId t, const RepairRules& rules) {
  const CollapseRules collapse{
      .longest_new_edge = rules.longest_new_edge, .worst_quality = 1, .share_of_old = rules.gain};
  Refusal refusal = Refusal::no_candidate;
  for (VertexId v : kernel.mesh.tets[t].v) {
    refusal = lift(kernel, v, rules.gain);
    if (refusal == Refusal::accepted) return refusal;
  }
  for (int e = 0; e < 6; ++e) {
    refusal = collapse_edge(kernel, t, e, collapse);
    if (refusal == Refusal::accepted) return refusal;
  }
  return refusal;
}

}  // namespace taut
