#include "surface/ridge_gaps.hpp"

#include "base/buckets.hpp"
#include "taut/mesh.hpp"

namespace taut {
namespace {

constexpr double least_cosine_of_turn = 0.70710678;
constexpr std::size_t most_edges_of_gap = 3;

class RidgeTracer {
public:
  RidgeTracer(const Facets& facets, std::span<const EdgePair> pairs, const RidgeRule& rule,
              std::vector<Parting>& parting)
      : facets_(facets),
        pairs_(pairs),
        rule_(rule),
        parting_(parting),
        pairs_at_(gather<Index>(pairs.size(), facets.points.size(),
                                [&](std::size_t e, auto put) {
                                  for (const VertexId v : pairs[e][0].edge) put(v, static_cast<Index>(e));
                                })),
        borders_at_(facets.points.size(), 0) {
    // Around a vertex inside a surface there are as many edges as triangles.
    for (const Corners& t : facets.triangles)
      for (const VertexId v : t) ++borders_at_[v];
    for (const VertexId v : ids<VertexId>(borders_at_.size())) borders_at_[v] -= pairs_at_[v].size();
  }

  /// From `v`, if it is the end of one ridge, to the next ridge or to a border.
  void follow(VertexId v) {
    Index ridge = single_ridge_at(v);
    std::vector<Index> gap;
    while (ridge != none) {
      ridge = gap.size() < most_edges_of_gap ? continuation(ridge, v) : none;
      if (ridge == none) {
        for (const Index e : gap) parting_[e] = Parting::smooth;
        return;
      }
      parting_[ridge] = Parting::by_shape;
      gap.push_back(ridge);
      v = beyond(ridge, v);
      if (single_ridge_at(v) != ridge) return;
    }
  }

private:
  [[nodiscard]] Index single_ridge_at(VertexId v) const {
    Index found = none;
    if (borders_at_[v] != 0) return found;
    for (const Index e : pairs_at_[v]) {
      if (parting_[e] == Parting::smooth) continue;
      if (found != none) return none;
      found = e;
    }
    return found;
  }

  [[nodiscard]] Index continuation(Index ridge, VertexId v) const {
    const Vec3 in = facets_.points[v] - facets_.points[beyond(ridge, v)];
    Index best = none;
    double most = least_cosine_of_turn;
    for (const Index e : pairs_at_[v]) {
      const Vec3 out = facets_.points[beyond(e, v)] - facets_.points[v];
      const double cosine = dot(in, out) / (norm(in) * norm(out));
      if (e != ridge && cosine > most && rule_.continues_at(pairs_[e])) best = e, most = cosine;
    }
    return best;
  }

  [[nodiscard]] VertexId beyond(Index e, VertexId v) const {
    const auto& edge = pairs_[e][0].edge;
    return edge[0] == v ? edge[1] : edge[0];
  }

  const Facets& facets_;
  std::span<const EdgePair> pairs_;
  const RidgeRule& rule_;
  std::vector<Parting>& parting_;
  Buckets<Index> pairs_at_;
  std::vector<std::size_t> borders_at_;  ///< not 0 where other than two triangles meet at an edge
};

}  // namespace

void extend_ridges(const Facets& facets, std::span<const EdgePair> pairs, const RidgeRule& rule,
                   std::vector<Parting>& parting) {
  RidgeTracer tracer(facets, pairs, rule, parting);
  for (const VertexId v : ids<VertexId>(facets.points.size())) tracer.follow(v);
}

}  // namespace taut
