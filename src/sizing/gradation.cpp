#include "sizing/gradation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <queue>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "base/vec3.hpp"
#include "metric/cholesky.hpp"
#include "metric/intersection.hpp"
#include "metric/length.hpp"

namespace taut {
namespace {

using Edge = std::array<Index, 2>;

/// Relative excess of an eigenvalue that is tolerated.
constexpr double tolerance = 1e-3;

/// Bound on the number of vertices visited, as a multiple of the vertices. Intersections of metrics in oblique
/// directions may have smaller sizes than either metric, so there is no proof that the corrections end; in practice,
/// they end after a few multiples.
constexpr std::size_t largest_effort = 200;

/// The metric that p requires at q, unless that at q already satisfies it.
std::optional<Sym3> demand(const Vec3& p, const Vec3& q, const Sym3& mp, const Sym3& mq, double log_beta) {
  // Equal metrics require nothing of each other, however badly conditioned they are.
  if (mp == mq) return {};
  const double growth = 1 + length_in(mp, q - p) * log_beta;
  const Sym3 grown = 1 / (growth * growth) * mp;
  if (is_dominated(grown, mq, 1 + tolerance)) return {};
  return grown;
}

Buckets<Index> neighbours_of_vertices(std::size_t vertices, std::span<const Edge> edges) {
  return gather<Index>(edges.size(), vertices, [&](std::size_t e, auto put) {
    const auto& [p, q] = edges[e];
    put(p, q);
    put(q, p);
  });
}

/// Vertices whose neighbours must be checked, smallest sizes first: as in Dijkstra's shortest paths, what they require
/// is final or almost final. Ties go to the smaller id.
class Queue {
public:
  explicit Queue(std::size_t vertices) : key_(vertices, absent) {}

  void push(Index v, const Sym3& m) {
    const double key = m[0] + m[3] + m[5];
    if (key == key_[v]) return;
    key_[v] = key;
    heap_.push({key, v});
  }

  /// `none` if empty. Entries that a later push has replaced are skipped.
  Index pop() {
    while (!heap_.empty()) {
      const Entry top = heap_.top();
      heap_.pop();
      if (key_[top.vertex] != top.key) continue;
      key_[top.vertex] = absent;
      return top.vertex;
    }
    return none;
  }

private:
  static constexpr double absent = -1;
  struct Entry {
    double key;
    Index vertex;
    bool operator<(const Entry& other) const { return key != other.key ? key < other.key : vertex > other.vertex; }
  };
  std::vector<double> key_;
  std::priority_queue<Entry> heap_;
};

/// Starts with only the vertices that require something of a neighbour: where the field is smooth, one scan of the
/// edges is enough.
Queue vertices_that_ask(std::span<const Point> points, std::span<const Edge> edges, std::span<const Sym3> metrics,
                        double log_beta) {
  const auto asking = collect_in_order<Index>(Chunks(edges.size()), [&](std::vector<Index>& list, std::size_t e) {
    const auto& [p, q] = edges[e];
    if (demand(points[p], points[q], metrics[p], metrics[q], log_beta)) list.push_back(p);
    if (demand(points[q], points[p], metrics[q], metrics[p], log_beta)) list.push_back(q);
  });
  Queue queue(points.size());
  for (Index v : asking) queue.push(v, metrics[v]);
  return queue;
}

}  // namespace

std::vector<Sym3> gradate(std::span<const Point> points, std::span<const Edge> edges, std::vector<Sym3> metrics,
                          double beta) {
  assert(points.size() == metrics.size() && beta > 1);
  const double log_beta = std::log(beta);
  Queue queue = vertices_that_ask(points, edges, metrics, log_beta);
  Index p = queue.pop();
  if (p == none) return metrics;
  const auto neighbours = neighbours_of_vertices(points.size(), edges);
  for (std::size_t effort = largest_effort * points.size(); p != none && effort > 0; p = queue.pop(), --effort) {
    for (Index q : neighbours[p]) {
      const auto wish = demand(points[p], points[q], metrics[p], metrics[q], log_beta);
      if (!wish) continue;
      metrics[q] = intersect(metrics[q], *wish);
      queue.push(q, metrics[q]);
    }
  }
  return metrics;
}

}  // namespace taut
