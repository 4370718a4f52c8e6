#include "operators/insertion.hpp"

#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Attempts;
using test::for_each_tet_edge;
using test::Workbench;

// Whether the two vertices still share a tetrahedron.
bool is_edge(const TetMesh& mesh, VertexId a, VertexId b) {
  return std::ranges::any_of(mesh.tets, [&](const Tet& t) { return t.alive() && t.has(a) && t.has(b); });
}

void expect_in_the_middle(const Workbench& bench, VertexId a, VertexId b, VertexId p) {
  const TetMesh& mesh = bench.mesh;
  EXPECT_TRUE(mesh.is_vertex_alive(p));
  EXPECT_LT(norm(mesh.x(p) - 0.5 * (mesh.x(a) + mesh.x(b))), 1e-14);
  EXPECT_EQ(mesh.origin_of_vertex[p], none);
  CellId host{0};
  EXPECT_LT(test::distance(mesh.vertices[p].m, bench.target.at(mesh.x(p), host)), 1e-9);
  EXPECT_FALSE(is_edge(mesh, a, b));
}

// Where the middle of an edge lies on the geometry, found from all triangles.
Tag tag_of_edge(const TetMesh& mesh, VertexId a, VertexId b) {
  Tag tag;
  for (const Triangle& t : mesh.triangles) {
    if (!t.alive()) continue;
    for (int k = 0; k < 3; ++k) {
      const VertexId c = t.v[(k + 1) % 3], d = t.v[(k + 2) % 3];
      if ((a == c && b == d) || (a == d && b == c))
        tag = t.line[k] != none ? Tag::on_line(t.line[k]) : Tag::on_patch(t.patch);
    }
  }
  return tag;
}

void insert_everywhere(const Mesh& input, const Metric& metric, Surface surface, int most) {
  Workbench bench(input, metric, surface);
  Attempts trial(bench);
  std::array<int, 4> inserted{};
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    if (trial.count[Outcome::accepted] >= most) return;
    const VertexId a = bench.mesh.tets[t].v[edge_vertices[e][0]], b = bench.mesh.tets[t].v[edge_vertices[e][1]];
    const VertexId p = bench.block.vertices.next();
    const Tag tag = tag_of_edge(bench.mesh, a, b);
    const std::size_t vertices = test::living_vertices(bench.mesh).size();
    const Outcome outcome = trial([&] { return insert_on_edge(bench.kernel, t, e, {}); });
    EXPECT_EQ(test::living_vertices(bench.mesh).size(), vertices + (outcome == Outcome::accepted ? 1 : 0));
    if (outcome != Outcome::accepted) return;
    expect_in_the_middle(bench, a, b, p);
    EXPECT_EQ(bench.mesh.tag_of_vertex[p], tag);
    EXPECT_TRUE(surface == Surface::adapt || tag.dimension() == 3);
    ++inserted[tag.dimension()];
  });
  EXPECT_GT(trial.count[Outcome::accepted], 20);
  for (const std::uint32_t dimension : {1U, 2U, 3U})
    EXPECT_TRUE(surface == Surface::fixed || inserted[dimension] > 0) << "none was inserted of dimension " << dimension;
}

TEST(Insertion, IntoDisturbedDomains) {
  unsigned seed = 0;
  for (const Mesh& mesh : test::disturbed_domains()) {
    insert_everywhere(mesh, Sizes(mesh.points.size(), 0.15), Surface::adapt, 60);
    insert_everywhere(mesh, test::random_field(mesh, 0.3, ++seed), Surface::adapt, 60);
    insert_everywhere(mesh, test::random_field(mesh, 0.3, ++seed), Surface::fixed, 60);
  }
}

TEST(Insertion, GrowsBeyondTheShellByTheCriterion) {
  const Mesh input = test::cube(4);
  const Tensors stretched(input.points.size(), Tensor{400, 0, 0, 25, 0, 25});
  Workbench bench(input, stretched);
  int larger = 0;
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    if (insert_on_edge(bench.kernel, t, e, {.shortest_new_edge = 0.5}) != Outcome::accepted) return;
    larger += bench.kernel.cavity.tets.size() > bench.kernel.shell.size ? 1 : 0;
    bench.replenish();
  });
  EXPECT_GT(larger, 10);
}

TEST(Insertion, HoldsToItsRules) {
  Mesh input = test::cube(3);
  test::jitter(input, 0.05, 1);
  Workbench bench(input, Sizes(input.points.size(), 0.2));
  Attempts trial(bench);
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    EXPECT_EQ(trial([&] { return insert_on_edge(bench.kernel, t, e, {.shortest_new_edge = 5}); }), Outcome::short_edge);
    const InsertionRules perfect = {.shortest_new_edge = 0, .worst_quality = 1.1, .share_of_old = 1e9};
    EXPECT_EQ(trial([&] { return insert_on_edge(bench.kernel, t, e, perfect); }), Outcome::quality);
  });
}

