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

// Under a surface that stays, slivers remain that nothing can repair.
TEST(RepairPass, DoesNotComeBackToWhatItCannotRepair) {
  Mesh input = test::cube(4);
  test::jitter(input, 0.06, 1);
  Workbench bench(input, test::random_field(input, 0.3, 2), Surface::fixed);
  bench.block.give_back(bench.mesh);
  const auto sweep = [&] {
    Block whole;
    std::vector<TetId> all;
    for (const TetId t : bench.mesh.tet_ids())
      if (bench.mesh.tets[t].alive()) all.push_back(t);
    whole.tets = IdPool<TetId>(all, all.size());
    whole.borrow(bench.mesh, {.tets = 50, .triangles = 50});
    bench.kernel.block = &whole;
    Tally tally("repair");
    repair_pass(bench.kernel, {.may_insert = false}, tally);
    whole.give_back(bench.mesh);
    return tally.report();
  };
  PassReport report = sweep();
  EXPECT_GT(report.tried, report.accepted);
  for (int i = 0; i < 30 && report.accepted > 0; ++i) report = sweep();
  EXPECT_EQ(report.accepted, 0);
  EXPECT_EQ(sweep().tried, 0);
}

}  // namespace
}  // namespace taut
