#include "operators/repair.hpp"

#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Attempts;
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
      Attempts trial(bench);
      double worst = worst_of(bench.mesh);
      for (const TetId t : ids<TetId>(bench.mesh.tets.size())) {
        if (testing::Test::HasFatalFailure()) return;
        if (!bench.mesh.tets[t].alive() || bench.mesh.tets[t].state.quality > 0.5F) continue;
        const Outcome outcome = trial([&] { return repair(bench.kernel, t, {}); });
        const double now = worst_of(bench.mesh);
        EXPECT_GE(now, worst - 1e-7);
        EXPECT_TRUE(outcome == Outcome::accepted || now == worst);
        worst = now;
      }
      accepted += trial.count[Outcome::accepted];
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
  Attempts trial(bench);
  for (int sweep = 0; sweep < 4; ++sweep)
    for (const TetId t : ids<TetId>(bench.mesh.tets.size()))
      if (bench.mesh.tets[t].alive() && bench.mesh.tets[t].state.quality < 0.4F)
        (void)trial([&] { return repair(bench.kernel, t, {}); });
  EXPECT_GT(worst_of(bench.mesh), 0.3);
}

TEST(Repair, SwapsEdgesWhereNoVertexMayMove) {
  Mesh input = test::disturbed_domains()[0];
  for (Index p = 0; p < input.points.size(); ++p) input.required_points.push_back(p);
  Workbench bench(input, test::random_field(input, 0.6, 1));
  Attempts trial(bench);
  const std::vector<Vertex> before = bench.mesh.vertices;
  const auto vertices = test::living_vertices(bench.mesh);
  for (const TetId t : ids<TetId>(bench.mesh.tets.size()))
    if (bench.mesh.tets[t].alive()) (void)trial([&] { return repair(bench.kernel, t, {.may_insert = false}); });
  EXPECT_GT(trial.count[Outcome::accepted], 10);
  EXPECT_EQ(test::living_vertices(bench.mesh), vertices);
  for (const VertexId v : vertices) EXPECT_EQ(bench.mesh.x(v), before[v].x);
}

/// Between the triangles of a surface that stays there are slivers which have no vertex to lift.
TEST(Repair, GivesSliversOfASurfaceAVertexInside) {
  const auto repaired = [](bool may_insert) {
    Mesh input = test::cube(4);
    test::jitter(input, 0.06, 1);
    Workbench bench(input, test::random_field(input, 0.6, 2), Surface::fixed);
    Attempts trial(bench);
    const std::size_t before = test::living_vertices(bench.mesh).size();
    for (const TetId t : ids<TetId>(bench.mesh.tets.size()))
      if (bench.mesh.tets[t].alive() && bench.mesh.tets[t].state.quality < 0.4F)
        (void)trial([&] { return repair(bench.kernel, t, {.may_collapse = false, .may_insert = may_insert}); });
    return std::pair{test::living_vertices(bench.mesh).size() - before, trial.count[Outcome::accepted]};
  };
  const auto with = repaired(true), without = repaired(false);
  EXPECT_GT(with.first, 3);
  EXPECT_EQ(without.first, 0);
  EXPECT_GT(with.second, without.second);
}

}  // namespace
}  // namespace taut
