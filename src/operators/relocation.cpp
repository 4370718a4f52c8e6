#include "operators/relocation.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double decent_quality = 0.35;                      // forces act on balls whose worst 1/Q is above this ..
constexpr double decent_shortest = 0.5, decent_longest = 2;  // .. and whose edge lengths lie between these
constexpr double quality_kept = 0.9, least_quality = 0.25;   // bounds on the loss by a force, in the ball's worst 1/Q
constexpr double least_gain = 1.02;                          // of the worst 1/Q, where no force acts
constexpr int halvings = 2;

// exp(-y) for y >= 0, accurate to 1e-5, in operations that vectorise.
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
  Relocation(Kernel& kernel, VertexId v, const RelocationRules& rules) : k_(kernel), move_(kernel, v), rules_(rules) {}

  Outcome run() {
    if (const Outcome outcome = move_.gather(); outcome != Outcome::accepted) return outcome;
    if (move_.old_quality() > rules_.good_enough) return Outcome::no_candidate;
    const Vec3 step = wanted_step();
    Outcome outcome = Outcome::no_candidate;
    for (double share = 1; share > std::ldexp(0.75, -halvings); share *= 0.5) {
      outcome = attempt(share * step);
      if (outcome == Outcome::accepted) return outcome;
    }
    return outcome;
  }

private:
  // Only neighbours on the vertex's own patch or line exert a force.
  [[nodiscard]] bool pulls(VertexId u) const {
    const Tag tag = k_.mesh.tag_of_vertex[u], own = move_.tag();
    return own.is_in_volume() ||
           (own.is_on_patch() ? k_.model.on_patch(tag, own.patch()) : k_.model.on_line(tag, own.line()));
  }

  Vec3 wanted_step() {
    const auto lengths = move_.old_lengths();
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
    by_forces_ = move_.old_quality() > decent_quality && shortest_ > decent_shortest && longest_ < decent_longest;
    if (by_forces_)  // of unit length where the vertex is, or those from the coarse side would be stronger
      for (int i = 0; i < count; ++i)
        pull[i] *= rules_.factor * force(lengths[i]) / length_in(move_.old().m, k_.neighbours.x(i) - move_.old().x);
    else
      for (int i = 0; i < count; ++i) pull[i] *= (1 / lengths[i] - 1) / pulling;
    return k_.neighbours.weighted_edges(move_.old().x, {pull.data(), lengths.size()});
  }

  Outcome attempt(const Vec3& step) {
    const double old = move_.old_quality();
    const double bound = by_forces_ ? std::max(quality_kept * old, least_quality) : least_gain * old;
    if (const Outcome outcome = move_.propose(step); outcome != Outcome::accepted) return outcome;
    if (!k_.batch.all_above(bound)) return Outcome::quality;
    if (by_forces_ && !lengths_hold(move_.new_lengths())) return Outcome::long_edge;
    return move_.commit(rules_.move);
  }

  // Whether the longest and the shortest edge are no worse than before, or unit.
  [[nodiscard]] bool lengths_hold(std::span<const double> lengths) const {
    const double longest = std::max(longest_, longest_unit), shortest = std::min(shortest_, shortest_unit);
    bool hold = true;
    for (double l : lengths) hold &= l <= longest && l >= shortest;
    return hold;
  }

  Kernel& k_;
  VertexMove move_;
  const RelocationRules rules_;
  double shortest_ = 0, longest_ = 0;
  bool by_forces_ = false;
};

}  // namespace

Outcome relocate(Kernel& kernel, VertexId v, const RelocationRules& rules) {
  if (!kernel.block->owns_ball(v)) return Outcome::put_off;
  kernel.mesh.state_of_vertex[v].restless = false;
  if (kernel.mesh.tag_of_vertex[v].is_at_corner()) return Outcome::geometry;
  return Relocation(kernel, v, rules).run();
}

}  // namespace taut
