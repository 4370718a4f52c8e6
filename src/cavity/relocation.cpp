#include "cavity/relocation.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/orientation.hpp"
#include "metric/quality.hpp"

namespace taut {
namespace {

constexpr double decent_quality = 0.35;                      // forces act on balls whose worst 1/Q is above it ..
constexpr double decent_shortest = 0.5, decent_longest = 2;  // .. and whose edges lie between these
constexpr double quality_kept = 0.9, least_quality = 0.25;   // what a force may cost: 1/Q of the ball's worst element
constexpr int halvings = 2;

// exp(-y) for y >= 0 to 1e-5, in operations that vectorise.
inline double exp_of_minus(double y) {
  const double z = (y < 40 ? y : 40) * (1.0 / 64);
  double e = 1 - z * (1 - z * (1.0 / 2) * (1 - z * (1.0 / 3) * (1 - z * (1.0 / 4))));
  for (int i = 0; i < 6; ++i) e *= e;
  return e;
}

// Bossen and Heckbert's force on an edge of length l, which also keeps short edges from vanishing.
inline double force(double l) {
  const double l4 = l * l * l * l, gap = l < 1 ? 1 - l : 0;
  return (1 - l4) * exp_of_minus(l4) + gap * gap;
}

class Relocation {
public:
  Relocation(Kernel& kernel, VertexId v, const RelocationRules& rules)
      : k_(kernel), mesh_(kernel.mesh), v_(v), rules_(rules), old_(mesh_.vertices[v]), tag_(mesh_.tag_of_vertex[v]) {}

  Refusal run() {
    if (const Refusal refusal = gather(); refusal != Refusal::accepted) return refusal;
    if (old_quality_ > rules_.good_enough) return Refusal::no_candidate;
    measure_edges();
    const Vec3 step = wanted_step();
    Refusal refusal = Refusal::no_candidate;
    for (double share = 1; share > std::ldexp(0.75, -halvings); share *= 0.5) {
      refusal = attempt(share * step);
      if (refusal == Refusal::accepted) return refusal;
    }
    return refusal;
  }

