// Whole runs keep what they must: required entities, references, ridges, given edges.
#include "adapt/checks.hpp"
#include "adapt/fields.hpp"
#include "base/ids.hpp"

namespace taut {
namespace {

// Points of the grid of 4^3 boxes.
constexpr Index at(Index i, Index j, Index k) {
  return 25 * i + 5 * j + k;
}

AdaptResult run(const Mesh& mesh, const MetricFunction& field, Surface surface = Surface::adapt) {
  AdaptOptions options;
  options.surface = surface;
  options.max_rounds = 6;
  return adapt(mesh, field, options);
}

// Fine, coarse and hard.
std::vector<MetricFunction> fields() {
  return {test::uniform(0.15), test::uniform(2), test::patchwork(0.7, 4)};
}

TEST(Required, EntitiesOfEveryKindTogether) {
  Mesh mesh = test::two_regions(4);
  test::jitter(mesh, 0.04, 5);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) mesh.point_refs.push_back(static_cast<int>(p % 7));
  mesh.corners = {at(0, 2, 2), at(1, 2, 3)};
  mesh.required_points = {at(3, 1, 1), at(0, 0, 1), at(2, 2, 2)};
  mesh.edges = {
      {at(4, 0, 0), at(4, 0, 1)}, {at(4, 2, 2), at(4, 2, 3)}, {at(1, 1, 1), at(1, 1, 2)}, {at(0, 4, 3), at(0, 4, 4)}};
  mesh.edge_refs = {11, 12, 13, 14};
  mesh.required_edges = {0, 1, 2};
  mesh.required_triangles = {0, 17, 90, static_cast<Index>(mesh.triangles.size() - 1)};
  mesh.required_tetrahedra = {1, 50, 51, 200};
  for (const auto& field : fields()) {
    for (const Surface surface : {Surface::adapt, Surface::fixed}) {
      const auto result = run(mesh, field, surface);
      test::expect_faithful(result, mesh);
      EXPECT_GT(result.report.passes[0].accepted + result.report.passes[1].accepted, 0);
    }
  }
}

TEST(Required, EveryTetrahedronMeansNothingChanges) {
  Mesh mesh = test::cube(2);
  mesh.required_tetrahedra = test::all_of(mesh.tetrahedra.size());
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    EXPECT_EQ(result.mesh.tetrahedra.size(), mesh.tetrahedra.size());
    for (const PassReport& pass : result.report.passes) EXPECT_EQ(pass.accepted, 0) << pass.name;
  }
}

TEST(Required, EveryTriangleIsAsAFixedSurface) {
  Mesh mesh = test::cube(3);
  mesh.required_triangles = test::all_of(mesh.triangles.size());
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    EXPECT_EQ(test::placed_triangles(result.mesh), test::placed_triangles(mesh));
  }
}

TEST(Required, ATriangleBringsNoEdgesThatNobodyGave) {
  Mesh mesh = test::cube(4);
  Index t = 0;
  while (std::ranges::count(mesh.triangles[t], at(0, 2, 2)) == 0) ++t;
  mesh.required_triangles = {t};
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    EXPECT_NEAR(test::lengths(result.mesh)[0], 12, 1e-12) << "the cube's ridges";
  }
}

TEST(Required, RidgesAndLinesKeepTheirReferencesAndPlaces) {
  Mesh mesh = test::cube(4);
  for (Index k = 0; k < 4; ++k) mesh.edges.push_back({at(0, 0, k), at(0, 0, k + 1)});  // a ridge of the cube
  for (Index k = 0; k < 4; ++k) mesh.edges.push_back({at(0, 2, k), at(0, 2, k + 1)});  // a line that divides a side
  mesh.edge_refs = {5, 5, 5, 5, 6, 6, 6, 6};
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    auto lengths = test::lengths(result.mesh);
    EXPECT_NEAR(lengths[5], 1, 1e-12);
    EXPECT_NEAR(lengths[6], 1, 1e-12);
    EXPECT_NEAR(lengths[0], 11, 1e-12) << "the cube's other ridges";
    for (std::size_t e = 0; e < result.mesh.edges.size(); ++e)
      for (const Index p : result.mesh.edges[e]) {
        const Point& x = result.mesh.points[p];
        EXPECT_TRUE(result.mesh.edge_refs[e] != 5 || (x[0] == 0 && x[1] == 0));
        EXPECT_TRUE(result.mesh.edge_refs[e] != 6 || (x[0] == 0 && std::abs(x[1] - 0.5) < 1e-15));
      }
    EXPECT_EQ(result.mesh.ridges.size(),
              static_cast<std::size_t>(std::ranges::count_if(result.mesh.edge_refs, [](int ref) { return ref != 6; })));
  }
}

