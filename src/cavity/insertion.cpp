#include "cavity/insertion.hpp"

#include <algorithm>

#include "cavity/delaunay.hpp"

namespace taut {
namespace {

constexpr int most_repairs = 12;     // rounds of dropping tetrahedra whose faces do not see the new vertex
constexpr int largest_cavity = 100;  // the criterion of eq. (4) rarely asks for 40

// The line or patch that the edge of the shell lies on. False if it may not be split.
bool locate(const Kernel& k, Tag& tag) {
  const Shell& shell = k.shell;
  for (int i = 0; i < shell.triangle_count; ++i) {
    const Triangle& triangle = k.mesh.triangles[shell.triangles[i]];
    if (k.model.patches[triangle.patch].frozen) return false;
    int corner = 0;
    while (triangle.v[corner] == shell.a || triangle.v[corner] == shell.b) ++corner;
    const LineId line = triangle.line[corner];
    if (line != none && k.model.lines[line].frozen) return false;
    tag = line != none ? Tag{1, line} : Tag{2, triangle.patch};
  }
  return true;
}

class Insertion {
public:
  Insertion(Kernel& kernel, const InsertionRules& rules) : k_(kernel), mesh_(kernel.mesh), rules_(rules) {}

  Refusal run() {
    if (k_.any_frozen(k_.shell_tets()) || !locate(k_, apex_.tag)) return Refusal::frozen;
    if (k_.block->vertices.available() == 0) return Refusal::put_off;
    place();
    for (int i = 0; i < k_.shell.ring_size; ++i)
      if (too_short(k_.shell.ring[i])) return Refusal::short_edge;
    collect_core();
    if (!grow()) return Refusal::put_off;
    Refusal refusal = rejoin();
    const bool is_final = refusal == Refusal::accepted || refusal == Refusal::short_edge || refusal == Refusal::put_off;
    if (!is_final && k_.cavity.tets.size() > core_) {
      collect_core();
      refusal = rejoin();
    }
    return refusal;
  }

private:
  void place() {
    const VertexId a = k_.shell.a, b = k_.shell.b;
    apex_.id = k_.block->vertices.next();
    apex_.vertex.x = k_.model.project(apex_.tag, 0.5 * (mesh_.x(a) + mesh_.x(b)));
    host_ = mesh_.host_of_vertex[a];
    apex_.vertex.m = k_.target.at(apex_.vertex.x, host_);
  }

  [[nodiscard]] bool too_short(VertexId v) const {
    const Vertex& q = mesh_.vertices[v];
    return edge_length_fast(apex_.vertex.x, q.x, apex_.vertex.m, q.m) < rules_.shortest_new_edge;
  }

  void collect_core() {
    k_.cavity.tets.clear();
    for (TetId t : k_.shell_tets()) (void)k_.cavity.tets.add(t);
    core_ = k_.cavity.tets.size();
  }

  // False if a tetrahedron that is not the block's is in conflict too. Its vertices stay where they are.
  bool grow() {
    TetSet& tets = k_.cavity.tets;
    k_.spared.clear();
    int spared = 0;
    for (int i = 0; i < tets.size(); ++i) {
      for (const FaceLink link : mesh_.tets[tets[i]].n) {
        if (link.is_triangle()) continue;  // a constrained face is never crossed
        const TetId t = link.tet();
        if (tets.contains(t) || k_.spared.contains(t)) continue;
        if (tets.size() >= largest_cavity || spared >= largest_cavity) return true;
        if (k_.any_frozen({&t, 1}) || !conflicts(t)) {
          k_.spared.find_or_insert(t, spared++);
          continue;
        }
        if (!k_.block->owns(mesh_.tets[t].v[link.face()])) return false;
        (void)tets.add(t);
      }
    }
    return true;
  }

  [[nodiscard]] bool conflicts(TetId t) const {
    const auto& v = mesh_.tets[t].v;
    return in_conflict(apex_.vertex,
                       {&mesh_.vertices[v[0]], &mesh_.vertices[v[1]], &mesh_.vertices[v[2]], &mesh_.vertices[v[3]]});
  }

  Refusal rejoin() {
    Cavity& cavity = k_.cavity;
    if (const Refusal refusal = make_star_shaped(); refusal != Refusal::accepted) return refusal;
    for (double l : cavity.lengths())
      if (l < rules_.shortest_new_edge) return Refusal::short_edge;
    const double bound = std::min(rules_.worst_quality, rules_.share_of_old * cavity.worst_old_quality(mesh_));
    if (!(cavity.worst_new_quality() > bound)) return Refusal::quality;
    if (const Refusal refusal = cavity.validate(mesh_, *k_.block); refusal != Refusal::accepted) return refusal;
    cavity.commit(mesh_, *k_.block, k_.block->add_vertex(mesh_, apex_.vertex, apex_.tag, host_));
    return Refusal::accepted;
  }

  // Drops tetrahedra with a face that does not see the new vertex until none is left; never those of the shell.
  Refusal make_star_shaped() {
    Cavity& cavity = k_.cavity;
    for (int repair = 0; repair < most_repairs; ++repair) {
      if (const Refusal refusal = cavity.propose(mesh_, k_.model, apex_); refusal != Refusal::accepted) return refusal;
      std::array<bool, TetSet::capacity> drop{};
      bool any = false;
      for (int i = 0; i < cavity.batch.size(); ++i) {
        if (cavity.sees(i)) continue;
        if (cavity.owner(i) < core_) return Refusal::inverted;
        drop[cavity.owner(i)] = any = true;
      }
      if (!any) return Refusal::accepted;
      cavity.tets.shrink(core_, [&](int i) { return !drop[i]; });
    }
    return Refusal::inverted;
  }

  Kernel& k_;
  TetMesh& mesh_;
  const InsertionRules& rules_;
  Apex apex_;
  std::uint32_t host_ = 0;
  int core_ = 0;
};

}  // namespace

Refusal insert_on_edge(Kernel& kernel, TetId t, int edge, const InsertionRules& rules) {
  const Refusal refusal = collect_shell(kernel.mesh, *kernel.block, t, edge, kernel.shell);
  if (refusal != Refusal::accepted) return refusal;
  return kernel.mark_shell(Trial::insertion, Insertion(kernel, rules).run());
}

}  // namespace taut
