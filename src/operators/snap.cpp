#include "operators/snap.hpp"

#include "operators/vertex_move.hpp"

namespace taut {
namespace {

constexpr double share_kept = 0.1;  // of the worst 1/Q of the ball: flatter tetrahedra would block all later moves

}  // namespace

Outcome snap(Kernel& kernel, VertexId v) {
  if (!kernel.block->owns_ball(v)) return Outcome::put_off;
  VertexMove move(kernel, v);
  if (const Outcome outcome = move.gather(); outcome != Outcome::accepted) return outcome;
  const Vec3 x = move.old().x, step = kernel.model.project(move.tag(), x) - x;
  Outcome outcome = Outcome::no_candidate;
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    outcome = move.propose_at(share == 1 ? x + step : x + share * step);
    if (outcome != Outcome::accepted) continue;
    outcome = kernel.batch.all_above(share_kept * move.old_quality()) ? move.commit({}) : Outcome::quality;
    if (outcome == Outcome::accepted) return outcome;
  }
  return outcome;
}

}  // namespace taut