TEST(Required, GivenEdgesInsideTheVolumeStayAsTheyAre) {
  Mesh mesh = test::cube(4);
  mesh.edges = {{at(2, 2, 1), at(2, 2, 2)}, {at(2, 2, 2), at(2, 2, 3)}};
  mesh.edge_refs = {3, 4};
  mesh.ridges = {1};
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    std::vector<Index> given;
    for (Index e = 0; e < result.mesh.edges.size(); ++e)
      if (result.mesh.edge_refs[e] != 0) given.push_back(e);
    EXPECT_EQ(test::placed(result.mesh, result.mesh.edges, result.mesh.edge_refs, given),
              test::placed(mesh, mesh.edges, mesh.edge_refs, {0, 1}));
    EXPECT_TRUE(result.mesh.required_tetrahedra.empty()) << "tetrahedra frozen because of an edge are not required";
  }
}

TEST(Required, ManyRegionsAndReferencesOnFlatSides) {
  Mesh mesh = test::grid(4);
  for (const auto& t : mesh.tetrahedra) {
    const Vec3 c = test::centre_of(mesh, t);
    mesh.tetrahedron_refs.push_back((c[0] < 0.5 ? 1 : 0) + (c[1] < 0.5 ? 2 : 0) + (c[2] < 0.5 ? 4 : 0));
  }
  test::add_triangles(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.triangle_refs[t] += 10 * (test::centre_of(mesh, mesh.triangles[t])[1] < 0.25 ? 1 : 0);
  for (const auto& field : fields()) test::expect_faithful(run(mesh, field), mesh);
}

TEST(Required, TwoPartsThatTouchInAnEdgeOrAVertex) {
  // Surfaces in which four triangles meet at an edge, or two cones at a vertex.
  for (const bool edge : {true, false}) {
    Mesh mesh = test::restricted(test::grid(4), [&](const Vec3& c) {
      const bool low = c[0] < 0.5 && c[1] < 0.5 && (edge || c[2] < 0.5);
      const bool high = c[0] > 0.5 && c[1] > 0.5 && (edge || c[2] > 0.5);
      return low || high;
    });
    test::add_triangles(mesh);
    for (const auto& field : fields())
      for (const Surface surface : {Surface::adapt, Surface::fixed})
        test::expect_faithful(run(mesh, field, surface), mesh);
  }
}

TEST(Required, AVertexThatHoldsTwoPartsTogether) {
  Index pin = none;
  const Mesh mesh = test::slit(pin);
  for (const auto& field : fields()) {
    const auto result = run(mesh, field);
    test::expect_faithful(result, mesh);
    ASSERT_NE(result.new_of_old[pin], AdaptResult::gone);
    EXPECT_EQ(result.mesh.points[result.new_of_old[pin]], mesh.points[pin]);
  }
}

TEST(Required, SmallMeshesOfOneBoxOrTetrahedron) {
  Mesh one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  one.tetrahedra = {{0, 1, 2, 3}};
  for (const Mesh& mesh : {one, test::cube(1)})
    for (const auto& field : fields())
      for (const Surface surface : {Surface::adapt, Surface::fixed})
        test::expect_faithful(run(mesh, field, surface), mesh);
}

}  // namespace
}  // namespace taut
