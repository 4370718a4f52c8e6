#include "adapt/block_passes.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"

namespace taut {

BlockPasses::BlockPasses(Session& session, std::size_t block_size) : block_size_(block_size), blocks_(session.mesh) {
  for (int i = 0; i < worker_count(); ++i) kernels_.push_back(Kernel{session.mesh, session.model, *session.target});
}

// Calls body(kernel, b) for each block b, after setting the kernel to this block. The largest blocks begin first, so
// that the end does not have to wait for one of them.
template <class Body>
void BlockPasses::for_each_block(Body body) {
  for_each_task(blocks_.size(), [&](std::size_t i, int worker) {
    const std::size_t b = largest_first_[i];
    Kernel& kernel = kernels_[static_cast<std::size_t>(worker)];
    kernel.block = &blocks_[b];
    body(kernel, b);
  });
}

// Calls pass(kernel, tallies, b) for each block b. The time goes to the tally `kind`.
template <class Pass>
void BlockPasses::run(Tally Tallies::*kind, Pass pass) {
  const Stopwatch watch;
  std::vector<Tallies> counted(blocks_.size());
  for_each_block([&](Kernel& kernel, std::size_t b) {
    const Stopwatch own;
    kernel.efficiency_gain = 0;
    pass(kernel, counted[b], b);
    counted[b].efficiency_gain = kernel.efficiency_gain;
    (counted[b].*kind).add_busy(own.seconds());
  });
  for (const Tallies& part : counted) tallies_ += part;
  (tallies_.*kind).add_seconds(watch.seconds());
}

void BlockPasses::cut(bool with_insertion) {
  const Stopwatch watch;
  blocks_.cut(block_size_, cuts_++);
  block_count_ = blocks_.size();
  tets_when_cut_ = tet_count();
  largest_first_.resize(blocks_.size());
  std::iota(largest_first_.begin(), largest_first_.end(), std::size_t{0});
  std::ranges::stable_sort(largest_first_, std::greater{}, [&](std::size_t b) { return blocks_[b].tets.size(); });
  std::vector<IdNeed> needs(blocks_.size());
  for_each_block([&](Kernel& kernel, std::size_t b) {
    needs[b] = with_insertion ? ids_for_insertion(kernel) : ids_for_swaps(kernel);
  });
  blocks_.lend(needs);
  cut_seconds_ += watch.seconds();
}

void BlockPasses::insert(const InsertionRules& rules) {
  std::vector<std::vector<TetId>> stuck_in(blocks_.size());
  run(&Tallies::insertion,
      [&](Kernel& k, Tallies& t, std::size_t b) { insertion_pass(k, rules, stuck_in[b], t.insertion); });
  std::vector<TetId> stuck;
  for (const auto& some : stuck_in) stuck.insert(stuck.end(), some.begin(), some.end());
  const bool has_grown = static_cast<double>(tet_count()) > cut_again_ * static_cast<double>(tets_when_cut_);
  if (stuck.empty() && !has_grown) return;
  close();
  if (!stuck.empty())
    alone(tallies_.insertion, [&](Kernel& kernel) { split_stuck(kernel, rules, stuck, tallies_.insertion); });
  cut();
}

// Calls work(kernel) for the whole mesh as one block.
template <class Work>
void BlockPasses::alone(Tally& tally, Work work) {
  const Stopwatch watch;
  Block whole;
  kernels_[0].block = &whole;
  work(kernels_[0]);
  tally.add_seconds(watch.seconds());
  tally.add_busy(watch.seconds());
}

void BlockPasses::collapse(const CollapseRules& rules) {
  run(&Tallies::collapse, [&](Kernel& k, Tallies& t, std::size_t) { collapse_pass(k, rules, t.collapse); });
}

void BlockPasses::swap(const SwapRules& rules) {
  run(&Tallies::swap, [&](Kernel& k, Tallies& t, std::size_t) { swap_pass(k, rules, t.swap); });
}

void BlockPasses::repair(const RepairRules& rules) {
  run(&Tallies::repair, [&](Kernel& k, Tallies& t, std::size_t) { repair_pass(k, rules, t.repair); });
}

void BlockPasses::mend(const RepairRules& rules) {
  alone(tallies_.repair, [&](Kernel& kernel) { taut::mend(kernel, rules, tallies_.repair); });
}

void BlockPasses::relocate(const RelocationRules& rules) {
  run(&Tallies::relocation, [&](Kernel& k, Tallies& t, std::size_t) { relocation_pass(k, rules, t.relocation); });
}

}  // namespace taut
