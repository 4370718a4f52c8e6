#include "taut/adapt.hpp"

#include <utility>

#include "adapt/block_passes.hpp"
#include "adapt/result.hpp"
#include "adapt/setup.hpp"
#include "base/parallel.hpp"
#include "mesh/order.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

class Adaptation {
public:
  Adaptation(Problem& problem, const AdaptOptions& options, Report& report)
      : mesh_(problem.mesh), passes_(problem, options.block_size), options_(options), report_(report) {}

  void run() {
    tets_when_ordered_ = mesh_.tet_count();
    Gain gain;
    for (round_ = 0; round_ < options_.passes && !report_.cancelled; ++round_) {
      const Gain last = std::exchange(gain, round());
      ++report_.rounds;
      if (is_disordered(gain)) put_in_order();
      if (round_ > 0 && is_settled(gain, last)) break;
    }
    round_ = static_cast<int>(report_.rounds) - 1;
    if (round_ >= 0) pass(passes_.tallies().repair, [&] { passes_.mend({}); });
    put_in_order();
    for (const Tally* tally : passes_.tallies().all()) report_.passes.push_back(tally->report());
    report_.blocks = passes_.block_count();
    report_.seconds.emplace_back("cut", passes_.cut_seconds());
    report_.seconds.emplace_back("order", order_seconds_);
  }

private:
  struct Gain {
    double changed = 0;     ///< vertices made and removed, as a share of the tetrahedra
    double efficiency = 0;  ///< of log tau, by moving vertices
  };

  // While the mesh still grows, swaps mend what is bad only: what is fair will change anyway. Then they follow every
  // second relocation, which gives the vertices time to settle between two changes of topology.
  Gain round() {
    const Tallies& done = passes_.tallies();
    const Tallies before = done;
    passes_.cut();
    pass(done.insertion, [&] { passes_.insert({}); });
    pass(done.collapse, [&] { passes_.collapse({}); });
    const auto tets = static_cast<double>(passes_.tet_count());
    const double changed = static_cast<double>(done.changed() - before.changed()) / tets;
    const bool grows = changed > growing_;
    if (grows || round_ % 2 == 0) pass(done.edge_swap, [&] { passes_.swap({.good_enough = grows ? 0.6 : 0.8}); });
    if (!grows) pass(done.repair, [&] { passes_.repair({}); });
    pass(done.relocation, [&] { passes_.relocate({}); });
    passes_.close();
    return {changed, (done.efficiency_gain - before.efficiency_gain) / (edges_per_tet_ * tets)};
  }

  // While the mesh grows order is restored now and then, and once more for the long rounds in which it grows no longer.
  [[nodiscard]] bool is_disordered(const Gain& gain) const {
    const double growth = static_cast<double>(mesh_.tet_count()) / static_cast<double>(tets_when_ordered_);
    return growth > (gain.changed > growing_ ? 1.5 : 1.1);
  }

  [[nodiscard]] bool is_settled(const Gain& gain, const Gain& last) const {
    return gain.changed < settled_changes_ && gain.efficiency + last.efficiency < 2 * settled_efficiency_;
  }

  template <class Work>
  void pass(const Tally& tally, Work work) {
    if (report_.cancelled) return;
    const std::size_t before = tally.accepted();
    work();
    if (!options_.progress) return;
    report_.cancelled = !options_.progress(
        {round_, tally.name(), passes_.vertex_count(), passes_.tet_count(), tally.accepted() - before});
  }

  void put_in_order() {
    const Stopwatch watch;
    reorder(mesh_);
    tets_when_ordered_ = mesh_.tet_count();
    order_seconds_ += watch.seconds();
  }

  static constexpr double growing_ = 0.05;  // vertices made and removed in a round, as a share of the tetrahedra
  static constexpr double settled_changes_ = 0.002;  // below these a round gains less than it costs
  static constexpr double settled_efficiency_ = 2e-4;
  static constexpr double edges_per_tet_ = 1.19;  // of a mesh of good tetrahedra with some boundary

  TetMesh& mesh_;
  BlockPasses passes_;
  const AdaptOptions& options_;
  Report& report_;
  int round_ = 0;
  std::size_t tets_when_ordered_ = 0;
  double order_seconds_ = 0;
};

AdaptResult adapt_here(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  AdaptResult result;
  result.report.threads = worker_count();
  Problem problem = set_up(mesh, metric, options, result.report);
  Adaptation(problem, options, result.report).run();
  problem.target.reset();
  const Stopwatch watch;
  assemble(problem, mesh, result);
  result.report.seconds.emplace_back("result", watch.seconds());
  return result;
}

}  // namespace

AdaptResult adapt(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  require_options(options);
  AdaptResult result;
  on_threads(options.threads, [&] { result = adapt_here(mesh, metric, options); });
  return result;
}

}  // namespace taut
