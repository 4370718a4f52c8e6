#include "sizing/gradation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/buckets.hpp"
#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/edges.hpp"
#include "mesh/neighbourhood.hpp"
#include "metric/field.hpp"
#include "metric/intersection.hpp"
#include "sizing/growth.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using Edge = std::array<Index, 2>;

/// Bound on the number of visits, as a multiple of the vertices. Intersections of metrics in oblique directions may
/// have smaller sizes than either metric, so there is no proof that the corrections end; in practice, they end after a
/// few multiples.
constexpr std::size_t largest_effort = 200;

/// Range of the traces of the metrics that demand in the same round: sizes differ by up to a factor of 8. Without a
/// limit, coarse vertices would demand before their own metrics are final, and hard fields would take up to twice as
/// long; with a narrow one, rounds would be too small to share among threads.
constexpr double band = 64;

constexpr std::size_t vertices_per_task = 512;

double trace(const Sym3& m) {
  return m[0] + m[3] + m[5];
}

/// An order of tensors that does not depend on the ids of vertices.
bool is_stronger(const Sym3& a, const Sym3& b) {
  return trace(a) != trace(b) ? trace(a) > trace(b) : a > b;
}

/// Rounds in which some vertices demand and all their neighbours answer, from the metrics before the round, so that
/// the vertices can answer in any order. As in Dijkstra's shortest paths, the smallest sizes demand first: what they
/// demand is almost final.
class Grading {
public:
  Grading(std::span<const Point> points, std::span<const Edge> edges, std::vector<Sym3> metrics,
          const Gradation& gradation)
      : points_(points),
        growth_(gradation),
        metrics_(std::move(metrics)),
        neighbours_(neighbours_of_vertices(edges, points.size())),
        place_(points.size(), none),
        is_waiting_(points.size(), false),
        is_asked_(points.size(), false) {}

  std::vector<Sym3> run() {
    for (const Index v : vertices_that_demand()) wait(v);
    std::size_t visits = 0;
    while (!waiting_.empty() && visits < largest_effort * points_.size()) {
      choose_demanding();
      compute_spectra();
      visits += demanding_.size();
      find_asked();
      take(answers());
    }
    return std::move(metrics_);
  }

private:
  // Where the field is smooth, these are few, and finding them is nearly all of the work.
  [[nodiscard]] std::vector<Index> vertices_that_demand() const {
    const auto add = [&](std::vector<Index>& list, std::size_t p) {
      if (demands_anything(static_cast<Index>(p))) list.push_back(static_cast<Index>(p));
    };
    return collect_in_order<Index>(Chunks(points_.size(), vertices_per_task), add);
  }

  [[nodiscard]] bool demands_anything(Index p) const {
    const auto is_unmet = [&](Index q) {
      return !growth_.surely_met(metrics_[p], metrics_[q], points_[q] - points_[p]);
    };
    const auto near = neighbours_[p];
    const auto first = std::ranges::find_if(near, is_unmet);
    if (first == near.end()) return false;
    const Spectrum s = spectrum(metrics_[p]);
    return std::any_of(first, near.end(), [&](Index q) {
      return is_unmet(q) && !meets(metrics_[q], growth_.demand(s, points_[q] - points_[p]));
    });
  }

  void wait(Index v) {
    if (is_waiting_[v]) return;
    is_waiting_[v] = true;
    waiting_.push_back(v);
  }

  // The smallest sizes leave those that wait.
  void choose_demanding() {
    double largest = 0;
    for (const Index v : waiting_) largest = std::max(largest, trace(metrics_[v]));
    const auto waits_on = [&](Index v) { return trace(metrics_[v]) < largest / band; };
    const auto chosen = std::partition(waiting_.begin(), waiting_.end(), waits_on);
    demanding_.assign(chosen, waiting_.end());
    waiting_.erase(chosen, waiting_.end());
    for (std::size_t i = 0; i < demanding_.size(); ++i) {
      is_waiting_[demanding_[i]] = false;
      place_[demanding_[i]] = static_cast<std::uint32_t>(i);
    }
  }

