#include "adapt/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/block_passes.hpp"
#include "base/stopwatch.hpp"
#include "geometry/off_surface.hpp"
#include "mesh/order.hpp"
#include "operators/snap.hpp"

namespace taut {
namespace {

// Vertices made and removed in a round, as a share of the tetrahedra, above which the mesh still grows.
constexpr double growing = 0.05;

// What a round gains less than it costs: vertices made and removed as above, and the gain of log tau.
constexpr double settled_changes = 0.002, settled_efficiency = 2e-4;

// 1/Q up to which swaps are tried. What is fair will change anyway while the mesh grows.
constexpr double swapped_while_growing = 0.6, swapped_at_rest = 0.8;

// Growth since the mesh was put in order after which that is worth its time: while it grows, and once more after that
// for the long rounds in which it grows no longer.
constexpr double disorder_while_growing = 1.5, disorder_at_rest = 1.1;

// Rounds go in circles if each changes more than this, the last one not clearly less than the one before last, and if
// the vertices that came and went in two rounds cancel out up to a share. Swaps come every second round: so do the
// rounds compared.
constexpr double circling = 0.01, still_changing = 0.8, cancelled_out = 0.25;
constexpr int circles_allowed = 4;  // they still mend the worst elements

constexpr int snaps = 8;  // sweeps at a time over the vertices that are off their surface

constexpr double edges_per_tet = 1.19;  // of a mesh of good tetrahedra with some boundary

class Rounds {
public:
  Rounds(Session& session, const RoundRules& rules, const ProgressCallback& progress, Report& report)
      : session_(session),
        mesh_(session.mesh),
        passes_(session, rules.block_size),
        rules_(rules),
        progress_(progress),
        report_(report) {}

  void run() {
    tets_when_ordered_ = mesh_.tet_count();
    if (!report_.cancelled) snap_to_surface();
    Gain gain, last, before_last;
    int circles = 0;
    for (round_ = 0; round_ < rules_.most && !report_.cancelled; ++round_) {
      before_last = std::exchange(last, std::exchange(gain, round()));
      ++report_.rounds;
      if (report_.off_surface > 0) snap_to_surface();
      if (is_disordered(gain)) put_in_order();
      if (round_ > 0 && is_settled(gain, last)) break;
      circles = round_ > 2 && goes_in_circles(gain, last, before_last) ? circles + 1 : 0;
      if (circles == circles_allowed) break;
    }
    round_ = static_cast<int>(report_.rounds) - 1;
    if (round_ >= 0 && rules_.passes.repair) pass(passes_.tallies().repair, [&] { passes_.mend(repair_rules()); });
    report_.off_surface = vertices_off_surface(mesh_, session_.model).size();
    put_in_order();
    add_to_report();
  }

private:
  struct Gain {
    double changed = 0;     ///< vertices inserted and removed, as a share of the tetrahedra
    double grown = 0;       ///< what is left of that: vertices more than before, as a share of the tetrahedra
    double efficiency = 0;  ///< gain in log tau by relocation
  };

  // At rest, swaps that follow every second relocation only give the vertices time to settle between two changes of
  // topology.
  Gain round() {
    const Tallies& done = passes_.tallies();
    const Tallies before = done;
    const PassChoice& chosen = rules_.passes;
    passes_.cut(chosen.insertion);
    const auto vertices = static_cast<double>(passes_.vertex_count());
    if (chosen.insertion) pass(done.insertion, [&] { passes_.insert({}); });
    if (chosen.collapse) pass(done.collapse, [&] { passes_.collapse({}); });
    const auto tets = static_cast<double>(passes_.tet_count());
    const double changed = static_cast<double>(done.changed() - before.changed()) / tets;
    const bool grows = changed > growing;
    const SwapRules swap{.good_enough = grows ? swapped_while_growing : swapped_at_rest};
    if (chosen.swap && (grows || round_ % rules_.swap_period == 0)) pass(done.swap, [&] { passes_.swap(swap); });
    if (chosen.repair && !grows) pass(done.repair, [&] { passes_.repair(repair_rules()); });
    if (chosen.relocation) pass(done.relocation, [&] { passes_.relocate({}); });
    passes_.close();
    const double grown = (static_cast<double>(passes_.vertex_count()) - vertices) / tets;
    return {changed, grown, (done.efficiency_gain - before.efficiency_gain) / (edges_per_tet * tets)};
  }

  // A vertex that must not go all the way may once its neighbours have gone, or once the mesh around it is another one.
  void snap_to_surface() {
    std::vector<VertexId> off = vertices_off_surface(mesh_, session_.model);
    Block whole;
    Kernel kernel{.mesh = mesh_, .model = session_.model, .target = *session_.target, .block = &whole};
    for (int i = 0; i < snaps && !off.empty(); ++i) {
      const auto moved = std::ranges::count_if(off, [&](VertexId v) { return snap(kernel, v) == Outcome::accepted; });
      if (moved == 0) break;
      off = vertices_off_surface(mesh_, session_.model);
    }
    report_.off_surface = off.size();
  }

  [[nodiscard]] RepairRules repair_rules() const {
    return {.may_collapse = rules_.passes.collapse, .may_insert = rules_.passes.insertion};
  }

  [[nodiscard]] bool is_disordered(const Gain& gain) const {
    const double growth = static_cast<double>(mesh_.tet_count()) / static_cast<double>(tets_when_ordered_);
    return growth > (gain.changed > growing ? disorder_while_growing : disorder_at_rest);
  }

  [[nodiscard]] static bool is_settled(const Gain& gain, const Gain& last) {
    return gain.changed < settled_changes && gain.efficiency + last.efficiency < 2 * settled_efficiency;
  }

  // Where a frozen surface forbids unit edges, what one pass makes another undoes, for ever.
  [[nodiscard]] static bool goes_in_circles(const Gain& gain, const Gain& last, const Gain& before_last) {
    const double least = std::min({gain.changed, last.changed, before_last.changed});
    return least > circling && gain.changed > still_changing * before_last.changed &&
           std::abs(gain.grown + last.grown) < cancelled_out * (gain.changed + last.changed);
  }

  template <class Work>
  void pass(const Tally& tally, Work work) {
    if (report_.cancelled) return;
    const std::size_t before = tally.accepted();
    work();
    if (!progress_) return;
    report_.cancelled =
        !progress_({round_, tally.name(), passes_.vertex_count(), passes_.tet_count(), tally.accepted() - before});
  }

  void put_in_order() {
    const Stopwatch watch;
    reorder(mesh_);
    tets_when_ordered_ = mesh_.tet_count();
    order_seconds_ += watch.seconds();
  }

  void add_to_report() {
    for (const Tally* tally : passes_.tallies().all()) report_.passes.push_back(tally->report());
    report_.blocks = passes_.block_count();
    report_.seconds.emplace_back("cut", passes_.cut_seconds());
    report_.seconds.emplace_back("order", order_seconds_);
  }

  Session& session_;
  TetMesh& mesh_;
  BlockPasses passes_;
  const RoundRules& rules_;
  const ProgressCallback& progress_;
  Report& report_;
  int round_ = 0;
  std::size_t tets_when_ordered_ = 0;
  double order_seconds_ = 0;
};

}  // namespace

void run_rounds(Session& session, const RoundRules& rules, const ProgressCallback& progress, Report& report) {
  Rounds(session, rules, progress, report).run();
}

}  // namespace taut
