#include "surface/ridges.hpp"

#include <algorithm>
#include <cstdint>

#include "base/parallel.hpp"
#include "surface/ridge_gaps.hpp"
#include "surface/ridge_rule.hpp"
#include "surface/spokes.hpp"

namespace taut {
namespace {

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
  const RidgeRule rule(facets, pairs, angle);
  std::vector<Parting> parting(pairs.size());
  for_each_index(Chunks(pairs.size(), 1024), [&](std::size_t e) {
    const EdgePair& pair = pairs[e];
    const GivenEdge* known = find(given, pair[0].edge);
    const bool is_given = refs[pair[0].triangle] != refs[pair[1].triangle] || (known != nullptr && known->sharp);
    parting[e] = is_given                                ? Parting::by_input
                 : rule.holds_at(pair, known != nullptr) ? Parting::by_shape
                                                         : Parting::smooth;
  });
  if (!angle) {
    extend_ridges(facets, pairs, rule, parting);
    drop_spokes(facets, pairs, parting);
  }
  SplitEdges split;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (parting[e] == Parting::smooth) split.smooth.push_back(pairs[e]);
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
