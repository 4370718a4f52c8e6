#include "adapt/passes.hpp"

#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Workbench;

TEST(SplitStuck, PassesOverWhatIsGone) {
  const Mesh input = test::cube(2);
  Workbench bench(input, Sizes(input.points.size(), 0.1));
  bench.block.give_back(bench.mesh);
  std::vector<TetId> stuck;
  for (const TetId t : ids<TetId>(bench.mesh.tets.size())) stuck.push_back(t);
  EXPECT_FALSE(bench.mesh.tets.back().alive()) << "borrowed and given back";
  Tally tally("insert");
  split_stuck(bench.kernel, {}, stuck, tally);
  EXPECT_GT(tally.accepted(), 10);
  EXPECT_EQ(first_broken_invariant(bench.mesh), "");
}

}  // namespace
}  // namespace taut