  void compute_spectra() {
    spectra_.resize(demanding_.size());
    const Chunks chunks(demanding_.size(), vertices_per_task);
    for_each_task(chunks.size(), [&](std::size_t chunk, int) {
      for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i)
        spectra_[i] = spectrum(metrics_[demanding_[i]]);
    });
  }

  void find_asked() {
    asked_.clear();
    for (const Index p : demanding_) {
      for (const Index q : neighbours_[p]) {
        if (is_asked_[q]) continue;
        is_asked_[q] = true;
        asked_.push_back(q);
      }
    }
  }

  [[nodiscard]] std::vector<Sym3> answers() const {
    std::vector<Sym3> all(asked_.size());
    const Chunks chunks(asked_.size(), vertices_per_task);
    for_each_task(chunks.size(), [&](std::size_t chunk, int) {
      std::vector<Sym3> demands;
      for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i) {
        collect_demands(asked_[i], demands);
        all[i] = answer(metrics_[asked_[i]], demands);
      }
    });
    return all;
  }

  void collect_demands(Index q, std::vector<Sym3>& demands) const {
    demands.clear();
    for (const Index p : neighbours_[q]) {
      if (place_[p] == none) continue;
      const Vec3 e = points_[q] - points_[p];
      if (growth_.surely_met(metrics_[p], metrics_[q], e)) continue;
      const Sym3 demand = growth_.demand(spectra_[place_[p]], e);
      if (!meets(metrics_[q], demand)) demands.push_back(demand);
    }
  }

  // The strongest demand first: it often meets the others, and each intersection in oblique directions costs size.
  [[nodiscard]] static Sym3 answer(Sym3 m, std::vector<Sym3>& demands) {
    std::ranges::sort(demands, is_stronger);
    for (const Sym3& demand : demands)
      if (!meets(m, demand)) m = intersect(m, demand);
    return m;
  }

  void take(const std::vector<Sym3>& answers) {
    for (const Index p : demanding_) place_[p] = none;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const Index q = asked_[i];
      is_asked_[q] = false;
      if (answers[i] == metrics_[q]) continue;
      metrics_[q] = answers[i];
      wait(q);
    }
  }

  std::span<const Point> points_;
  Growth growth_;
  std::vector<Sym3> metrics_;
  Buckets<Index> neighbours_;
  std::vector<Index> waiting_;  ///< their metrics have changed since they last demanded
  std::vector<Index> demanding_;
  std::vector<Spectrum> spectra_;     ///< by place in `demanding_`
  std::vector<Index> asked_;          ///< the neighbours of `demanding_`
  std::vector<std::uint32_t> place_;  ///< of each vertex in `demanding_`, or `none`
  std::vector<bool> is_waiting_, is_asked_;
};

}  // namespace

void require_gradation(const Gradation& g) {
  if (!(g.beta > 1 && std::isfinite(g.beta)))
    throw InputError(fmt::format("gradation: beta {} found, expected a number above 1", g.beta));
  if (!(g.mix >= 0 && g.mix <= 1)) throw InputError(fmt::format("gradation: mix {} found, expected 0 to 1", g.mix));
}

std::vector<Sym3> gradate(std::span<const Point> points, std::span<const Edge> edges, std::vector<Sym3> metrics,
                          const Gradation& gradation) {
  assert(points.size() == metrics.size() && gradation.beta > 1);
  return Grading(points, edges, std::move(metrics), gradation).run();
}

Tensors gradate(const Mesh& mesh, Tensors metric, const Gradation& gradation) {
  require_gradation(gradation);
  require_sound_arrays(mesh);
  return gradate(mesh.points, edges_of(mesh.tetrahedra), tensors_at(mesh, std::move(metric)), gradation);
}

}  // namespace taut
