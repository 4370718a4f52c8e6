#include "operators/collapse.hpp"

#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Attempts;
using test::for_each_tet_edge;
using test::Workbench;

constexpr double infinity = std::numeric_limits<double>::infinity();
const CollapseRules anything_goes = {.longest_new_edge = infinity, .worst_quality = 1e-3, .share_of_old = 0};

// Which of the two vertices was removed; the other one is kept.
struct Merge {
  VertexId gone, kept;
};

Merge merge_of(const TetMesh& mesh, VertexId a, VertexId b) {
  EXPECT_NE(mesh.is_vertex_alive(a), mesh.is_vertex_alive(b));
  return mesh.is_vertex_alive(a) ? Merge{b, a} : Merge{a, b};
}

std::map<Outcome, int> collapse_everywhere(const Mesh& input, const Metric& metric, Surface surface,
                                           std::array<int, 4>& gone_of_dimension) {
  Workbench bench(input, metric, surface);
  Attempts trial(bench);
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    const VertexId a = bench.mesh.tets[t].v[edge_vertices[e][0]], b = bench.mesh.tets[t].v[edge_vertices[e][1]];
    const test::Snapshot before(bench.mesh);
    if (trial([&] { return collapse_edge(bench.kernel, t, e, anything_goes); }) != Outcome::accepted) return;
    EXPECT_EQ(test::living_vertices(bench.mesh).size(), before.living[0] - 1);
    EXPECT_LT(test::living_tets(bench.mesh).size(), before.living[1]);
    const auto [gone, kept] = merge_of(bench.mesh, a, b);
    EXPECT_EQ(bench.mesh.x(kept), before.mesh.vertices[kept].x);
    EXPECT_EQ(bench.mesh.tag_of_vertex[kept], before.mesh.tag_of_vertex[kept]);
    for (const Tet& tet : bench.mesh.tets) EXPECT_FALSE(tet.alive() && tet.has(gone));
    for (const Triangle& triangle : bench.mesh.triangles)
      EXPECT_FALSE(triangle.alive() && std::ranges::find(triangle.v, gone) != triangle.v.end());
    ++gone_of_dimension[before.mesh.tag_of_vertex[gone].dimension()];
  });
  return trial.count;
}

TEST(Collapse, OfDisturbedDomains) {
  unsigned seed = 0;
  for (const Mesh& mesh : test::disturbed_domains()) {
    for (const Metric& metric :
         {Metric(Sizes(mesh.points.size(), 1.0)), Metric(test::random_field(mesh, 0.5, ++seed))}) {
      std::array<int, 4> gone{};
      auto count = collapse_everywhere(mesh, metric, Surface::adapt, gone);
      EXPECT_GT(gone[3], 0);
      EXPECT_GT(gone[2], 0);
      EXPECT_GT(gone[1], 0);
      EXPECT_EQ(gone[0], 0) << "a corner was lost";
      EXPECT_GT(count[Outcome::geometry], 0);
      gone = {};
      count = collapse_everywhere(mesh, metric, Surface::fixed, gone);
      EXPECT_GT(gone[3], 0);
      EXPECT_EQ(gone[0] + gone[1] + gone[2], 0) << "a vertex of the fixed surface was lost";
    }
  }
}

TEST(Collapse, CoarsensACubeAsFarAsItsGeometryAllows) {
  // After repeating until nothing can be removed, no vertex is left on the lines: every edge of the cube is one edge of
  // the mesh.
  const Mesh input = test::cube(4);
  Workbench bench(input, Sizes(input.points.size(), 1.0));
  Attempts trial(bench);
  for (int before = -1; before != trial.count[Outcome::accepted] && !testing::Test::HasFatalFailure();) {
    before = trial.count[Outcome::accepted];
    for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
      (void)trial([&] { return collapse_edge(bench.kernel, t, e, anything_goes); });
    });
  }
  std::array<int, 4> left{};
  for (VertexId v : test::living_vertices(bench.mesh)) ++left[bench.mesh.tag_of_vertex[v].dimension()];
  EXPECT_EQ(left[0], 8);
  EXPECT_EQ(left[1], 0);
  EXPECT_LE(left[2] + left[3], 8) << "few of 125";
}

TEST(Collapse, NothingOfASingleBoxCanGo) {
  const Mesh input = test::cube(1);
  Workbench bench(input, Sizes(8, 10.0));
  Attempts trial(bench);
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    EXPECT_EQ(trial([&] { return collapse_edge(bench.kernel, t, e, anything_goes); }), Outcome::geometry);
  });
  EXPECT_EQ(trial.count[Outcome::geometry], 36);
}

double longest_edge_at(const Kernel& kernel, VertexId v) {
  double longest = 0;
  for (const Tet& tet : kernel.mesh.tets)
    for (int k = 0; k < 4 && tet.alive() && tet.has(v); ++k)
      if (tet.v[k] != v) longest = std::max(longest, kernel.length(v, tet.v[k]));
  return longest;
}

