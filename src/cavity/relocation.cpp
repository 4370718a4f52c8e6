#include "cavity/relocation.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/orientation.hpp"

namespace taut {
namespace {

constexpr double decent_quality = 0.35;           // forces act on balls whose worst 1/Q is above it ..
constexpr double decent_shortest = 0.5, decent_longest = 2;  // .. and whose edges lie between these
constexpr double quality_kept = 0.9, least_quality = 0.25;   // what a force may cost: 1/Q of the ball's worst element
constexpr int halvings = 2;

// exp(-y) for y >= 0 to 1e-5, in operations that vectorise.
inline double exp_of_minus(double y) {
  const double z = std::min(y, 40.0) * (1.0 / 64);
  double e = 1 - z * (1 - z * (1.0 / 2) * (1 - z * (1.0 / 3) * (1 - z * (1.0 / 4))));
  for (int i = 0; i < 6; ++i) e *= e;
  return e;
}

// Bossen and Heckbert's force on an edge of length l, which also keeps short edges from vanishing.
inline double force(double l) {
  const double l4 = l * l * l * l;
  const double f = (1 - l4) * exp_of_minus(l4);
  return l < 1 ? f + (1 - l) * (1 - l) : f;
}

class Relocation {
public:
  Relocation(Kernel& kernel, VertexId v, const RelocationRules& rules)
      : k_(kernel), mesh_(kernel.mesh), v_(v), rules_(rules), old_(mesh_.vertices[v]), tag_(mesh_.tag_of_vertex[v]) {}

  Refusal run() {
    if (const Refusal refusal = gather(); refusal != Refusal::accepted) return refusal;
    if (old_quality_ > rules_.good_enough) return Refusal::no_candidate;
    const Vec3 step = wanted_step();
    Refusal refusal = Refusal::no_candidate;
    for (double share = 1; share > std::ldexp(0.75, -halvings); share *= 0.5) {
      refusal = attempt(share * step);
      if (refusal == Refusal::accepted) return refusal;
    }
    return refusal;
  }

private:
  Refusal gather() {
    TetSet& ball = k_.cavity.tets;
    if (!collect_ball(mesh_, v_, ball)) return Refusal::too_large;
    if (k_.any_frozen(ball.span())) return Refusal::frozen;
    k_.batch.clear();
    k_.neighbours.clear();
    old_quality_ = 1;
    for (TetId t : ball.span()) {
      const Tet& tet = mesh_.tets[t];
      const auto face = mesh_.face(t, tet.index_of(v_));
      k_.batch.push(mesh_.vertices[face[0]], mesh_.vertices[face[1]], mesh_.vertices[face[2]]);
      for (VertexId u : face)
        if (k_.neighbours.add(mesh_, u) < 0) return Refusal::too_large;
      old_quality_ = std::min(old_quality_, double{tet.quality});
    }
    return Refusal::accepted;
  }

  // Only neighbours on the vertex's own patch or line pull at it.
  [[nodiscard]] bool pulls(VertexId u) const {
    const Tag tag = mesh_.tag_of_vertex[u];
    return tag_.dimension == 3 || (tag_.dimension == 2 ? k_.model.on_patch(tag, tag_.id) : k_.model.on_line(tag, tag_.id));
  }

  Vec3 wanted_step() {
    const auto lengths = k_.neighbours.lengths(old_);
    shortest_ = 1e9;
    longest_ = 0;
    Vec3 forces{}, ideal{};
    int count = 0;
    for (int i = 0; i < k_.neighbours.size(); ++i) {
      if (!pulls(k_.neighbours.id(i))) continue;
      const double l = lengths[i];
      shortest_ = std::min(shortest_, l);
      longest_ = std::max(longest_, l);
      const Vec3 edge = old_.x - k_.neighbours.x(i);
      forces = forces + (force(l) / l) * edge;
      ideal = ideal + (1 / l - 1) * edge;
      ++count;
    }
    by_forces_ = old_quality_ > decent_quality && shortest_ > decent_shortest && longest_ < decent_longest;
    return by_forces_ ? rules_.factor * forces : (count == 0 ? 0.0 : 1.0 / count) * ideal;
  }

  Refusal attempt(const Vec3& step) {
    Vertex moved;
    moved.x = k_.model.project(tag_, old_.x + step);
    std::uint32_t host = mesh_.host_of_vertex[v_];
    moved.m = k_.target.at(moved.x, host);
    k_.batch.evaluate(moved);
    const double bound = by_forces_ ? std::max(quality_kept * old_quality_, least_quality) : 1.02 * old_quality_;
    for (int i = 0; i < k_.batch.size(); ++i)
      if (!(k_.batch.quality[i] > bound)) return Refusal::quality;
    if (by_forces_ && !lengths_hold(moved)) return Refusal::long_edge;
    if (!all_positive(moved.x)) return Refusal::inverted;
    write(moved, host);
    return Refusal::accepted;
  }

  // The longest and the shortest edge are no worse than they were, or unit.
  [[nodiscard]] bool lengths_hold(const Vertex& moved) const {
    const double longest = std::max(longest_, longest_unit), shortest = std::min(shortest_, shortest_unit);
    bool hold = true;
    for (double l : k_.neighbours.lengths(moved)) hold &= l <= longest && l >= shortest;
    return hold;
  }

  [[nodiscard]] bool all_positive(const Vec3& x) const {
    for (int i = 0; i < k_.batch.size(); ++i) {
      if (k_.batch.volume[i] > k_.batch.doubtful_volume()) continue;
      const TetId t = k_.cavity.tets[i];
      const auto f = mesh_.face(t, mesh_.tets[t].index_of(v_));
      if (orientation(x, mesh_.x(f[0]), mesh_.x(f[1]), mesh_.x(f[2])) <= 0) return false;
    }
    return true;
  }

  void write(const Vertex& moved, std::uint32_t host) {
    mesh_.vertices[v_] = moved;
    mesh_.host_of_vertex[v_] = host;
    const bool far = quadratic_form(moved.m, moved.x - old_.x) > rules_.still * rules_.still;
    for (int i = 0; i < k_.batch.size(); ++i) {
      Tet& tet = mesh_.tets[k_.cavity.tets[i]];
      tet.quality = static_cast<float>(k_.batch.quality[i]);
      if (far) tet.tried = 0;
    }
    if (!far) return;
    mesh_.restless[v_] = 1;
    for (int i = 0; i < k_.neighbours.size(); ++i) mesh_.restless[k_.neighbours.id(i)] = 1;
  }

  Kernel& k_;
  TetMesh& mesh_;
  const VertexId v_;
  const RelocationRules& rules_;
  const Vertex old_;
  const Tag tag_;
  double old_quality_ = 1, shortest_ = 0, longest_ = 0;
  bool by_forces_ = false;
};

}  // namespace

Refusal relocate(Kernel& kernel, VertexId v, const RelocationRules& rules) {
  kernel.mesh.restless[v] = 0;
  if (kernel.mesh.tag_of_vertex[v].dimension == 0) return Refusal::geometry;
  return Relocation(kernel, v, rules).run();
}

}  // namespace taut
