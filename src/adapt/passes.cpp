#include "adapt/passes.hpp"

#include <algorithm>

namespace taut {
namespace {

constexpr double clearly_long = 1.6;  // longer edges must be split even if that creates short ones
constexpr double loose_filter = 0.35;
constexpr double far_too_long = 3;  // a longer edge may never fit into a block once its surroundings are fine

constexpr std::size_t few_ids = 64;  // in addition to the estimate

constexpr std::size_t reach = 4;  // how many entities ahead memory is prefetched

// Prefetches what the shells of a tetrahedron will read. Otherwise, walking through them means waiting for memory.
void prefetch_around(const TetMesh& mesh, const Tet& tet) {
  for (int k = 0; k < 4; ++k) {
    __builtin_prefetch(&mesh.vertices[tet.v[k]]);
    if (!tet.n[k].is_triangle()) __builtin_prefetch(&mesh.tets[tet.n[k].tet()]);
  }
}

// Calls visit(t) for the block's tetrahedra that exist when the pass begins, if `is_due` holds when their turn comes.
// Also visiting the tetrahedra that the pass itself creates gives poor meshes, because the swaps and relocations
// between two passes decide where the next vertices belong. Tetrahedra that the block shares with others are put off.
template <class IsDue, class Visit>
void for_each_due_tet(Kernel& kernel, Tally& tally, IsDue is_due, Visit visit) {
  const std::vector<Tet>& tets = kernel.mesh.tets;
  const IdPool<TetId>& ids = kernel.block->tets;
  const std::size_t count = ids.size();
  const auto due = [&](std::size_t i) { return i < count && tets[ids[i]].alive() && is_due(tets[ids[i]]); };
  for (std::size_t i = 0; i < count; ++i) {
    if (due(i + reach)) prefetch_around(kernel.mesh, tets[ids[i + reach]]);
    if (!due(i)) continue;
    const TetId t = ids[i];
    tally.scan();
    visit(t);
  }
  for (TetId t : kernel.block->shared_tets)
    if (is_due(tets[t])) tally.record(Outcome::put_off);
}

double edge_length(const Kernel& kernel, TetId t, int edge) {
  const auto& v = kernel.mesh.tets[t].v;
  return kernel.length(v[edge_vertices[edge][0]], v[edge_vertices[edge][1]]);
}

// Measures the edges that may have to be split, and records which must be, so that no pass has to measure the others
// again. Returns the longest of them.
struct LongEdge {
  int edge = -1;
  double length = longest_unit;
};

LongEdge longest_edge(Kernel& kernel, TetId t) {
  Tet& tet = kernel.mesh.tets[t];
  LongEdge longest;
  for (int e = 0; e < 6; ++e) {
    if (tet.state.tried.has(Trial::insertion, e)) continue;
    const double length = edge_length(kernel, t, e);
    note_length(tet, e, length);
    if (length > longest.length) longest = {e, length};
  }
  return longest;
}

// The ids needed to split the longest edges of some tetrahedra. A tetrahedron with an edge that is far too long gains
// little from splits around it; the others share their edges.
class Splits {
public:
  void add(const Kernel& kernel, TetId t, const LongEdge& longest) {
    if (longest.edge < 0) return;
    const double splits = longest.length > far_too_long ? 1 : 0.3;
    inner_ += splits;
    if (std::ranges::any_of(kernel.mesh.tets[t].n, &FaceLink::is_triangle)) outer_ += splits;
  }
  [[nodiscard]] IdNeed need() const {
    const auto count = [](double x) { return static_cast<std::size_t>(x); };
    return {count(inner_), count(7 * inner_), count(3 * outer_)};
  }

private:
  double inner_ = 0, outer_ = 0;
};

Outcome split(Kernel& kernel, TetId t, const LongEdge& longest, InsertionRules rules) {
  if (longest.length > clearly_long) rules.shortest_new_edge = loose_filter;
  return insert_on_edge(kernel, t, longest.edge, rules);
}

}  // namespace

IdNeed ids_for_swaps(const Kernel& kernel) {
  return {few_ids, few_ids + kernel.block->tets.size() / 16, few_ids};
}

IdNeed ids_for_insertion(Kernel& kernel) {
  const Block& block = *kernel.block;
  const auto is_due = [&](TetId t) { return !kernel.mesh.tets[t].state.tried.all(Trial::insertion); };
  Splits splits;
  for (std::size_t i = 0; i < block.tets.size(); ++i)
    if (is_due(block.tets[i])) splits.add(kernel, block.tets[i], longest_edge(kernel, block.tets[i]));
  for (TetId t : block.shared_tets)  // measured here, where nothing else writes to them; they need no ids
    if (is_due(t)) (void)longest_edge(kernel, t);
  IdNeed need = ids_for_swaps(kernel);
  need += splits.need();
  return need;
}

void insertion_pass(Kernel& kernel, const InsertionRules& rules, std::vector<TetId>& stuck, Tally& tally) {
  const auto is_due = [&](const Tet& tet) { return !tet.state.tried.all(Trial::insertion); };
  for_each_due_tet(kernel, tally, is_due, [&](TetId t) {
    const LongEdge longest = longest_edge(kernel, t);
    if (longest.edge < 0) return;
    const Outcome outcome = split(kernel, t, longest, rules);
    tally.record(outcome);
    if (outcome == Outcome::put_off && longest.length > far_too_long) stuck.push_back(t);
  });
  for (TetId t : kernel.block->shared_tets)
    if (longest_edge(kernel, t).length > far_too_long) stuck.push_back(t);
}

void split_stuck(Kernel& kernel, const InsertionRules& rules, std::span<const TetId> stuck, Tally& tally) {
  Splits splits;
  for (TetId t : stuck)
    if (kernel.mesh.tets[t].alive()) splits.add(kernel, t, longest_edge(kernel, t));
  IdNeed need{few_ids, few_ids, few_ids};
  need += splits.need();
  kernel.block->borrow(kernel.mesh, need);
  for (TetId t : stuck) {
    if (!kernel.mesh.tets[t].alive()) continue;
    tally.scan();
    const LongEdge longest = longest_edge(kernel, t);
    if (longest.length > far_too_long) tally.record(split(kernel, t, longest, rules));
  }
  kernel.block->give_back(kernel.mesh);
}

void collapse_pass(Kernel& kernel, const CollapseRules& rules, Tally& tally) {
  const auto is_due = [](const Tet& tet) { return !tet.state.tried.all(Trial::collapse); };
  for_each_due_tet(kernel, tally, is_due, [&](TetId t) {
    for (int e = 0; e < 6; ++e) {
      Tet& tet = kernel.mesh.tets[t];
      if (tet.state.tried.has(Trial::collapse, e)) continue;
      const double length = edge_length(kernel, t, e);
      if (length >= shortest_unit)
        tet.state.tried.set(Trial::collapse, e);
      else if (tally.record(collapse_edge(kernel, t, e, rules)))
        return;
    }
  });
}

void swap_pass(Kernel& kernel, const SwapRules& rules, Tally& tally) {
  const auto is_due = [&](const Tet& tet) { return tet.state.quality <= rules.good_enough; };
  for_each_due_tet(kernel, tally, is_due, [&](TetId t) {
    const Tet& tet = kernel.mesh.tets[t];
    for (int e = 0; e < 6; ++e)
      if (!tet.state.tried.has(Trial::edge_swap, e) && tally.record(swap_edge(kernel, t, e, rules))) return;
    if (tet.state.quality > rules.poor) return;
    for (int f = 0; f < 4; ++f)
      if (!tet.state.tried.has(Trial::face_swap, f) && tally.record(swap_face(kernel, t, f, rules))) return;
  });
}

void repair_pass(Kernel& kernel, const RepairRules& rules, Tally& tally) {
  const auto is_due = [&](const Tet& tet) {
    return tet.state.quality <= rules.bad && !tet.state.tried.all(Trial::repair);
  };
  for_each_due_tet(kernel, tally, is_due, [&](TetId t) { tally.record(repair(kernel, t, rules)); });
}

void mend(Kernel& kernel, const RepairRules& rules, Tally& tally) {
  kernel.block->borrow(kernel.mesh, {few_ids, few_ids, few_ids});
  const auto& tets = kernel.mesh.tets;
  for (const TetId t : kernel.mesh.tet_ids()) {
    if (!tets[t].alive() || tets[t].state.quality > rules.bad) continue;
    tally.scan();
    tally.record(repair(kernel, t, rules));
  }
  kernel.block->give_back(kernel.mesh);
}

void relocation_pass(Kernel& kernel, const RelocationRules& rules, Tally& tally) {
  const TetMesh& mesh = kernel.mesh;
  const IdPool<VertexId>& ids = kernel.block->vertices;
  const std::size_t count = ids.size();
  for (std::size_t i = 0; i < count; ++i) {
    const VertexId v = ids[i];
    if (!mesh.is_vertex_alive(v) || !mesh.state_of_vertex[v].restless) continue;
    tally.scan();
    if (i + reach < count && mesh.is_vertex_alive(ids[i + reach]))
      __builtin_prefetch(&mesh.tets[mesh.tet_of_vertex[ids[i + reach]]]);
    tally.record(relocate(kernel, v, rules));
  }
}

}  // namespace taut
