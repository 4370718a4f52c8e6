#include "operators/vertex_move.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/fit.hpp"
#include "mesh/orientation.hpp"
#include "metric/quality.hpp"

namespace taut {

VertexMove::VertexMove(Kernel& kernel, VertexId v)
    : k_(kernel),
      mesh_(kernel.mesh),
      v_(v),
      old_(mesh_.vertices[v]),
      tag_(mesh_.tag_of_vertex[v]),
      seat_(mesh_.seat_of_vertex[v]) {}

// Collects the ball first and then its vertices, so that memory fetched during the walk has arrived when it is needed.
Outcome VertexMove::gather() {
  std::array<std::array<VertexId, 4>, TetSet::capacity> faces;  // opposite to v, and the vertex that is new
  int count = 0;
  const auto visit = [&](const Tet& tet, int at, VertexId fresh) {
    const auto& corner = face_vertices[at];
    faces[count++] = {tet.v[corner[0]], tet.v[corner[1]], tet.v[corner[2]], fresh};
    if (fresh != none) __builtin_prefetch(&mesh_.vertices[fresh]);
    old_quality_ = std::min(old_quality_, double{tet.state.quality});
  };
  if (!walk_ball(mesh_, v_, k_.cavity.tets, visit)) return Outcome::too_large;
  if (k_.any_frozen(k_.cavity.tets.span())) return Outcome::frozen;
  k_.batch.clear();
  k_.neighbours.clear();
  for (int k = 0; k < 3; ++k) (void)k_.neighbours.add(mesh_, faces[0][k]);
  for (int i = 0; i < count; ++i) {
    const auto& [a, b, c, fresh] = faces[i];
    if (fresh != none && k_.neighbours.add(mesh_, fresh) < 0) return Outcome::too_large;
    k_.batch.push(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
  }
  if (k_.model.surface.exists() && !tag_.is_in_volume()) gather_facets();
  lengths_ = k_.neighbours.lengths(old_);
  for (double l : lengths_) {
    not_unit_ |= !is_unit(l);
    old_phi_ += efficiency_phi(l);
  }
  return Outcome::accepted;
}

void VertexMove::gather_facets() {
  for (const TetId t : k_.cavity.tets.span())
    for (int f = 0; f < 4; ++f) {
      const FaceLink link = mesh_.tets[t].n[f];
      if (!link.is_triangle() || mesh_.tets[t].v[f] == v_) continue;
      const Triangle& triangle = mesh_.triangles[link.triangle()];
      const bool seen = triangle.side[0] != FaceLink::to_face(t, f);  // from its other side
      if (seen || k_.model.patches[triangle.patch].curved() == nullptr) continue;
      const auto at = std::ranges::find(triangle.v, v_) - triangle.v.begin();
      facets_.push_back({triangle.patch, triangle.v[(at + 1) % 3], triangle.v[(at + 2) % 3]});
    }
}

double VertexMove::worst_misfit(const Vec3& x, SeatId near) const {
  double worst = 0;
  if (!tag_.is_on_patch()) near = none;
  for (const auto& [patch, b, c] : facets_)
    worst = std::max(worst, misfit(k_.model, patch, {x, mesh_.x(b), mesh_.x(c)}, old_.m, near));
  return worst;
}

bool VertexMove::facets_fit() {
  const double worst = worst_misfit(moved_.x, seat_);
  if (worst <= 1) return true;
  if (old_misfit_ < 0) old_misfit_ = worst_misfit(old_.x, mesh_.seat_of_vertex[v_]);
  return worst <= old_misfit_ && worst < std::numeric_limits<double>::infinity();
}

// A place beyond the ball may lie outside the domain: finding that out from the target takes as long as a hundred
// moves.
Outcome VertexMove::propose(const Vec3& step) {
  measured_ = false;
  moved_.x = k_.model.project(tag_, old_.x + step, seat_);
  if (!k_.batch.all_see(moved_.x)) return Outcome::inverted;
  if (!facets_.empty() && !facets_fit()) return Outcome::surface;
  evaluate();
  return Outcome::accepted;
}

Outcome VertexMove::propose_at(const Vec3& place) {
  measured_ = false;
  moved_.x = place;
  if (!k_.batch.all_see(moved_.x)) return Outcome::inverted;
  evaluate();
  return Outcome::accepted;
}

void VertexMove::evaluate() {
  host_ = mesh_.host_of_vertex[v_];
  moved_.m = k_.target.at(moved_.x, host_);
  k_.batch.evaluate(moved_);
}

std::span<const double> VertexMove::new_lengths() {
  if (!std::exchange(measured_, true)) lengths_ = k_.neighbours.lengths(moved_);
  return lengths_;
}

Outcome VertexMove::commit(const MoveRules& rules) {
  if (!all_positive()) return Outcome::inverted;
  write(rules);
  note_lengths();
  return Outcome::accepted;
}

bool VertexMove::all_positive() const {
  for (int i = 0; i < k_.batch.size(); ++i) {
    if (k_.batch.volume[i] > k_.batch.doubtful_volume[i]) continue;
    const TetId t = k_.cavity.tets[i];
    const auto f = mesh_.face(t, mesh_.tets[t].index_of(v_));
    if (orientation(moved_.x, mesh_.x(f[0]), mesh_.x(f[1]), mesh_.x(f[2])) <= 0) return false;
  }
  return true;
}

void VertexMove::write(const MoveRules& rules) {
  mesh_.vertices[v_] = moved_;
  mesh_.host_of_vertex[v_] = host_;
  mesh_.seat_of_vertex[v_] = seat_;
  const double moved_by = std::sqrt(quadratic_form(moved_.m, moved_.x - old_.x));
  float& drift = mesh_.state_of_vertex[v_].drift;
  drift += static_cast<float>(moved_by);
  const bool forget = drift > rules.drift;
  if (forget) drift = 0;
  for (int i = 0; i < k_.batch.size(); ++i) {
    TetState& state = mesh_.tets[k_.cavity.tets[i]].state;
    state.quality = static_cast<float>(k_.batch.quality[i]);
    if (!forget) continue;
    state.tried.forget_shapes();
    state.tried.forget_lengths();
  }
  if (moved_by < rules.still) return;
  mesh_.state_of_vertex[v_].restless = true;
  for (int i = 0; i < k_.neighbours.size(); ++i) mesh_.state_of_vertex[k_.neighbours.id(i)].restless = true;
}

// The passes that split and collapse must know which edges are not unit or were not.
void VertexMove::note_lengths() {
  k_.efficiency_gain -= old_phi_;
  const auto lengths = new_lengths();
  for (double l : lengths) {
    k_.efficiency_gain += efficiency_phi(l);
    not_unit_ |= !is_unit(l);
  }
  if (!not_unit_) return;
  for (int i = 0; i < k_.batch.size(); ++i) {
    Tet& tet = mesh_.tets[k_.cavity.tets[i]];
    const int at = tet.index_of(v_);
    for (int k : face_vertices[at]) note_length(tet, edge_between[at][k], lengths[k_.neighbours.find(tet.v[k])]);
  }
}

}  // namespace taut
