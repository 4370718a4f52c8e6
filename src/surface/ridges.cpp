#include "surface/ridges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/parallel.hpp"
#include "surface/jump.hpp"

namespace taut {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_jump = 15 * degree;
constexpr double least_jump_of_given = 5 * degree;
constexpr double least_share_of_jump = 0.6;


double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

class RidgeFinder {
public:
  RidgeFinder(const Facets& facets, std::span<const int> refs, std::optional<double> angle)
      : angle_(angle), normals_(unit_normals(facets)), jumps_(facets, refs, normals_) {}

  [[nodiscard]] bool is_ridge(const EdgePair& pair, bool given) const {
    const double dihedral = angle_between(normals_[pair[0].triangle], normals_[pair[1].triangle]);
    if (angle_) return dihedral >= *angle_ * degree;
    const double least = given ? least_jump_of_given : least_jump;
    if (dihedral <= least) return false;
    const double jump = jumps_.jump_at(pair);
    return jump > least && jump > least_share_of_jump * dihedral;
  }

private:
  std::optional<double> angle_;
  std::vector<Vec3> normals_;
  JumpFinder jumps_;
};

const GivenEdge* find(std::span<const GivenEdge> given, const std::array<VertexId, 2>& edge) {
  const auto at = std::lower_bound(given.begin(), given.end(), edge,
                                   [](const GivenEdge& g, const auto& wanted) { return g.edge < wanted; });
  return at != given.end() && at->edge == edge ? &*at : nullptr;
}

int ref_of(const GivenEdge* given) {
  return given != nullptr ? given->ref : 0;
}

std::vector<EdgePair> edges_of_two(std::span<const EdgeUse> uses_of_edges) {
  std::vector<EdgePair> pairs;
  for_each_edge(uses_of_edges, [&](std::span<const EdgeUse> uses) {
    if (uses.size() == 2) pairs.push_back({uses[0], uses[1]});
  });
  return pairs;
}

}  // namespace

SplitEdges split_at_ridges(Facets& facets, std::span<const int> refs, std::span<const GivenEdge> given,
                           std::optional<double> angle) {
  const std::vector<EdgeUse> uses = edge_uses(facets.triangles);
  const std::vector<EdgePair> pairs = orient(facets.triangles, edges_of_two(uses));
  const RidgeFinder finder(facets, refs, angle);
  std::vector<std::uint8_t> is_smooth(pairs.size());
  for_each_index(Chunks(pairs.size(), 1024), [&](std::size_t e) {
    const EdgePair& pair = pairs[e];
    const GivenEdge* known = find(given, pair[0].edge);
    is_smooth[e] = refs[pair[0].triangle] == refs[pair[1].triangle] && !(known != nullptr && known->sharp) &&
                   !finder.is_ridge(pair, known != nullptr);
  });
  SplitEdges split;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (is_smooth[e] != 0) split.smooth.push_back(pairs[e]);
  std::size_t next = 0;  // of the smooth edges, which are ascending too
  for_each_edge(uses, [&](std::span<const EdgeUse> of) {
    if (next < split.smooth.size() && split.smooth[next][0].edge == of[0].edge)
      ++next;
    else
      split.ridges.push_back({of[0].edge, ref_of(find(given, of[0].edge))});
  });
  return split;
}

}  // namespace taut
