// The same bits on any number of threads, in debug and release builds, with and without a progress callback.
#include <oneapi/tbb/task_arena.h>

#include <set>
#include <stdexcept>
#include <tuple>

#include "adapt/checks.hpp"
#include "adapt/fields.hpp"
#include "adapt/hash.hpp"

namespace taut {
namespace {

struct Case {
  const char* name;
  std::uint64_t hash;  ///< of the result. It may change only with the algorithm, on purpose
  Mesh mesh;
  Metric metric;
  AdaptOptions options;
};

Mesh disturbed(Mesh mesh, double by, unsigned seed) {
  test::jitter(mesh, by, seed);
  return mesh;
}

Case sampled(const char* name, std::uint64_t hash, Mesh mesh, const MetricFunction& field, AdaptOptions options = {}) {
  Metric metric = test::sampled(mesh, field);
  return {name, hash, std::move(mesh), std::move(metric), std::move(options)};
}

std::vector<Case> cases() {
  const Mesh cube = disturbed(test::cube(6), 0.03, 1);
  const Mesh fine = disturbed(test::cube(11), 0.01, 2);
  const Mesh regions = disturbed(test::two_regions(6), 0.03, 3);
  const Mesh corner = disturbed(test::l_shape(6), 0.02, 4);
  AdaptOptions fixed;
  fixed.surface = Surface::fixed;
  AdaptOptions graded;
  graded.limits.gradation = Gradation{};
  graded.limits.hmin = 0.01;
  return {
      {"front", 0xa4220f0408e39050U, cube, test::front(0.3, 0.6), {}},
      sampled("front_on_the_input", 0x8dad706d1377485fU, cube, test::front(0.3, 0.6)),
      sampled("front_under_a_fixed_surface", 0xcbb00bb0dc187f9dU, cube, test::front(0.3, 0.6), fixed),
      {"refinement", 0x45f14fb3bb20442dU, cube, test::uniform(0.08), {}},
      {"coarsening", 0xc95bc7d86fb792f6U, fine, test::uniform(0.2), {}},
      sampled("coarsening_behind_a_front", 0x3c2aef916a1072c2U, fine, test::front(0.4, 0.9)),
      {"jump", 0x97c7e3a11ae260beU, cube, test::jump(0.3), {}},
      sampled("graded_jump", 0x66baf86d07b5ea60U, cube, test::jump(0.2), graded),
      {"patchwork", 0x37d826a761b29611U, cube, test::patchwork(0.5, 1), {}},
      {"regions", 0xc493c06a071ba37U, regions, test::front(0.3, 0.6), {}},
      {"corner", 0x4af24a0d8c0f524U, corner, test::uniform(0.1), {}},
      {"vault", 0x5ae5e365a2291c61U, test::vault(cube), test::uniform(0.1), {}},
      {"ball", 0x4357bd54dec66530U, test::ball(test::cube(6)), test::uniform(0.15), {}},
  };
}

class Determinism : public testing::TestWithParam<std::tuple<int, int>> {
protected:
  Case run = cases()[static_cast<std::size_t>(std::get<0>(GetParam()))];
  const int threads = std::get<1>(GetParam());
};

std::string name_of(const testing::TestParamInfo<Determinism::ParamType>& info) {
  return cases()[static_cast<std::size_t>(std::get<0>(info.param))].name + std::string("_on_") +
         std::to_string(std::get<1>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Threads, Determinism,
                         testing::Combine(testing::Range(0, static_cast<int>(cases().size())),
                                          testing::Values(1, 2, 3, 5, 8)),
                         name_of);

// Odd numbers of threads run with a progress callback. The blocks are so small that a case has several.
TEST_P(Determinism, SameBits) {
  run.options.max_rounds = 6;
  run.options.threads = threads;
  run.options.block_size = 150;
  int calls = 0;
  if (threads % 2 == 1) run.options.progress = [&](const Progress&) { return ++calls > 0; };
  const AdaptResult result = adapt(run.mesh, run.metric, run.options);
  EXPECT_EQ(result.report.threads, threads);
  EXPECT_GT(result.report.blocks, 2);
  EXPECT_EQ(calls > 0, threads % 2 == 1);
  EXPECT_EQ(result.report.hash, run.hash) << "HASH " << run.name << " 0x" << std::hex << result.report.hash;
}

// What the hash does not cover too.
TEST(Threads, LeaveNoTraceInTheResult) {
  Case run = cases()[9];
  run.mesh.required_tetrahedra = {5, 100};
  run.mesh.required_triangles = {3};
  run.mesh.corners = {0};
  run.options.block_size = 150;
  run.options.threads = 1;
  const AdaptResult one = adapt(run.mesh, run.metric, run.options);
  run.options.threads = 3;
  const AdaptResult three = adapt(run.mesh, run.metric, run.options);
  const auto all_of = [](const Mesh& m) {
    return std::tie(m.points, m.point_refs, m.tetrahedra, m.tetrahedron_refs, m.triangles, m.triangle_refs, m.edges,
                    m.edge_refs, m.corners, m.ridges, m.required_points, m.required_edges, m.required_triangles,
                    m.required_tetrahedra);
  };
  EXPECT_EQ(all_of(one.mesh), all_of(three.mesh));
  EXPECT_EQ(one.metric, three.metric);
  EXPECT_EQ(one.new_of_old, three.new_of_old);
  ASSERT_EQ(one.report.passes.size(), three.report.passes.size());
  for (std::size_t i = 0; i < one.report.passes.size(); ++i) {
    const PassReport &a = one.report.passes[i], &b = three.report.passes[i];
    EXPECT_EQ(std::tie(a.name, a.scanned, a.tried, a.accepted, a.refused, a.put_off),
              std::tie(b.name, b.scanned, b.tried, b.accepted, b.refused, b.put_off));
  }
  EXPECT_EQ(one.report.rounds, three.report.rounds);
  EXPECT_EQ(one.report.blocks, three.report.blocks);
  EXPECT_EQ(one.report.quality.tau, three.report.quality.tau);
}

TEST(Hash, CoversTheMetricReferencesEdgesAndMarks) {
  Mesh mesh = test::two_regions(2);
  mesh.edges = {{0, 1}};
  const Tensors metric(mesh.points.size(), identity3);
  const std::vector<std::function<void(Mesh&, Tensors&)>> changes = {
      [](Mesh& m, Tensors&) { m.points[3][1] += 1e-9; },
      [](Mesh& m, Tensors&) { m.triangle_refs[2] += 1; },
      [](Mesh& m, Tensors&) { m.tetrahedron_refs[4] += 1; },
      [](Mesh& m, Tensors&) {
        m.edges[0] = {1, 0};
      },
      [](Mesh& m, Tensors&) { m.edge_refs = {7}; },
      [](Mesh& m, Tensors&) { m.ridges = {0}; },
      [](Mesh& m, Tensors&) { m.corners = {5}; },
      [](Mesh& m, Tensors&) { m.required_points = {5}; },
      [](Mesh&, Tensors& t) { t[6][5] += 1e-9; }};
  std::set<std::uint64_t> hashes = {hash_of(mesh, metric)};
  for (const auto& change : changes) {
    Mesh changed = mesh;
    Tensors changed_metric = metric;
    change(changed, changed_metric);
    EXPECT_TRUE(hashes.insert(hash_of(changed, changed_metric)).second);
  }
}

TEST(Threads, MayBeManyBlocksOfNextToNothing) {
  const Mesh mesh = test::cube(4);  // many equal coordinates: blocks may be empty
  std::set<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    const AdaptResult result = adapt(mesh, test::uniform(0.2), {.max_rounds = 4, .threads = threads, .block_size = 1});
    test::expect_faithful(result, mesh);
    EXPECT_GT(result.report.blocks, 50);
    hashes.insert(result.report.hash);
  }
  EXPECT_EQ(hashes.size(), 1);
}

TEST(Threads, AreThoseOfTheCallersArena) {
  const Case run = cases()[0];
  for (const int threads : {1, 2}) {
    oneapi::tbb::task_arena arena(threads);
    arena.execute([&] {
      const AdaptResult result = adapt(run.mesh, run.metric, {.max_rounds = 1});
      EXPECT_EQ(result.report.threads, threads);
      EXPECT_EQ(adapt(run.mesh, run.metric, {.max_rounds = 1, .threads = 3}).report.threads, 3) << "unless asked for";
      EXPECT_EQ(adapt(run.mesh, run.metric, {.max_rounds = 1, .threads = 3}).report.hash, result.report.hash);
    });
  }
}

TEST(Threads, AnErrorOfTheMetricComesThrough) {
  const auto fails = [](const Point& p) -> Tensor {
    if (p[0] > 0.5 && p[0] < 0.51) throw std::runtime_error("no metric there");
    return {400, 0, 0, 400, 0, 400};
  };
  AdaptOptions options{.block_size = 200};
  for (const int threads : {1, 3}) {
    options.threads = threads;
    EXPECT_THROW((void)adapt(test::cube(5), fails, options), std::runtime_error);
  }
}

}  // namespace
}  // namespace taut
