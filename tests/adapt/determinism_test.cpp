// The same bits, whoever does the work: on any number of threads, in debug and in release, watched or not.
#include "adapt/checks.hpp"
#include "adapt/fields.hpp"

namespace taut {
namespace {

struct Case {
  const char* name;
  std::uint64_t hash;  ///< of the result. It may change with the algorithm, on purpose only
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
  graded.gradation = 1.5;
  graded.hmin = 0.01;
  return {
      {"front", 0x91ee8c12a9258fffU, cube, test::front(0.3, 0.6), {}},
      sampled("front_on_the_input", 0xbb6dbce8b1214a6bU, cube, test::front(0.3, 0.6)),
      sampled("front_under_a_fixed_surface", 0x700932ab95b37988U, cube, test::front(0.3, 0.6), fixed),
      {"refinement", 0x9c61ff79625a1534U, cube, test::uniform(0.08), {}},
      {"coarsening", 0xe23c7935412884a4U, fine, test::uniform(0.2), {}},
      sampled("coarsening_behind_a_front", 0xe032827b164cc989U, fine, test::front(0.4, 0.9)),
      {"jump", 0xec469c6e5a089e3bU, cube, test::jump(0.3), {}},
      sampled("graded_jump", 0xaf6bdcd20e407180U, cube, test::jump(0.2), graded),
      {"patchwork", 0x3969b392adbef9ebU, cube, test::patchwork(0.5, 1), {}},
      {"regions", 0x88f59f210d0d597cU, regions, test::front(0.3, 0.6), {}},
      {"corner", 0xe4d2e646365ae037U, corner, test::uniform(0.1), {}},
      {"vault", 0x3b1f7723605dc20bU, test::vault(cube), test::uniform(0.1), {}},
      {"ball", 0xa28da0e5e121b668U, test::ball(test::cube(6)), test::uniform(0.15), {}},
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

// Odd numbers of threads are watched. The blocks are so small that a case has several.
TEST_P(Determinism, SameBits) {
  run.options.passes = 6;
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

}  // namespace
}  // namespace taut
