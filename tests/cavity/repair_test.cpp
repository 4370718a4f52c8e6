#include "cavity/repair.hpp"

#include "cavity/workbench.hpp"

namespace taut {
namespace {

using test::Trials;
using test::Workbench;

double worst_of(const TetMesh& mesh) {
  double worst = 1;
  for (TetId t : test::living_tets(mesh)) worst = std::min(worst, test::quality_of(mesh, t));
  return worst;
}

TEST(Repair, NeverMakesTheWorstWorse) {
  unsigned seed = 0;
  int accepted = 0;
  for (const Mesh& input : test::disturbed_domains()) {
    for (const Surface surface : {Surface::adapt, Surface::fixed}) {
      Workbench bench(input, test::random_field(input, 0.6, ++seed), surface);
      Trials trial(bench);
      double worst = worst_of(bench.mesh);
      for (TetId t = 0; t < bench.mesh.tets.size() && !testing::Test::HasFatalFailure(); ++t) {
        if (!bench.mesh.tets[t].alive() || bench.mesh.tets[t].quality > 0.5F) continue;
        const Refusal outcome = trial([&] { return repair(bench.kernel, t, {}); });
        const double now = worst_of(bench.mesh);
        EXPECT_GE(now, worst - 1e-7);
        EXPECT_TRUE(outcome == Refusal::accepted || now == worst);
        worst = now;
      }
      accepted += trial.count[Refusal::accepted];
    }
  }
  EXPECT_GT(accepted, 50);
}

TEST(Repair, RemovesASliver) {
  // A vertex inside a grid comes close to the plane of three neighbours: unit edges, hardly any volume.
  Mesh input = test::cube(3);
  const Index v = 16 + 4 + 1;
  input.points[v] = input.points[v] + Vec3{0.31, 0.02, 0.02};
  Workbench bench(input, Sizes(input.points.size(), 0.35));
  ASSERT_LT(worst_of(bench.mesh), 0.15);
  Trials trial(bench);
  for (int sweep = 0; sweep < 4; ++sweep)
    for (TetId t = 0; t < bench.mesh.tets.size() && !testing::Test::HasFatalFailure(); ++t)
      if (bench.mesh.tets[t].alive() && bench.mesh.tets[t].quality < 0.4F)
        (void)trial([&] { return repair(bench.kernel, t, {}); });
  EXPECT_GT(worst_of(bench.mesh), 0.3);
}

TEST(Repair, LeavesTheRequiredAlone) {
  Mesh input = test::disturbed_domains()[0];
  for (Index p = 0; p < input.points.size(); ++p) input.required_points.push_back(p);
  Workbench bench(input, test::random_field(input, 0.6, 1));
  Trials trial(bench);
  for (TetId t : test::living_tets(bench.mesh)) {
    const Refusal outcome = trial([&] { return repair(bench.kernel, t, {}); });
    EXPECT_NE(outcome, Refusal::accepted);
  }
}

}  // namespace
}  // namespace taut