TEST(Insertion, MakesNothingWorseThanItsRulesAllow) {
  const Mesh input = test::disturbed_domains()[1];
  Workbench bench(input, test::random_field(input, 0.3, 5));
  const InsertionRules rules = {.shortest_new_edge = 0.6, .worst_quality = 0.3, .share_of_old = 0.9};
  int accepted = 0;
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    const VertexId p = bench.block.vertices.next();
    const test::Snapshot before(bench.mesh);
    if (insert_on_edge(bench.kernel, t, e, rules) != Outcome::accepted) return;
    ++accepted;
    float worst_old = 1;
    for (TetId old : bench.kernel.cavity.tets.span())
      worst_old = std::min(worst_old, before.mesh.tets[old].state.quality);
    for (TetId made : bench.kernel.cavity.made()) {
      EXPECT_GT(test::quality_of(bench.mesh, made), std::min(0.3, 0.9 * worst_old) - 1e-6);
      for (VertexId v : bench.mesh.tets[made].v) EXPECT_TRUE(v == p || bench.kernel.length(p, v) > 0.6 * (1 - 1e-12));
    }
    bench.replenish();
  });
  EXPECT_GT(accepted, 20);
}

// An edge of the input in the working mesh: a tetrahedron, and the edge's number in it.
std::pair<TetId, int> find_edge(const TetMesh& mesh, Index p, Index q) {
  for (TetId t : test::living_tets(mesh))
    for (int e = 0; e < 6; ++e) {
      const Index a = mesh.origin_of_vertex[mesh.tets[t].v[edge_vertices[e][0]]];
      const Index b = mesh.origin_of_vertex[mesh.tets[t].v[edge_vertices[e][1]]];
      if ((a == p && b == q) || (a == q && b == p)) return {t, e};
    }
  ADD_FAILURE() << "no edge " << p << " " << q;
  return {};
}

Outcome insert_between(const Mesh& input, Index p, Index q, Surface surface = Surface::adapt) {
  Workbench bench(input, Sizes(input.points.size(), 0.01), surface);
  const auto [t, e] = find_edge(bench.mesh, p, q);
  Attempts trial(bench);
  return trial([&, tet = t, edge = e] { return insert_on_edge(bench.kernel, tet, edge, {}); });
}

TEST(Insertion, LeavesTheRequiredAlone) {
  // Points of the grid of 2^3 boxes are numbered 9 i + 3 j + k; (0, 1) lies on a line, (4, 5) on a side.
  Mesh mesh = test::cube(2);
  const Index p = 13, q = 14;  // inside
  EXPECT_EQ(insert_between(mesh, 0, 1), Outcome::accepted);
  EXPECT_EQ(insert_between(mesh, 4, 5), Outcome::accepted);
  EXPECT_EQ(insert_between(mesh, p, q), Outcome::accepted);
  EXPECT_EQ(insert_between(mesh, 0, 1, Surface::fixed), Outcome::frozen);
  EXPECT_EQ(insert_between(mesh, 4, 5, Surface::fixed), Outcome::frozen);
  EXPECT_EQ(insert_between(mesh, p, q, Surface::fixed), Outcome::accepted);

  mesh.edges = {{1, 0}, {4, 5}, {13, 14}};
  EXPECT_EQ(insert_between(mesh, 0, 1), Outcome::accepted) << "a ridge that was given may be split";
  EXPECT_EQ(insert_between(mesh, 4, 5), Outcome::accepted) << "one with one patch on both sides as well";
  EXPECT_EQ(insert_between(mesh, p, q), Outcome::frozen) << "nor may one inside";
  mesh.required_edges = {0};
  EXPECT_EQ(insert_between(mesh, 0, 1), Outcome::frozen);

  mesh = test::cube(2);
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (std::ranges::count(mesh.triangles[t], Index{4}) + std::ranges::count(mesh.triangles[t], Index{5}) == 2) {
      mesh.required_triangles = {t};
    }
  EXPECT_EQ(insert_between(mesh, 4, 5), Outcome::frozen);

  mesh = test::cube(2);
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t)
    if (std::ranges::count(mesh.tetrahedra[t], p) + std::ranges::count(mesh.tetrahedra[t], q) == 2)
      mesh.required_tetrahedra = {t};
  EXPECT_EQ(insert_between(mesh, p, q), Outcome::frozen);
}

TEST(Insertion, RefusesAShellWithoutRoom) {
  const Mesh input = test::ring(std::vector<double>(65, 1.0), std::vector<double>(65, 0.0), 1, true);
  EXPECT_EQ(insert_between(input, 0, 1), Outcome::too_large);
}

TEST(Insertion, MarksTheShellAsTried) {
  const Mesh input = test::cube(2);
  Workbench bench(input, Sizes(input.points.size(), 10));
  const auto [t, e] = find_edge(bench.mesh, 13, 14);
  EXPECT_EQ(insert_on_edge(bench.kernel, t, e, {}), Outcome::short_edge);
  for (TetId i : test::living_tets(bench.mesh))
    for (int k = 0; k < 6; ++k) {
      const Index a = bench.mesh.origin_of_vertex[bench.mesh.tets[i].v[edge_vertices[k][0]]];
      const Index b = bench.mesh.origin_of_vertex[bench.mesh.tets[i].v[edge_vertices[k][1]]];
      EXPECT_EQ(bench.mesh.tets[i].state.tried.has(Trial::insertion, k),
                std::minmax(a, b) == std::minmax(Index{13}, Index{14}));
    }
}

}  // namespace
}  // namespace taut
