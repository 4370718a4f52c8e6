#include "adapt/passes.hpp"

namespace taut {
namespace {

constexpr double clearly_long = 1.6;  // a longer edge must be split even if that makes short ones
constexpr double loose_filter = 0.35;

constexpr TetId reach = 4;  // how far ahead of a sweep memory is asked for

// Calls visit(t) for the tetrahedra that exist when the pass begins: draining what the pass itself makes gives poor
// meshes, for the swaps and relocations between two passes decide where the next vertices belong.
template <class Visit>
void for_each_tet(const TetMesh& mesh, Visit visit) {
  const auto count = static_cast<TetId>(mesh.tets.size());
  for (TetId t = 0; t < count; ++t)
    if (mesh.tets[t].alive()) visit(t);
}

// Asks for what the shells of a tetrahedron a few places on will read: walking them is waiting for memory otherwise.
void prefetch_around(const TetMesh& mesh, TetId t) {
  if (t >= mesh.tets.size()) return;
  const Tet& tet = mesh.tets[t];
  if (!tet.alive()) return;
  for (int k = 0; k < 4; ++k) {
    __builtin_prefetch(&mesh.vertices[tet.v[k]]);
    if (!tet.n[k].is_triangle()) __builtin_prefetch(&mesh.tets[tet.n[k].tet()]);
  }
}

bool any_untried(const Tet& tet, Trial kind, std::uint32_t entities) {
  const std::uint32_t mask = ((1U << entities) - 1U) << static_cast<std::uint32_t>(kind);
  return (tet.tried & mask) != mask;
}

double edge_length(const Kernel& kernel, TetId t, int edge) {
  const auto& v = kernel.mesh.tets[t].v;
  return kernel.length(v[edge_vertices[edge][0]], v[edge_vertices[edge][1]]);
}

// Measures an edge and remembers whether it is unit: then neither pass need come back to it.
double measure_edge(Kernel& kernel, TetId t, int edge) {
  const double length = edge_length(kernel, t, edge);
  kernel.mesh.tets[t].set_length(edge, is_unit(length));
  return length;
}

}  // namespace

void insertion_pass(Kernel& kernel, const InsertionRules& rules, Tally& tally) {
  for_each_tet(kernel.mesh, [&](TetId t) {
    Tet& tet = kernel.mesh.tets[t];
    if (!any_untried(tet, Trial::insertion, 6)) return;
    tally.scan();
    int longest = -1;
    double length = longest_unit;
    for (int e = 0; e < 6; ++e) {
      if (tet.was_tried(Trial::insertion, e)) continue;
      const double l = measure_edge(kernel, t, e);
      if (l <= length) continue;
      length = l;
      longest = e;
    }
    if (longest < 0) return;
    InsertionRules own = rules;
    if (length > clearly_long) own.shortest_new_edge = loose_filter;
    tally.record(insert_on_edge(kernel, t, longest, own));
  });
}

void collapse_pass(Kernel& kernel, const CollapseRules& rules, Tally& tally) {
  for_each_tet(kernel.mesh, [&](TetId t) {
    if (!any_untried(kernel.mesh.tets[t], Trial::collapse, 6)) return;
    tally.scan();
    for (int e = 0; e < 6; ++e) {
      Tet& tet = kernel.mesh.tets[t];
      if (tet.was_tried(Trial::collapse, e)) continue;
      const double l = edge_length(kernel, t, e);
      if (l >= shortest_unit)
        tet.set_tried(Trial::collapse, e);
      else if (tally.record(collapse_edge(kernel, t, e, rules)))
        return;
    }
  });
}

void swap_pass(Kernel& kernel, const SwapRules& rules, Tally& edges, Tally& faces) {
  for_each_tet(kernel.mesh, [&](TetId t) {
    prefetch_around(kernel.mesh, t + reach);
    const Tet& tet = kernel.mesh.tets[t];
    if (tet.quality > rules.good_enough) return;
    edges.scan();
    for (int e = 0; e < 6; ++e)
      if (!tet.was_tried(Trial::edge_swap, e) && edges.record(swap_edge(kernel, t, e, rules))) return;
    if (tet.quality > rules.poor) return;
    faces.scan();
    for (int f = 0; f < 4; ++f)
      if (!tet.was_tried(Trial::face_swap, f) && faces.record(swap_face(kernel, t, f, rules))) return;
  });
}

void repair_pass(Kernel& kernel, const RepairRules& rules, Tally& tally) {
  for_each_tet(kernel.mesh, [&](TetId t) {
    if (kernel.mesh.tets[t].quality > rules.bad) return;
    tally.scan();
    tally.record(repair(kernel, t, rules));
  });
}

void relocation_pass(Kernel& kernel, const RelocationRules& rules, Tally& tally) {
  const auto count = static_cast<VertexId>(kernel.mesh.vertices.size());
  for (VertexId v = 0; v < count; ++v) {
    if (!kernel.mesh.is_vertex_alive(v) || kernel.mesh.restless[v] == 0) continue;
    tally.scan();
    if (v + reach < count && kernel.mesh.is_vertex_alive(v + reach))
      __builtin_prefetch(&kernel.mesh.tets[kernel.mesh.tet_of_vertex[v + reach]]);
    tally.record(relocate(kernel, v, rules));
  }
}

}  // namespace taut