  // Away from the worst tetrahedron's opposite face, orthogonally in the metric, by shares of a unit length.
  Refusal lift(double gain) {
    if (const Refusal refusal = gather(); refusal != Refusal::accepted) return refusal;
    measure_edges();
    gain_ = gain;
    int worst = 0;
    for (int i = 1; i < k_.cavity.tets.size(); ++i)
      if (mesh_.tets[k_.cavity.tets[i]].quality < mesh_.tets[k_.cavity.tets[worst]].quality) worst = i;
    const TetId t = k_.cavity.tets[worst];
    const auto face = mesh_.face(t, mesh_.tets[t].index_of(v_));
    const Vec3 inward = cross(mesh_.x(face[2]) - mesh_.x(face[0]), mesh_.x(face[1]) - mesh_.x(face[0]));
    const Vec3 direction = adjugate(old_.m) * inward;
    const double length = std::sqrt(quadratic_form(old_.m, direction));
    Refusal refusal = Refusal::no_candidate;
    for (const double share : {0.5, 0.25, 0.12, 0.06}) {
      refusal = attempt((share / length) * direction);
      if (refusal == Refusal::accepted) return refusal;
    }
    return refusal;
  }

private:
  // The ball first, then its vertices: what the walk finds is on its way from memory when it is needed.
  Refusal gather() {
    old_quality_ = 1;
    std::array<std::array<VertexId, 4>, TetSet::capacity> faces;  // opposite to v, and the vertex not met before
    int count = 0;
    const auto visit = [&](const Tet& tet, int at, VertexId fresh) {
      const auto& corner = face_vertices[at];
      faces[count++] = {tet.v[corner[0]], tet.v[corner[1]], tet.v[corner[2]], fresh};
      if (fresh != none) __builtin_prefetch(&mesh_.vertices[fresh]);
      old_quality_ = std::min(old_quality_, double{tet.quality});
    };
    if (!walk_ball(mesh_, v_, k_.cavity.tets, visit)) return Refusal::too_large;
    if (k_.any_frozen(k_.cavity.tets.span())) return Refusal::frozen;
    k_.batch.clear();
    k_.neighbours.clear();
    for (int k = 0; k < 3; ++k) (void)k_.neighbours.add(mesh_, faces[0][k]);
    for (int i = 0; i < count; ++i) {
      const auto& [a, b, c, fresh] = faces[i];
      if (fresh != none && k_.neighbours.add(mesh_, fresh) < 0) return Refusal::too_large;
      k_.batch.push(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
    }
    return Refusal::accepted;
  }

  // Only neighbours on the vertex's own patch or line pull at it.
  [[nodiscard]] bool pulls(VertexId u) const {
    const Tag tag = mesh_.tag_of_vertex[u];
    return tag_.dimension == 3 ||
           (tag_.dimension == 2 ? k_.model.on_patch(tag, tag_.id) : k_.model.on_line(tag, tag_.id));
  }

  void measure_edges() {
    lengths_ = k_.neighbours.lengths(old_);
    for (double l : lengths_) {
      not_unit_ |= !is_unit(l);
      old_phi_ += efficiency_phi(l);
    }
  }

  Vec3 wanted_step() {
    const auto lengths = lengths_;
    const int count = static_cast<int>(lengths.size());
    std::array<double, VertexBatch::capacity> pull;
    for (int i = 0; i < count; ++i) pull[i] = pulls(k_.neighbours.id(i)) ? 1 : 0;
    double pulling = 0;
    shortest_ = 1e9;
    longest_ = 0;
    for (int i = 0; i < count; ++i) {
      if (pull[i] == 0) continue;
      shortest_ = std::min(shortest_, lengths[i]);
      longest_ = std::max(longest_, lengths[i]);
      ++pulling;
    }
    by_forces_ = old_quality_ > decent_quality && shortest_ > decent_shortest && longest_ < decent_longest;
    if (by_forces_)
      for (int i = 0; i < count; ++i) pull[i] *= rules_.factor * force(lengths[i]) / lengths[i];
    else
      for (int i = 0; i < count; ++i) pull[i] *= (1 / lengths[i] - 1) / pulling;
    return k_.neighbours.weighted_edges(old_.x, {pull.data(), lengths.size()});
  }

  Refusal attempt(const Vec3& step) {
    Vertex moved;
    moved.x = k_.model.project(tag_, old_.x + step);
    std::uint32_t host = mesh_.host_of_vertex[v_];
    moved.m = k_.target.at(moved.x, host);
    k_.batch.evaluate(moved);
    const double bound = by_forces_ ? std::max(quality_kept * old_quality_, least_quality) : gain_ * old_quality_;
    for (int i = 0; i < k_.batch.size(); ++i)
      if (!(k_.batch.quality[i] > bound)) return Refusal::quality;
    const auto lengths = k_.neighbours.lengths(moved);
    if (by_forces_ && !lengths_hold(lengths)) return Refusal::long_edge;
    if (!all_positive(moved.x)) return Refusal::inverted;
    write(moved, host);
    note_lengths(lengths);
    return Refusal::accepted;
  }

  // The longest and the shortest edge are no worse than they were, or unit.
  [[nodiscard]] bool lengths_hold(std::span<const double> lengths) const {
    const double longest = std::max(longest_, longest_unit), shortest = std::min(shortest_, shortest_unit);
    bool hold = true;
    for (double l : lengths) hold &= l <= longest && l >= shortest;
    return hold;
  }

  [[nodiscard]] bool all_positive(const Vec3& x) const {
    for (int i = 0; i < k_.batch.size(); ++i) {
      if (k_.batch.volume[i] > k_.batch.doubtful_volume[i]) continue;
      const TetId t = k_.cavity.tets[i];
      const auto f = mesh_.face(t, mesh_.tets[t].index_of(v_));
      if (orientation(x, mesh_.x(f[0]), mesh_.x(f[1]), mesh_.x(f[2])) <= 0) return false;
    }
    return true;
  }

  void write(const Vertex& moved, std::uint32_t host) {
    mesh_.vertices[v_] = moved;
    mesh_.host_of_vertex[v_] = host;
    const double moved_by = std::sqrt(quadratic_form(moved.m, moved.x - old_.x));
    float& drift = mesh_.drift[v_];
    drift += static_cast<float>(moved_by);
    const bool forget_swaps = drift > rules_.drift;
    if (forget_swaps) drift = 0;
    for (int i = 0; i < k_.batch.size(); ++i) {
      Tet& tet = mesh_.tets[k_.cavity.tets[i]];
      tet.quality = static_cast<float>(k_.batch.quality[i]);
      if (!forget_swaps) continue;
      tet.forget_swaps();
      tet.forget_lengths();
    }
    if (moved_by < rules_.still) return;
    mesh_.restless[v_] = 1;
    for (int i = 0; i < k_.neighbours.size(); ++i) mesh_.restless[k_.neighbours.id(i)] = 1;
  }

  // Where an edge is not unit, or was not, the passes that split and collapse must know.
  void note_lengths(std::span<const double> lengths) {
    k_.efficiency_gain -= old_phi_;
    for (int i = 0; i < k_.neighbours.size(); ++i) {
      k_.efficiency_gain += efficiency_phi(lengths[i]);
      not_unit_ |= !is_unit(lengths[i]);
    }
    if (!not_unit_) return;
    for (int i = 0; i < k_.batch.size(); ++i) {
      Tet& tet = mesh_.tets[k_.cavity.tets[i]];
      const int at = tet.index_of(v_);
      for (int k : face_vertices[at]) note_length(tet, edge_between[at][k], lengths[k_.neighbours.find(tet.v[k])]);
    }
  }

  Kernel& k_;
  TetMesh& mesh_;
  const VertexId v_;
  const RelocationRules rules_;
  const Vertex old_;
  const Tag tag_;
  std::span<const double> lengths_;  // before the move; valid until the first attempt
  double old_quality_ = 1, old_phi_ = 0, shortest_ = 0, longest_ = 0;
  double gain_ = 1.02;
  bool by_forces_ = false, not_unit_ = false;
};

}  // namespace

Refusal relocate(Kernel& kernel, VertexId v, const RelocationRules& rules) {
  if (!kernel.block->owns_ball(v)) return Refusal::put_off;
  kernel.mesh.restless[v] = 0;
  if (kernel.mesh.tag_of_vertex[v].dimension == 0) return Refusal::geometry;
  return Relocation(kernel, v, rules).run();
}

Refusal lift(Kernel& kernel, VertexId v, double gain) {
  if (!kernel.block->owns_ball(v)) return Refusal::put_off;
  if (kernel.mesh.tag_of_vertex[v].dimension == 0) return Refusal::geometry;
  return Relocation(kernel, v, {}).lift(gain);
}

}  // namespace taut
