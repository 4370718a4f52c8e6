#include "surface/ridge_rule.hpp"

#include <cmath>
#include <numbers>

namespace taut {
namespace {

constexpr double degrees = std::numbers::pi / 180;
constexpr RidgeThreshold for_any_edge = {15 * degrees, 15 * degrees};
constexpr RidgeThreshold for_given_edge = {5 * degrees, 5 * degrees};
// On a coarse mesh a few edges of a ridge between curved sides are flatter than the others.
constexpr RidgeThreshold for_next_edge = {7.5 * degrees, 10 * degrees};
constexpr double least_share_of_jump = 0.6;

}  // namespace

RidgeRule::RidgeRule(const Facets& facets, std::span<const EdgePair> pairs, std::optional<double> angle)
    : angle_(angle), normals_(unit_normals(facets)), jumps_(facets, pairs, normals_) {}

bool RidgeRule::holds_at(const EdgePair& pair, bool given) const {
  if (angle_) return dihedral_at(pair) >= *angle_ * degrees;
  return exceeds(pair, given ? for_given_edge : for_any_edge);
}

bool RidgeRule::continues_at(const EdgePair& pair) const {
  return !angle_ && exceeds(pair, for_next_edge);
}

bool RidgeRule::exceeds(const EdgePair& pair, const RidgeThreshold& least) const {
  const double dihedral = dihedral_at(pair);
  if (dihedral <= least.dihedral) return false;
  const double jump = jumps_.jump_at(pair);
  return jump > least.jump && jump > least_share_of_jump * dihedral;
}

double RidgeRule::dihedral_at(const EdgePair& pair) const {
  const Vec3 &a = normals_[pair[0].triangle], &b = normals_[pair[1].triangle];
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

}  // namespace taut
