#include "operators/insertion.hpp"

#include <algorithm>

#include "operators/delaunay.hpp"

namespace taut {
namespace {

constexpr int most_repairs = 12;     // repetitions of removing tetrahedra whose faces do not see the new vertex
constexpr int most_growths = 12;     // the same for adding the tetrahedra beyond
constexpr int largest_cavity = 100;  // the criterion of eq. (4) rarely gives 40

// Finds the line or patch on which the edge of the shell lies. False if it may not be split.
bool locate(const Kernel& k, Tag& tag) {
  const Shell& shell = k.shell;
  for (int i = 0; i < shell.triangle_count; ++i) {
    const Triangle& triangle = k.mesh.triangles[shell.triangles[i]];
    if (k.model.patches[triangle.patch].frozen()) return false;
    int corner = 0;
    while (triangle.v[corner] == shell.a || triangle.v[corner] == shell.b) ++corner;
    const LineId line = triangle.line[corner];
    if (line != none && k.model.lines[line].frozen) return false;
    tag = line != none ? Tag::on_line(line) : Tag::on_patch(triangle.patch);
  }
  return true;
}

class Insertion {
public:
  Insertion(Kernel& kernel, const Vec3& x, const InsertionRules& rules)
      : k_(kernel), mesh_(kernel.mesh), x_(x), rules_(rules) {}

  Outcome run() {
    if (k_.any_frozen(k_.shell_tets()) || !locate(k_, apex_.tag)) return Outcome::frozen;
    if (k_.block->vertices.available() == 0) return Outcome::put_off;
    place();
    for (int i = 0; i < k_.shell.ring_size; ++i)
      if (too_short(k_.shell.ring[i])) return Outcome::short_edge;
    collect_core();
    if (!grow()) return Outcome::put_off;
    const Outcome outcome = rejoin();
    const bool is_final = outcome == Outcome::accepted || outcome == Outcome::short_edge || outcome == Outcome::put_off;
    if (is_final) return outcome;
    if (k_.cavity.tets.size() == core_) return outcome == Outcome::inverted ? make_room() : outcome;
    collect_core();
    const Outcome reduced = rejoin();
    return reduced == Outcome::inverted ? make_room() : reduced;
  }

private:
  void place() {
    apex_.id = k_.block->vertices.next();
    apex_.seat = seat_nearby();
    apex_.vertex.x = k_.model.project(apex_.tag, x_, apex_.seat);
    apex_.host = mesh_.host_of_vertex[k_.shell.a];
    apex_.vertex.m = k_.target.at(apex_.vertex.x, apex_.host);
  }

  [[nodiscard]] SeatId seat_nearby() const {
    for (const VertexId v : {k_.shell.a, k_.shell.b})
      if (mesh_.tag_of_vertex[v] == apex_.tag) return mesh_.seat_of_vertex[v];
    return none;
  }

  [[nodiscard]] bool too_short(VertexId v) const {
    const Vertex& q = mesh_.vertices[v];
    return edge_length_fast(apex_.vertex.x, q.x, apex_.vertex.m, q.m) < rules_.shortest_new_edge;
  }

  void collect_core() {
    k_.cavity.tets.assign(k_.shell_tets());
    core_ = k_.cavity.tets.size();
  }

  // False if a tetrahedron that the block does not own is also in conflict. The vertices of such a tetrahedron do not
  // move.
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

  Outcome rejoin() {
    if (const Outcome outcome = make_star_shaped(); outcome != Outcome::accepted) return outcome;
    return k_.cavity.conclude(mesh_, *k_.block, [&] { return judge(); });
  }

  [[nodiscard]] Outcome judge() {
    for (double l : k_.cavity.lengths())
      if (l < rules_.shortest_new_edge) return Outcome::short_edge;
    const double bound = std::min(rules_.worst_quality, rules_.share_of_old * k_.cavity.worst_old_quality(mesh_));
    return k_.cavity.batch.all_above(bound) ? Outcome::accepted : Outcome::quality;
  }

  // A vertex on a curved surface is not on the edge that it splits: what lies between them is in its way. The cavity
  // takes in the tetrahedra beyond all faces that do not see the vertex, and the vertices in the volume that it comes
  // to enclose go.
  Outcome make_room() {
    if (apex_.tag.is_in_volume() || !k_.model.surface.exists()) return Outcome::inverted;
    Cavity& cavity = k_.cavity;
    collect_core();
    for (int growth = 0; growth < most_growths; ++growth) {
      if (const Outcome outcome = cavity.propose(mesh_, k_.model, apex_); outcome != Outcome::accepted) return outcome;
      const int size = cavity.tets.size();
      for (int i = 0; i < cavity.batch.size(); ++i)
        if (!cavity.sees(i))
          if (const Outcome outcome = cross(i); outcome != Outcome::accepted) return outcome;
      if (cavity.tets.size() == size)
        return cavity.conclude(
            mesh_, *k_.block, [&] { return judge(); }, Enclosed::go);
    }
    return Outcome::inverted;
  }

  // Adds the tetrahedron beyond face i of the hull, unless it must stay.
  Outcome cross(int i) {
    TetSet& tets = k_.cavity.tets;
    const FaceLink link = mesh_.tets[tets[k_.cavity.owner(i)]].n[k_.cavity.face(i)];
    if (link.is_triangle() || tets.size() >= largest_cavity) return Outcome::inverted;
    const TetId t = link.tet();
    if (tets.contains(t)) return Outcome::accepted;
    if (k_.any_frozen({&t, 1})) return Outcome::frozen;
    if (!k_.block->owns(mesh_.tets[t].v[link.face()])) return Outcome::put_off;
    (void)tets.add(t);
    return Outcome::accepted;
  }

  // Removes tetrahedra with a face that does not see the new vertex from the cavity, until none is left, but never
  // those of the shell.
  Outcome make_star_shaped() {
    Cavity& cavity = k_.cavity;
    for (int repair = 0; repair < most_repairs; ++repair) {
      if (const Outcome outcome = cavity.propose(mesh_, k_.model, apex_); outcome != Outcome::accepted) return outcome;
      std::array<bool, TetSet::capacity> drop{};
      bool any = false;
      for (int i = 0; i < cavity.batch.size(); ++i) {
        if (cavity.sees(i)) continue;
        if (cavity.owner(i) < core_) return Outcome::inverted;
        drop[cavity.owner(i)] = any = true;
      }
      if (!any) return Outcome::accepted;
      cavity.tets.shrink(core_, [&](int i) { return !drop[i]; });
    }
    return Outcome::inverted;
  }

  Kernel& k_;
  TetMesh& mesh_;
  const Vec3 x_;
  const InsertionRules& rules_;
  Apex apex_;
  int core_ = 0;
};

}  // namespace

Outcome insert_on_edge(Kernel& kernel, TetId t, int edge, const Vec3& x, const InsertionRules& rules) {
  const Outcome collected = collect_shell(kernel.mesh, *kernel.block, t, edge, kernel.shell);
  if (collected != Outcome::accepted) return collected;
  return kernel.mark_shell(Trial::insertion, Insertion(kernel, x, rules).run());
}

Outcome insert_on_edge(Kernel& kernel, TetId t, int edge, const InsertionRules& rules) {
  const auto& v = kernel.mesh.tets[t].v;
  const auto& [i, j] = edge_vertices[edge];
  return insert_on_edge(kernel, t, edge, 0.5 * (kernel.mesh.x(v[i]) + kernel.mesh.x(v[j])), rules);
}

}  // namespace taut
