// What the options, the callback and the report promise.
#include <cmath>

#include <map>
#include <set>

#include "adapt/checks.hpp"
#include "adapt/fields.hpp"

namespace taut {
namespace {

using test::cube;

AdaptOptions with_rounds(int rounds) {
  AdaptOptions options;
  options.max_rounds = rounds;
  return options;
}

TEST(Adapt, TheSameInputGivesTheSameBits) {
  const Mesh mesh = test::two_regions(4);
  for (const auto& field : {test::patchwork(0.6, 3), test::front(0.4, 0.5)}) {
    const AdaptResult one = adapt(mesh, field, with_rounds(5)), two = adapt(mesh, field, with_rounds(5));
    EXPECT_EQ(one.report.hash, two.report.hash);
    EXPECT_EQ(one.mesh.points, two.mesh.points);
    EXPECT_EQ(one.mesh.tetrahedra, two.mesh.tetrahedra);
    EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
    EXPECT_EQ(one.metric, two.metric);
    EXPECT_EQ(one.new_of_old, two.new_of_old);
    EXPECT_NE(one.report.hash, adapt(mesh, field, with_rounds(1)).report.hash) << "the hash tells meshes apart";
  }
}

TEST(Adapt, AllWaysOfGivingAConstantMetricAgree) {
  const Mesh mesh = cube(3);
  const double h = 0.2;
  const Tensor m = metric_of_size(h);
  const AdaptResult by_sizes = adapt(mesh, Sizes(mesh.points.size(), h));
  const AdaptResult by_tensors = adapt(mesh, Tensors(mesh.points.size(), m));
  const AdaptResult by_function = adapt(mesh, [&](const Point&) { return m; });
  EXPECT_EQ(by_sizes.report.hash, by_tensors.report.hash);
  // Interpolation rounds, so the counts may differ slightly.
  EXPECT_NEAR(
      static_cast<double>(by_function.mesh.tetrahedra.size()) / static_cast<double>(by_sizes.mesh.tetrahedra.size()), 1,
      0.15);
  EXPECT_NEAR(by_function.report.quality.tau, by_sizes.report.quality.tau, 0.02);
}

TEST(Adapt, AConstantMetricComesOutOfGradationUnchanged) {
  test::Random random(1);
  const Mesh mesh = cube(3);
  for (int i = 0; i < 3; ++i) {
    const Sym3 m = 1 / (0.5 * 0.5) * random.metric(0.1);
    const Tensors constant(mesh.points.size(), m);
    AdaptOptions options = with_rounds(4);
    const auto without = adapt(mesh, constant, options);
    for (const double mix : {0.0, 0.5, 1.0}) {
      options.limits.gradation = Gradation{.beta = 1.05, .mix = mix};
      EXPECT_EQ(adapt(mesh, constant, options).report.hash, without.report.hash);
    }
    for (const Tensor& at : without.metric) EXPECT_LT(test::distance(at, m), 1e-12);
  }
}

TEST(Adapt, GradationRefinesRoundASmallSize) {
  const Mesh mesh = cube(4);
  Sizes sizes(mesh.points.size(), 0.5);
  sizes[62] = 0.03;  // the middle
  AdaptOptions options;
  const auto without = adapt(mesh, sizes, options);
  options.limits.gradation = Gradation{.beta = 1.3};
  const auto with = adapt(mesh, sizes, options);
  test::expect_faithful(with, mesh);
  EXPECT_GT(with.mesh.tetrahedra.size(), without.mesh.tetrahedra.size());
  options.limits.gradation = Gradation{.beta = 100};
  EXPECT_EQ(adapt(mesh, sizes, options).report.hash, without.report.hash) << "so steep that it requires nothing";
}

TEST(Adapt, BoundsOnSizesHold) {
  const Mesh mesh = cube(3);
  AdaptOptions options;
  options.limits.hmin = 0.2;
  options.limits.hmax = 0.25;
  for (const double h : {0.001, 100.0}) {
    const double expected = h < 1 ? 0.2 : 0.25;
    const auto by_sizes = adapt(mesh, Sizes(mesh.points.size(), h), options);
    const auto by_function = adapt(mesh, test::uniform(h), options);
    for (const auto* result : {&by_sizes, &by_function})
      for (const Tensor& m : result->metric) EXPECT_LT(test::distance(m, metric_of_size(expected)), 1e-12);
  }
}

TEST(Adapt, AUniformSizeGivesUnitEdges) {
  for (const Mesh& mesh : {cube(3), test::l_shape(4)}) {
    const auto result = adapt(mesh, test::uniform(0.1));
    test::expect_faithful(result, mesh);
    EXPECT_GT(result.report.quality.unit_edges, 0.95);
    EXPECT_GT(result.report.quality.tau, 0.85);
    EXPECT_GT(result.report.quality.mean_ratio_min, 0.2);
  }
}

TEST(Adapt, AnAnisotropicConstantGivesUnitEdges) {
  const Mesh mesh = cube(3);
  const Sym3 m = test::rotate(test::Random(5).rotation(), Sym3{std::pow(0.03, -2), 0, 0, 16, 0, 16});
  const auto result = adapt(mesh, [&](const Point&) { return m; });
  test::expect_faithful(result, mesh);
  EXPECT_GT(result.report.quality.unit_edges, 0.9);
}

TEST(Adapt, CoarsensWhatIsTooFine) {
  const Mesh mesh = test::two_regions(10);
  const auto result = adapt(mesh, test::uniform(0.4));
  test::expect_faithful(result, mesh);
  EXPECT_LT(result.mesh.tetrahedra.size(), mesh.tetrahedra.size() / 15);
  EXPECT_GT(result.report.quality.unit_edges, 0.8);
  std::size_t gone = 0;
  for (const Index p : result.new_of_old) gone += p == AdaptResult::gone ? 1 : 0;
  EXPECT_GT(gone, mesh.points.size() * 9 / 10);
}

TEST(Adapt, ASecondRunFindsLittleToDo) {
  const Mesh mesh = cube(3);
  const auto first = adapt(mesh, test::uniform(0.12));
  const auto second = adapt(first.mesh, test::uniform(0.12));
  test::expect_faithful(second, first.mesh);
  EXPECT_LT(second.report.rounds, first.report.rounds + 1);
  EXPECT_LT(second.report.passes[0].accepted, first.report.passes[0].accepted / 10);
  EXPECT_NEAR(static_cast<double>(second.mesh.tetrahedra.size()) / static_cast<double>(first.mesh.tetrahedra.size()), 1,
              0.05);
}

TEST(Adapt, NoRoundsChangeNothing) {
  Mesh mesh = cube(3);
  mesh.point_refs = std::vector<int>(mesh.points.size(), 4);
  const auto result = adapt(mesh, test::uniform(0.01), with_rounds(0));
  test::expect_faithful(result, mesh);
  EXPECT_EQ(result.report.rounds, 0);
  EXPECT_EQ(test::placed_triangles(result.mesh), test::placed_triangles(mesh));
  EXPECT_EQ(result.mesh.points.size(), mesh.points.size());
  for (Index p = 0; p < mesh.points.size(); ++p) EXPECT_EQ(result.mesh.points[result.new_of_old[p]], mesh.points[p]);
}

TEST(Adapt, TheCallbackSeesEveryPassAndItsCountsAddUp) {
  AdaptOptions options{.block_size = 60};
  std::map<std::string, std::size_t> accepted;
  std::size_t vertices = 0, tetrahedra = 0;
  int last_round = 0;
  options.progress = [&](const Progress& p) {
    EXPECT_GE(p.round, last_round);
    last_round = p.round;
    accepted[p.pass] += p.accepted;
    vertices = p.vertices;
    tetrahedra = p.tetrahedra;
    return true;
  };
  const Mesh mesh = cube(3);
  const auto result = adapt(mesh, test::uniform(0.15), options);
  EXPECT_FALSE(result.report.cancelled);
  EXPECT_EQ(result.report.rounds, static_cast<std::size_t>(last_round + 1));
  EXPECT_EQ(vertices, result.mesh.points.size());
  EXPECT_EQ(tetrahedra, result.mesh.tetrahedra.size());
  std::map<std::string, std::size_t> reported;
  for (const PassReport& pass : result.report.passes) reported[pass.name] = pass.accepted;
  EXPECT_EQ(reported, accepted);
  const std::size_t before = mesh.points.size() + reported["insert"];
  const std::size_t after = result.mesh.points.size() + reported["collapse"];
  EXPECT_LE(before, after + reported["repair"]) << "some repairs are collapses";
  EXPECT_LE(after, before + reported["repair"]) << "some repairs insert a vertex";
  options.progress = {};
  const AdaptResult silent = adapt(mesh, test::uniform(0.15), options);
  EXPECT_EQ(silent.report.hash, result.report.hash) << "a callback changes nothing";
}

TEST(Adapt, SaysHowManyTetrahedraToExpectBeforeItBegins) {
  const Mesh mesh = cube(4);
  double expected = 0;
  AdaptOptions options;
  options.expecting = [&](double tetrahedra) {
    expected = tetrahedra;
    return true;
  };
  const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), 0.07), options);
  EXPECT_EQ(expected, result.report.expected_tetrahedra);
  EXPECT_NEAR(expected, static_cast<double>(result.mesh.tetrahedra.size()), 0.1 * expected);
  options.expecting = [](double) { return false; };
  const AdaptResult cancelled = adapt(mesh, Sizes(mesh.points.size(), 0.07), options);
  EXPECT_TRUE(cancelled.report.cancelled);
  EXPECT_EQ(cancelled.mesh.tetrahedra.size(), mesh.tetrahedra.size());
}

