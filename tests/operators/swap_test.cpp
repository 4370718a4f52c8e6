#include "operators/swap.hpp"

#include "operators/ring_table.hpp"
#include "operators/workbench.hpp"

namespace taut {
namespace {

using test::Attempts;
using test::for_each_tet_edge;
using test::Random;
using test::Workbench;

constexpr double infinity = std::numeric_limits<double>::infinity();
const SwapRules anything_better = {.good_enough = 1, .poor = 1, .gain = 1.001, .longest_new_edge = infinity};

// The edge between points 0 and 1 of the input.
std::pair<TetId, int> axis_of(const TetMesh& mesh) {
  for (TetId t : test::living_tets(mesh))
    for (int e = 0; e < 6; ++e) {
      const auto& v = mesh.tets[t].v;
      if (mesh.origin_of_vertex[v[edge_vertices[e][0]]] + mesh.origin_of_vertex[v[edge_vertices[e][1]]] == 1)
        return {t, e};
    }
  return {};
}

// The worst 1/Q of the fan from ring vertex p, connected to both ends, from the definition.
double worst_of_fan(const Mesh& mesh, const Tensors& metric, int n, int p) {
  double worst = 1;
  for (int i = 1; i + 1 < n; ++i) {
    const auto at = [&](int k) { return static_cast<Index>(2 + (p + k) % n); };
    const std::array<Index, 3> f = {at(0), at(i), at(i + 1)};
    const auto quality = [&](Index a, Index b, Index c, Index d) {
      const auto& x = mesh.points;
      return shape_quality(x[a], x[b], x[c], x[d], metric[a], metric[b], metric[c], metric[d]);
    };
    worst = std::min({worst, quality(f[0], f[1], f[2], 1), quality(f[0], f[2], f[1], 0)});
  }
  return worst;
}

struct RingCase {
  Mesh mesh;
  Tensors metric;
  double old_worst = 1, best_new = -1;
};

RingCase random_ring(Random& random, int n, bool closed) {
  std::vector<double> radius, elevation;
  for (int i = 0; i < n; ++i) {
    radius.push_back(random.uniform(0.8, 1.2));
    elevation.push_back(random.uniform(-0.2, 0.2));
  }
  RingCase c{test::ring(radius, elevation, random.uniform(0.3, closed ? 2 : n), closed), {}};
  for (std::size_t i = 0; i < c.mesh.points.size(); ++i) c.metric.push_back(random.metric(0.7));
  for (const auto& t : c.mesh.tetrahedra) {
    const auto& x = c.mesh.points;
    const auto& m = c.metric;
    c.old_worst =
        std::min(c.old_worst, shape_quality(x[t[0]], x[t[1]], x[t[2]], x[t[3]], m[t[0]], m[t[1]], m[t[2]], m[t[3]]));
  }
  // Only the ends of an open ring lie on the surface and so can take over its triangles.
  for (int p = 0; p < n; p += closed ? 1 : n - 1)
    c.best_new = std::max(c.best_new, worst_of_fan(c.mesh, c.metric, n, p));
  return c;
}

double worst_of(const TetMesh& mesh) {
  double worst = 1;
  for (TetId t : test::living_tets(mesh)) worst = std::min(worst, test::quality_of(mesh, t));
  return worst;
}

std::map<Outcome, int> swap_rings(int n, bool closed, Surface surface) {
  Random random(static_cast<unsigned>(n));
  std::map<Outcome, int> count;
  for (int repeat = 0; repeat < 60 && !testing::Test::HasFatalFailure(); ++repeat) {
    const RingCase c = random_ring(random, n, closed);
    Workbench bench(c.mesh, c.metric, surface);
    const auto [t, e] = axis_of(bench.mesh);
    Attempts trial(bench);
    const Outcome outcome =
        trial([&, tet = t, edge = e] { return swap_edge(bench.kernel, tet, edge, anything_better); });
    ++count[outcome];
    if (outcome == Outcome::accepted) {
      EXPECT_EQ(test::living_tets(bench.mesh).size(), static_cast<std::size_t>(2 * (n - 2)));
      EXPECT_NEAR(worst_of(bench.mesh), c.best_new, 1e-9) << "another fan than the best one was taken";
    } else {
      EXPECT_LT(c.best_new, c.old_worst * 1.001 + 1e-6) << Attempts::name(outcome);
    }
  }
  return count;
}

TEST(SwapEdge, OfClosedRingsTakesTheBestFanWhereItIsBetter) {
  for (int n = RingTable::smallest; n <= RingTable::largest; ++n) {
    for (const Surface surface : {Surface::planar, Surface::fixed}) {
      auto count = swap_rings(n, true, surface);
      EXPECT_GT(count[Outcome::accepted], 5) << n;
      EXPECT_GT(count[Outcome::no_candidate], 5) << n;
      EXPECT_EQ(count[Outcome::accepted] + count[Outcome::no_candidate], 60) << n;
    }
  }
}

TEST(SwapEdge, OfTheSurfaceSwapsItsTwoTrianglesToo) {
  for (int n = RingTable::smallest; n <= RingTable::largest; ++n) {
    auto count = swap_rings(n, false, Surface::planar);
    EXPECT_GT(count[Outcome::accepted], 5) << n;
    EXPECT_GT(count[Outcome::no_candidate], 5) << n;
    EXPECT_EQ(count[Outcome::accepted] + count[Outcome::no_candidate], 60) << n;
    Random random(1);
    const RingCase c = random_ring(random, n, false);
    Workbench bench(c.mesh, c.metric, Surface::fixed);
    const auto [t, e] = axis_of(bench.mesh);
    EXPECT_NE(swap_edge(bench.kernel, t, e, anything_better), Outcome::accepted);
  }
}

TEST(SwapEdge, LeavesLargerAndSmallerRings) {
  for (const int n : {8, 12, 65}) {
    const Mesh input = test::ring(std::vector<double>(n, 1.0), std::vector<double>(n, 0.0), 1, true);
    Workbench bench(input, Sizes(input.points.size(), 1.0));
    const auto [t, e] = axis_of(bench.mesh);
    Attempts trial(bench);
    EXPECT_EQ(trial([&, tet = t, edge = e] { return swap_edge(bench.kernel, tet, edge, anything_better); }),
              Outcome::too_large);
  }
  const Mesh input = test::ring({1, 1}, {0, 0}, 1, false);  // one flat tetrahedron would be left
  EXPECT_TRUE(input.tetrahedra.size() == 1);
}

TEST(SwapEdge, HoldsToItsRules) {
  // A long thin axis: the fan is far better, its edges 2 long.
  const Mesh input = test::ring(std::vector<double>(6, 1.0), std::vector<double>(6, 0.0), 0.2, true);
  const auto swap = [&](const SwapRules& rules) {
    Workbench bench(input, Sizes(input.points.size(), 1.0), Surface::fixed);
    const auto [t, e] = axis_of(bench.mesh);
    Attempts trial(bench);
    return trial([&, tet = t, edge = e] { return swap_edge(bench.kernel, tet, edge, rules); });
  };
  const Mesh tall = test::ring(std::vector<double>(6, 1.0), std::vector<double>(6, 0.0), 4, true);
  Workbench bench(tall, Sizes(tall.points.size(), 1.0), Surface::fixed);
  const auto [t, e] = axis_of(bench.mesh);
  ASSERT_EQ(swap_edge(bench.kernel, t, e, anything_better), Outcome::accepted);
  EXPECT_NE(swap(anything_better), Outcome::accepted) << "a short axis is no worse than its fans";
  const auto swap_tall = [&](const SwapRules& rules) {
    Workbench fresh(tall, Sizes(tall.points.size(), 0.1), Surface::fixed);
    const auto [tet, edge] = axis_of(fresh.mesh);
    Attempts trial(fresh);
    return trial([&, i = tet, k = edge] { return swap_edge(fresh.kernel, i, k, rules); });
  };
  EXPECT_EQ(swap_tall(anything_better), Outcome::accepted);
  EXPECT_EQ(swap_tall({.good_enough = 0.01, .gain = 1.001, .longest_new_edge = infinity}), Outcome::no_candidate);
  EXPECT_EQ(swap_tall({.good_enough = 1, .gain = 50, .longest_new_edge = infinity}), Outcome::no_candidate);
  EXPECT_EQ(swap_tall({.good_enough = 1, .gain = 1.001, .longest_new_edge = 0.1}), Outcome::accepted)
      << "no edge may be longer, unless the axis is";
}

TEST(SwapEdge, MakesNoLongEdge) {
  // The axis is short in a metric that is coarse along it; the fans' edges are long.
  const Mesh input = test::ring(std::vector<double>(4, 1.0), std::vector<double>(4, 0.0), 4, true);
  const Tensors metric(input.points.size(), Tensor{1, 0, 0, 1, 0, 0.05});
  const auto swap = [&](double longest) {
    Workbench bench(input, metric, Surface::fixed);
    const auto [t, e] = axis_of(bench.mesh);
    Attempts trial(bench);
    SwapRules rules = {.good_enough = 1, .gain = 1e-3, .longest_new_edge = longest};
    return trial([&, tet = t, edge = e] { return swap_edge(bench.kernel, tet, edge, rules); });
  };
  EXPECT_EQ(swap(2.1), Outcome::accepted);
  EXPECT_EQ(swap(1.9), Outcome::long_edge);
}

TEST(SwapEdge, InDisturbedDomains) {
  unsigned seed = 0;
  for (const Mesh& input : test::disturbed_domains()) {
    for (const Surface surface : {Surface::adapt, Surface::fixed}) {
      Workbench bench(input, test::random_field(input, 0.5, ++seed), surface);
      Attempts trial(bench);
      int on_surface = 0;
      for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
        const test::Snapshot before(bench.mesh);
        if (trial([&] { return swap_edge(bench.kernel, t, e, anything_better); }) != Outcome::accepted) return;
        on_surface += bench.kernel.shell.triangle_count > 0 ? 1 : 0;
        EXPECT_EQ(test::living_vertices(bench.mesh).size(), before.living[0]);
        float worst_old = 1;
        double worst_new = 1;
        for (TetId old : bench.kernel.shell_tets())
          worst_old = std::min(worst_old, before.mesh.tets[old].state.quality);
        for (TetId made : bench.kernel.cavity.made())
          worst_new = std::min(worst_new, test::quality_of(bench.mesh, made));
        EXPECT_GT(worst_new, worst_old);
      });
      EXPECT_GT(trial.count[Outcome::accepted], 10);
      EXPECT_GT(trial.count[Outcome::frozen], 0) << "ridges may not be swapped";
      EXPECT_EQ(on_surface > 0, surface == Surface::adapt);
    }
  }
}

