// Whole runs: every domain in every field.
#include "adapt/checks.hpp"
#include "adapt/curved_checks.hpp"
#include "adapt/fields.hpp"

namespace taut {
namespace {

struct Domain {
  std::string name;
  Mesh mesh;
};

// Perturbed, and rotated if all would be exact otherwise.
std::vector<Domain> domains() {
  Mesh box = test::cube(4);
  test::jitter(box, 0.04, 1);
  Mesh regions = test::two_regions(4);
  test::jitter(regions, 0.04, 2);
  for (std::size_t t = 0; t < regions.triangles.size(); t += 3)
    if (regions.triangle_refs[t] == 7) std::swap(regions.triangles[t][0], regions.triangles[t][1]);
  Mesh corner = test::l_shape(4);
  test::jitter(corner, 0.04, 3);
  Mesh sheets = test::cube(8);  // two that cross and end inside
  test::add_sheet(sheets, 0);
  test::add_sheet(sheets, 2);
  Mesh turned = regions;
  const auto r = test::Random(9).rotation();
  for (Mesh* mesh : {&turned, &sheets})
    for (Point& p : mesh->points) p = test::rotate(r, p - Point{0.5, 0.5, 0.5});
  for (Point& p : sheets.points) p = 2.0 * p;
  return {{"cube", box},     {"regions", regions},        {"turned", turned},
          {"l", corner},     {"vault", test::vault(box)}, {"ball", test::ball(test::cube(4))},
          {"sheets", sheets}};
}

struct Field {
  std::string name;
  MetricFunction metric;
};

std::vector<Field> fields() {
  return {{"uniform", test::uniform(0.17)},
          {"patchwork", test::patchwork(0.55, 1)},
          {"jump", test::jump(0.5)},
          {"front", test::front(0.35, 0.6)}};
}

class Runs : public testing::TestWithParam<std::tuple<int, int, Surface>> {
protected:
  const Domain domain = domains()[static_cast<std::size_t>(std::get<0>(GetParam()))];
  const Field field = fields()[static_cast<std::size_t>(std::get<1>(GetParam()))];
  const Surface surface = std::get<2>(GetParam());
};

std::string name_of(const testing::TestParamInfo<Runs::ParamType>& info) {
  const Surface surface = std::get<2>(info.param);
  return domains()[static_cast<std::size_t>(std::get<0>(info.param))].name + "_" +
         fields()[static_cast<std::size_t>(std::get<1>(info.param))].name +
         (surface == Surface::fixed    ? "_fixed"
          : surface == Surface::planar ? "_planar"
                                       : "_adapt");
}

INSTANTIATE_TEST_SUITE_P(All, Runs,
                         testing::Combine(testing::Range(0, 7), testing::Range(0, 4),
                                          testing::Values(Surface::adapt, Surface::planar, Surface::fixed)),
                         name_of);

TEST_P(Runs, KeepWhatTheyMust) {
  AdaptOptions options;
  options.surface = surface;
  options.max_rounds = 6;
  const Metric metric =
      surface == Surface::fixed ? Metric(test::sampled(domain.mesh, field.metric)) : Metric(field.metric);
  const AdaptResult result = adapt(domain.mesh, metric, options);
  const bool is_curved = domain.name == "vault" || domain.name == "ball";
  if (is_curved && surface == Surface::adapt)
    test::expect_near_curved(result, domain.mesh);
  else
    test::expect_faithful(result, domain.mesh);
  ASSERT_EQ(result.report.passes[0].name, "insert");
  EXPECT_GT(result.report.passes[0].accepted, 0);
  if (surface == Surface::fixed || (surface == Surface::planar && domain.name == "ball")) {
    EXPECT_EQ(test::placed_triangles(result.mesh), test::placed_triangles(domain.mesh));
    EXPECT_EQ(result.report.triangles_frozen, domain.mesh.triangles.size());
  } else {
    EXPECT_NE(test::placed_triangles(result.mesh), test::placed_triangles(domain.mesh));
    EXPECT_EQ(result.report.triangles_frozen, surface == Surface::planar && domain.name == "vault" ? 32 : 0);
  }
}

}  // namespace
}  // namespace taut
