#include "taut/adapt.hpp"

#include <utility>

#include "adapt/passes.hpp"
#include "adapt/result.hpp"
#include "adapt/setup.hpp"
#include "mesh/order.hpp"

namespace taut {
namespace {

class Adaptation {
public:
  Adaptation(Problem& problem, const AdaptOptions& options, Report& report)
      : kernel_{problem.mesh, problem.model, *problem.target}, options_(options), report_(report) {}

  void run() {
    tets_when_ordered_ = kernel_.mesh.tet_count();
    Gain gain;
    for (round_ = 0; round_ < options_.passes && !report_.cancelled; ++round_) {
      const Gain last = std::exchange(gain, round());
      ++report_.rounds;
      if (is_disordered(gain)) put_in_order();
      if (round_ > 0 && is_settled(gain, last)) break;
    }
    put_in_order();
    for (const Tally* tally : {&insertion_, &collapse_, &edge_swap_, &face_swap_, &relocation_, &repair_})
      report_.passes.push_back(tally->report());
    report_.seconds.emplace_back("order", order_seconds_);
  }

private:
  struct Gain {
    double changed = 0;     ///< vertices made and removed, as a share of the tetrahedra
    double efficiency = 0;  ///< of log tau, by relocation
  };

  // While the mesh still grows, swaps mend what is bad only: what is fair will change anyway. Then they follow every
  // second relocation, which gives the vertices time to settle between two changes of topology.
  Gain round() {
    const std::size_t before = insertion_.accepted() + collapse_.accepted();
    kernel_.efficiency_gain = 0;
    pass(insertion_, [&] { insertion_pass(kernel_, {}, insertion_); });
    pass(collapse_, [&] { collapse_pass(kernel_, {}, collapse_); });
    const auto tets = static_cast<double>(kernel_.mesh.tet_count());
    const double changed = static_cast<double>(insertion_.accepted() + collapse_.accepted() - before) / tets;
    const bool grows = changed > growing_;
    if (grows || round_ % 2 == 0)
      pass(edge_swap_, [&] { swap_pass(kernel_, {.good_enough = grows ? 0.6 : 0.8}, edge_swap_, face_swap_); });
    if (!grows) pass(repair_, [&] { repair_pass(kernel_, {}, repair_); });
    pass(relocation_, [&] { relocation_pass(kernel_, {}, relocation_); });
    return {changed, kernel_.efficiency_gain / (edges_per_tet_ * tets)};
  }

  // While the mesh grows order is restored now and then, and once more for the long rounds in which it grows no longer.
  [[nodiscard]] bool is_disordered(const Gain& gain) const {
    const double growth = static_cast<double>(kernel_.mesh.tets.size()) / static_cast<double>(tets_when_ordered_);
    return growth > (gain.changed > growing_ ? 1.5 : 1.1);
  }

  [[nodiscard]] bool is_settled(const Gain& gain, const Gain& last) const {
    return gain.changed < settled_changes_ && gain.efficiency + last.efficiency < 2 * settled_efficiency_;
  }

  template <class Work>
  void pass(Tally& tally, Work work) {
    if (report_.cancelled) return;
    const Stopwatch watch;
    const std::size_t before = tally.accepted();
    work();
    tally.add_seconds(watch.seconds());
    if (!options_.progress) return;
    report_.cancelled = !options_.progress(
        {round_, tally.name(), kernel_.mesh.vertex_count(), kernel_.mesh.tet_count(), tally.accepted() - before});
  }

  void put_in_order() {
    const Stopwatch watch;
    reorder(kernel_.mesh);
    tets_when_ordered_ = kernel_.mesh.tet_count();
    order_seconds_ += watch.seconds();
  }

  static constexpr double growing_ = 0.05;  // vertices made and removed in a round, as a share of the tetrahedra
  static constexpr double settled_changes_ = 0.002;  // below these a round gains less than it costs
  static constexpr double settled_efficiency_ = 2e-4;
  static constexpr double edges_per_tet_ = 1.19;  // of a mesh of good tetrahedra with some boundary

  Kernel kernel_;
  const AdaptOptions& options_;
  Report& report_;
  int round_ = 0;
  std::size_t tets_when_ordered_ = 0;
  double order_seconds_ = 0;
  Tally insertion_{"insert"}, collapse_{"collapse"}, edge_swap_{"swap"}, face_swap_{"swap faces"},
      relocation_{"relocate"}, repair_{"repair"};
};

}  // namespace

AdaptResult adapt(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  AdaptResult result;
  Problem problem = set_up(mesh, metric, options, result.report);
  Adaptation(problem, options, result.report).run();
  problem.target.reset();
  const Stopwatch watch;
  assemble(problem, mesh, result);
  result.report.seconds.emplace_back("result", watch.seconds());
  return result;
}

}  // namespace taut