TEST(SwapFace, TurnsTwoTetrahedraIntoThree) {
  Random random(1);
  int swapped = 0, refused = 0;
  for (int i = 0; i < 100 && !testing::Test::HasFatalFailure(); ++i) {
    Mesh input;
    input.points = {{1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}, {0, 0, 0.3}, {0, 0, -0.3}};
    for (Point& p : input.points) p = p + (i == 0 ? 0 : 0.4) * random.point();
    input.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    test::add_triangles(input);
    const auto& x = input.points;
    if (six_volumes(x[0], x[1], x[2], x[3]) <= 0 || six_volumes(x[0], x[2], x[1], x[4]) <= 0) continue;
    bool convex = true;
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}}) convex &= six_volumes(x[a], x[b], x[3], x[4]) < 0;
    Workbench bench(input, Sizes(5, 1.0), Surface::fixed);
    int face = 0;
    while (bench.mesh.tets[0].n[face].is_triangle()) ++face;
    const double old_worst = worst_of(bench.mesh);
    Attempts trial(bench);
    if (trial([&] { return swap_face(bench.kernel, TetId{0}, face, anything_better); }) == Outcome::accepted) {
      ++swapped;
      EXPECT_TRUE(convex);
      EXPECT_EQ(test::living_tets(bench.mesh).size(), 3);
      EXPECT_GT(worst_of(bench.mesh), old_worst);
    } else {
      ++refused;
      EXPECT_EQ(trial.count[Outcome::inverted] == 0, convex);
    }
    EXPECT_TRUE(i > 0 || swapped == 1) << "the flat one is worth swapping";
  }
  EXPECT_GT(swapped, 5);
  EXPECT_GT(refused, 5);
}

