// The passes of a round over a mesh cut into blocks: one kernel per thread, one task per block.
#pragma once

#include <vector>

#include "adapt/passes.hpp"
#include "adapt/session.hpp"
#include "adapt/tally.hpp"
#include "partition/blocks.hpp"

namespace taut {

/// Use: cut(), passes, close(). The counts of the passes are summed in the order of the blocks, so that every sum is
/// the same to the last bit on any number of threads.
class BlockPasses {
public:
  /// Blocks of about `block_size` vertices; 0: a single block.
  BlockPasses(Session& session, std::size_t block_size);

  /// Cuts the mesh, each time at new places, and hands out the ids that the passes will need, with insertion or
  /// without.
  void cut(bool with_insertion = true);
  void close() { blocks_.close(); }

  void insert(const InsertionRules& rules);
  void collapse(const CollapseRules& rules);
  void swap(const SwapRules& rules);
  void repair(const RepairRules& rules);
  void mend(const RepairRules& rules);  ///< after close()
  void relocate(const RelocationRules& rules);

  [[nodiscard]] const Tallies& tallies() const { return tallies_; }
  [[nodiscard]] std::size_t vertex_count() const { return blocks_.vertex_count(); }
  [[nodiscard]] std::size_t tet_count() const { return blocks_.tet_count(); }
  [[nodiscard]] std::size_t block_count() const { return block_count_; }  ///< of the last cut
  [[nodiscard]] double cut_seconds() const { return cut_seconds_; }

private:
  template <class Body>
  void for_each_block(Body body);
  template <class Pass>
  void run(Tally Tallies::*kind, Pass pass);
  template <class Work>
  void alone(Tally& tally, Work work);

  std::vector<Kernel> kernels_;  // of each worker
  std::size_t block_size_;
  Blocks blocks_;
  std::vector<std::size_t> largest_first_;  // of the blocks
  Tallies tallies_;
  static constexpr double cut_again_ = 1.3;  // growth that makes blocks too large
  unsigned cuts_ = 0;
  std::size_t tets_when_cut_ = 0;
  std::size_t block_count_ = 0;
  double cut_seconds_ = 0;
};

}  // namespace taut