TEST(Adapt, RefusesMoreTetrahedraThanIdsBeforeItBegins) {
  const Mesh mesh = cube(4);
  for (const double size : {1e-4, 1e-9}) {
    try {
      (void)adapt(mesh, test::uniform(size));
      FAIL();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("tetrahedra needed, expected fewer than 536870912"), std::string::npos);
    }
  }
}

TEST(Adapt, CancellingGivesBackAValidMesh) {
  Mesh mesh = test::two_regions(4);
  test::jitter(mesh, 0.04, 1);
  mesh.required_tetrahedra = {5};
  for (int after = 1; after <= 9; ++after) {
    std::set<std::uint64_t> hashes;
    for (const int threads : {1, 3}) {
      AdaptOptions options{.threads = threads, .block_size = 60};
      int calls = 0;
      options.progress = [&](const Progress&) { return ++calls < after; };
      const auto result = adapt(mesh, test::patchwork(0.6, 1), options);
      EXPECT_TRUE(result.report.cancelled);
      EXPECT_EQ(calls, after) << "called again although it returned false";
      test::expect_faithful(result, mesh);
      hashes.insert(result.report.hash);
    }
    EXPECT_EQ(hashes.size(), 1);
  }
}

TEST(Adapt, MendsWhatItCanAndSaysSo) {
  Mesh mesh = test::two_regions(4);
  const Mesh sound = mesh;
  for (const std::size_t t : {3, 30, 31}) std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][3]);
  mesh.triangles.resize(mesh.triangles.size() - 10);
  mesh.triangle_refs.resize(mesh.triangles.size());
  const auto result = adapt(mesh, test::uniform(0.2));
  EXPECT_EQ(result.report.reoriented, 3);
  EXPECT_EQ(result.report.triangles_built, 10);
  EXPECT_EQ(defects(result.mesh), std::vector<std::string>{});
  EXPECT_NEAR(test::volume_of(result.mesh), 1, 1e-12);
  test::expect_same_sums(test::volumes(result.mesh), test::volumes(sound), "region");
}

TEST(Adapt, DropsEdgesThatBelongToNoTetrahedron) {
  Mesh mesh = test::cube(4);
  const auto stray = static_cast<Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{2, 0, 0}, {3, 0, 0}});
  mesh.edges = {{stray, stray + 1}, {0, stray}};
  mesh.ridges = {0};
  const auto result = adapt(mesh, test::uniform(0.3));
  EXPECT_EQ(result.report.edges_dropped, 2);
  EXPECT_EQ(defects(result.mesh), std::vector<std::string>{});
  EXPECT_EQ(result.new_of_old[stray], AdaptResult::gone);
}

// Next to large triangles that stay no mesh is unit: insertion and collapse, repair and relocation undo each other.
TEST(Rounds, EndWhenTheyGoInCircles) {
  const Mesh mesh = test::cube(4);
  const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), 0.06), {.surface = Surface::fixed});
  test::expect_faithful(result, mesh);
  EXPECT_LT(result.report.rounds, 12);
  std::size_t operations = 0;
  for (const PassReport& pass : result.report.passes) operations += pass.accepted;
  EXPECT_LT(operations, 4 * result.mesh.tetrahedra.size());
}

}  // namespace
}  // namespace taut
