#include "motion/rigid_moves.hpp"

#include <algorithm>

namespace taut {
namespace {

bool are_same(const RigidMotion& a, const RigidMotion& b) {
  return a.matrix() == b.matrix() && a.offset() == b.offset();
}

}  // namespace

RigidMoves rigid_moves(const Boundary& boundary, const Goal& goal, double share) {
  RigidMoves moves;
  moves.of_vertex.assign(boundary.roles.size(), none);
  std::vector<std::uint32_t> of_body;
  for (const RigidMotion& motion : goal.part(share).motions) {
    const auto known = std::ranges::find_if(moves.motions, [&](const auto& other) { return are_same(motion, other); });
    of_body.push_back(static_cast<std::uint32_t>(known - moves.motions.begin()));
    if (known == moves.motions.end()) moves.motions.push_back(motion);
  }
  if (moves.motions.empty()) return moves;
  for (std::size_t v = 0; v < boundary.roles.size(); ++v)
    if (const Role& role = boundary.roles[v]; role.driver == Driver::body) moves.of_vertex[v] = of_body[role.body];
  return moves;
}

}  // namespace taut