TEST(SwapFace, InDisturbedDomains) {
  unsigned seed = 0;
  int accepted = 0;
  for (const Mesh& input : test::disturbed_domains()) {
    Workbench bench(input, test::random_field(input, 0.5, ++seed, 0.05));
    Attempts trial(bench);
    for (const TetId t : bench.mesh.tet_ids())
      for (int f = 0; f < 4 && !testing::Test::HasFatalFailure() && bench.mesh.tets[t].alive(); ++f) {
        const bool at_triangle = bench.mesh.tets[t].n[f].is_triangle();
        const test::Snapshot before(bench.mesh);
        const Outcome outcome = trial([&] { return swap_face(bench.kernel, t, f, anything_better); });
        EXPECT_FALSE(at_triangle && outcome != Outcome::no_candidate);
        // On the boundary in an oblique plane, up to rounding, two tetrahedra become two others, and so do their
        // triangles.
        const std::size_t more = test::living_tets(bench.mesh).size() - before.living[1];
        EXPECT_TRUE(outcome == Outcome::accepted ? more <= 1 : more == 0);
        EXPECT_EQ(test::living_triangle_count(bench.mesh), before.living[2]);
      }
    accepted += trial.count[Outcome::accepted];
    EXPECT_GT(trial.count[Outcome::inverted], 0);
  }
  EXPECT_GT(accepted, 5);
}

TEST(Swaps, LeaveTheRequiredAlone) {
  // Nothing may change in a mesh of required tetrahedra, nor a required tetrahedron among others.
  Mesh input = test::disturbed_domains()[0];
  for (Index t = 0; t < input.tetrahedra.size(); t += 3) input.required_tetrahedra.push_back(t);
  Workbench bench(input, test::random_field(input, 0.5, 1));
  Attempts trial(bench);
  std::set<std::array<VertexId, 4>> required;
  const auto frozen_tets = [&] {
    std::set<std::array<VertexId, 4>> found;
    for (TetId t : test::living_tets(bench.mesh))
      if (bench.model.regions[bench.mesh.region_of_tet[t]].frozen) found.insert(bench.mesh.tets[t].v);
    return found;
  };
  required = frozen_tets();
  EXPECT_EQ(required.size(), input.required_tetrahedra.size());
  for_each_tet_edge(bench.mesh, [&](TetId t, int e) {
    (void)trial([&] { return swap_edge(bench.kernel, t, e, anything_better); });
    if (e < 4 && bench.mesh.tets[t].alive())
      (void)trial([&] { return swap_face(bench.kernel, t, e, anything_better); });
  });
  EXPECT_EQ(frozen_tets(), required);
  EXPECT_GT(trial.count[Outcome::frozen], 20);
}

}  // namespace
}  // namespace taut
