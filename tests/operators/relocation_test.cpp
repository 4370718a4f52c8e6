#include "operators/relocation.hpp"

#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Attempts;
using test::Workbench;

double worst_at(const TetMesh& mesh, VertexId v) {
  double worst = 1;
  for (TetId t : test::living_tets(mesh))
    if (mesh.tets[t].has(v)) worst = std::min(worst, test::quality_of(mesh, t));
  return worst;
}

// Everything except one vertex, the qualities of its tetrahedra and what follows from them.
void expect_only_moved(const TetMesh& mesh, const test::Snapshot& before, VertexId moved) {
  for (VertexId v : test::living_vertices(mesh)) {
    EXPECT_TRUE(v == moved || mesh.x(v) == before.mesh.vertices[v].x) << v << " while moving " << moved;
    EXPECT_TRUE(v == moved || mesh.vertices[v].m == before.mesh.vertices[v].m);
  }
  for (TetId t : test::living_tets(mesh)) {
    EXPECT_EQ(mesh.tets[t].v, before.mesh.tets[t].v);
    EXPECT_EQ(mesh.tets[t].n, before.mesh.tets[t].n);
    EXPECT_TRUE(mesh.tets[t].has(moved) || mesh.tets[t].state.quality == before.mesh.tets[t].state.quality);
  }
}

std::array<int, 4> relocate_everything(const Mesh& input, const Metric& metric, Surface surface) {
  Workbench bench(input, metric, surface);
  Attempts trial(bench);
  std::array<int, 4> moved{};
  for (int sweep = 0; sweep < 2; ++sweep) {
    for (VertexId v : test::living_vertices(bench.mesh)) {
      if (testing::Test::HasFatalFailure()) return moved;
      const test::Snapshot before(bench.mesh);
      const double old_worst = worst_at(bench.mesh, v);
      const std::uint32_t dimension = bench.mesh.tag_of_vertex[v].dimension();
      const Outcome outcome = trial([&] { return relocate(bench.kernel, v, {}); });
      EXPECT_TRUE(dimension > 0 || outcome == Outcome::geometry) << "a corner must stay";
      if (outcome != Outcome::accepted) {
        EXPECT_EQ(bench.mesh.state_of_vertex[v].restless, 0);
        continue;
      }
      moved[dimension] += bench.mesh.x(v) != before.mesh.vertices[v].x ? 1 : 0;  // not if the forces are in balance
      expect_only_moved(bench.mesh, before, v);
      EXPECT_GT(worst_at(bench.mesh, v), 0.85 * old_worst);
      CellId host = bench.mesh.host_of_vertex[v];
      EXPECT_LT(test::distance(bench.mesh.vertices[v].m, bench.target.at(bench.mesh.x(v), host)), 1e-9);
    }
  }
  return moved;
}

TEST(Relocation, InDisturbedDomains) {
  unsigned seed = 0;
  for (const Mesh& input : test::disturbed_domains()) {
    for (const Metric& metric :
         {Metric(Sizes(input.points.size(), 0.35)), Metric(test::random_field(input, 1, ++seed))}) {
      const auto moved = relocate_everything(input, metric, Surface::adapt);
      EXPECT_GT(moved[1], 0);
      EXPECT_GT(moved[2], 0);
      EXPECT_GT(moved[3], 0);
      EXPECT_EQ(moved[0], 0);
      const auto moved_inside = relocate_everything(input, metric, Surface::fixed);
      EXPECT_EQ(moved_inside[0] + moved_inside[1] + moved_inside[2], 0);
    }
  }
}

TEST(Relocation, SmoothsADisturbedGrid) {
  Mesh input = test::cube(5);
  test::jitter(input, 0.06, 1);
  Workbench bench(input, Sizes(input.points.size(), 0.25));
  const auto worst = [&] {
    double least = 1;
    for (VertexId v : test::living_vertices(bench.mesh)) least = std::min(least, worst_at(bench.mesh, v));
    return least;
  };
  const double before = worst();
  for (int sweep = 0; sweep < 8; ++sweep)
    for (VertexId v : test::living_vertices(bench.mesh)) (void)relocate(bench.kernel, v, {});
  EXPECT_GT(worst(), 1.3 * before);
}

TEST(Relocation, BringsAVertexToWhereItsEdgesAreUnit) {
  // The displaced centre of a regular octahedron: the forces make its six edges equal.
  Mesh input;
  input.points = {{0.2, -0.1, 0.15}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Index a : {1U, 2U})
    for (const Index b : {3U, 4U})
      for (const Index c : {5U, 6U})
        input.tetrahedra.push_back((a + b + c) % 2 == 1 ? std::array<Index, 4>{0, a, b, c}
                                                        : std::array<Index, 4>{0, b, a, c});
  test::add_triangles(input);
  Workbench bench(input, Sizes(7, 1.0), Surface::fixed);
  const auto& origins = bench.mesh.origin_of_vertex;
  const auto centre = static_cast<VertexId>(std::ranges::find(origins, 0) - origins.begin());
  const double before = norm(bench.mesh.x(centre));
  for (int i = 0; i < 60; ++i) (void)relocate(bench.kernel, centre, {});
  EXPECT_LT(norm(bench.mesh.x(centre)), 0.1 * before);
}

TEST(Relocation, RestsWhereNothingIsToBeGained) {
  Mesh input = test::cube(3);
  Workbench bench(input, Sizes(input.points.size(), 0.35));
  for (VertexId v : test::living_vertices(bench.mesh))
    EXPECT_NE(relocate(bench.kernel, v, {.good_enough = 0}), Outcome::accepted);
}

TEST(Relocation, LeavesTheRequiredAlone) {
  Mesh input = test::disturbed_domains()[0];
  input.required_points = {21, 22, 5};
  input.required_tetrahedra = {80};
  Workbench bench(input, test::random_field(input, 1, 2));
  for (int sweep = 0; sweep < 5; ++sweep)
    for (VertexId v : test::living_vertices(bench.mesh)) (void)relocate(bench.kernel, v, {});
  int moved = 0;
  for (VertexId v : test::living_vertices(bench.mesh)) {
    const Index p = bench.mesh.origin_of_vertex[v];
    const bool stays = std::ranges::count(input.required_points, p) + std::ranges::count(input.tetrahedra[80], p) > 0;
    EXPECT_TRUE(!stays || bench.mesh.x(v) == input.points[p]) << p;
    moved += bench.mesh.x(v) != input.points[p] ? 1 : 0;
  }
  EXPECT_GT(moved, 10);
}

}  // namespace
}  // namespace taut