TEST(Collapse, HoldsToItsRules) {
  const Mesh input = test::disturbed_domains()[1];
  Workbench bench(input, test::random_field(input, 0.6, 7));
  const CollapseRules rules = {.longest_new_edge = 0.8, .worst_quality = 0.3, .share_of_old = 0.7};
  Attempts trial(bench);
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    const VertexId a = bench.mesh.tets[t].v[edge_vertices[e][0]], b = bench.mesh.tets[t].v[edge_vertices[e][1]];
    const double longest_at_a = longest_edge_at(bench.kernel, a), longest_at_b = longest_edge_at(bench.kernel, b);
    const test::Snapshot before(bench.mesh);
    if (trial([&] { return collapse_edge(bench.kernel, t, e, rules); }) != Outcome::accepted) return;
    const auto [gone, kept] = merge_of(bench.mesh, a, b);
    const double allowed = std::max(0.8, gone == a ? longest_at_a : longest_at_b) * (1 + 1e-12);
    float worst_old = 1;
    for (TetId old : bench.kernel.cavity.tets.span())
      worst_old = std::min(worst_old, before.mesh.tets[old].state.quality);
    for (TetId made : bench.kernel.cavity.made()) {
      EXPECT_GT(test::quality_of(bench.mesh, made), std::min(0.3, 0.7 * worst_old) - 1e-6);
      for (VertexId v : bench.mesh.tets[made].v) EXPECT_TRUE(v == kept || bench.kernel.length(kept, v) <= allowed);
    }
  });
  EXPECT_GT(trial.count[Outcome::accepted], 5);
  EXPECT_GT(trial.count[Outcome::long_edge], 5);
  EXPECT_GT(trial.count[Outcome::quality], 5);
}

// The vertices of these points after removing all that can be removed.
std::vector<bool> survive(const Mesh& input, const std::vector<Index>& points) {
  Workbench bench(input, Sizes(input.points.size(), 10.0));
  Attempts trial(bench);
  for (int sweep = 0; sweep < 3; ++sweep)
    for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
      (void)trial([&] { return collapse_edge(bench.kernel, t, e, anything_goes); });
    });
  EXPECT_GT(trial.count[Outcome::accepted], 0);
  std::vector<bool> alive(points.size(), false);
  for (VertexId v : test::living_vertices(bench.mesh))
    for (std::size_t i = 0; i < points.size(); ++i)
      if (bench.mesh.origin_of_vertex[v] == points[i]) {
        alive[i] = true;
        EXPECT_EQ(bench.mesh.x(v), input.points[points[i]]);
      }
  return alive;
}

TEST(Collapse, LeavesTheRequiredAlone) {
  // Points of the grid of 3^3 boxes are numbered 16 i + 4 j + k: 1 and 2 on a line, 5 and 6 on a side, the rest inside.
  const std::vector<Index> watched = {1, 2, 5, 6, 21, 22};
  const std::vector<bool> all(6, true);
  Mesh mesh = test::cube(3);
  EXPECT_NE(survive(mesh, watched), all);
  mesh.required_points = watched;
  EXPECT_EQ(survive(mesh, watched), all);
  mesh.required_points.clear();
  mesh.corners = watched;
  EXPECT_EQ(survive(mesh, watched), all);
  mesh.corners.clear();
  mesh.edges = {{1, 2}, {5, 6}, {21, 22}};
  mesh.required_edges = {0, 1, 2};
  EXPECT_EQ(survive(mesh, watched), all);
}

TEST(Collapse, NeedsAnEdgeAlongTheGeometry) {
  // Vertices 5 and 6 on the side x = 0 may merge; neither may move to 22, inside, though 22 may come to them.
  const Mesh input = test::cube(3);
  Workbench bench(input, Sizes(input.points.size(), 1.0));
  for (TetId t : test::living_tets(bench.mesh))
    for (int e = 0; e < 6; ++e) {
      Workbench fresh(input, Sizes(input.points.size(), 1.0));
      const auto origin = [&](int k) { return fresh.mesh.origin_of_vertex[fresh.mesh.tets[t].v[edge_vertices[e][k]]]; };
      if (std::minmax({origin(0), origin(1)}) != std::pair<Index, Index>{6, 22}) continue;
      const auto before = test::living_vertices(fresh.mesh);
      ASSERT_EQ(collapse_edge(fresh.kernel, t, e, anything_goes), Outcome::accepted);
      EXPECT_EQ(std::ranges::count(fresh.mesh.origin_of_vertex, Index{6}), 1);
      for (VertexId v : before) EXPECT_EQ(fresh.mesh.is_vertex_alive(v), fresh.mesh.origin_of_vertex[v] != 22);
      return;
    }
  ADD_FAILURE() << "no edge from 6 to 22";
}

}  // namespace
}  // namespace taut
