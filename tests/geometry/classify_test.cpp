#include "geometry/classify.hpp"

#include "geometry/classified.hpp"

namespace taut {
namespace {

using test::Classified;
using test::cube;

TEST(Classify, ACubeHasSixPatchesTwelveLinesAndEightCorners) {
  for (const bool with_triangles : {true, false}) {
    Mesh mesh = cube(3);
    if (!with_triangles) mesh.triangles.clear(), mesh.triangle_refs.clear();
    const Classified c(mesh);
    EXPECT_EQ(c.count(), (test::Count{6, 12, 8}));
    EXPECT_EQ(c.tags(), (std::array<int, 4>{8, 24, 24, 8}));
    EXPECT_EQ(c.frozen_patches(), 0);
    for (const Line& line : c.model.lines) {
      EXPECT_EQ(line.patches.size(), 2);
      EXPECT_TRUE(line.sharp && !line.frozen && !line.required && !line.implicit);
      EXPECT_NEAR(norm(std::get<Straight>(line.shape).direction), 1, 1e-15);
    }
    for (std::size_t i = 1; i < c.model.corners.size(); ++i) {
      EXPECT_EQ(c.model.corners[i].patches.size(), 3);
      EXPECT_EQ(c.model.corners[i].lines.size(), 3);
    }
    for (const Patch& patch : c.model.patches) {
      const Plane& plane = std::get<Plane>(patch.shape);
      EXPECT_EQ(std::abs(plane.normal[0]) + std::abs(plane.normal[1]) + std::abs(plane.normal[2]), 1)
          << "along an axis";
      EXPECT_TRUE(plane.offset == 0 || plane.offset == 1);
    }
    EXPECT_EQ(c.patch_refs(), with_triangles ? (std::vector<int>{1, 2, 3, 4, 5, 6}) : std::vector<int>(6, 0));
  }
}

TEST(Classify, PlanesAcrossAnAxisAreExact) {
  for (int i = 1; i <= 30; ++i) {
    Mesh mesh = cube(3);
    for (Point& p : mesh.points) p = {0.1 * i * p[0] - 0.7, 0.17 * i * p[1], 0.3 * p[2] + 1.1 * i};
    const Classified c(mesh);
    for (const Patch& patch : c.model.patches) {
      const Plane& plane = std::get<Plane>(patch.shape);
      EXPECT_EQ(std::abs(plane.normal[0]) + std::abs(plane.normal[1]) + std::abs(plane.normal[2]), 1);
    }
    for (const VertexId v : ids<VertexId>(c.built.mesh.vertices.size())) {
      const Vec3 x = c.built.mesh.x(v);
      const Tag tag = c.built.mesh.tag_of_vertex[v];
      EXPECT_TRUE(tag.dimension() != 2 || c.model.project(tag, x) == x);
    }
  }
}

TEST(Classify, PartsThatTouchInAnEdgeOrAVertexStayThere) {
  const Mesh edge = test::restricted(test::grid(4), [](const Vec3& c) { return (c[0] < 0.5) == (c[1] < 0.5); });
  const Mesh vertex = test::restricted(
      test::grid(4), [](const Vec3& c) { return (c[0] < 0.5) == (c[1] < 0.5) && (c[0] < 0.5) == (c[2] < 0.5); });
  for (const bool in_edge : {true, false}) {
    const Classified c(in_edge ? edge : vertex);
    for (const VertexId v : ids<VertexId>(c.built.mesh.vertices.size())) {
      const Vec3& x = c.built.mesh.x(v);
      const bool touches = x[0] == 0.5 && x[1] == 0.5 && (in_edge || x[2] == 0.5);
      EXPECT_TRUE(!touches || c.built.mesh.tag_of_vertex[v].dimension() == 0);
    }
    std::size_t frozen = 0;
    for (const Line& line : c.model.lines) frozen += line.frozen ? 1 : 0;
    EXPECT_EQ(frozen, in_edge ? 4 : 0) << "edges where parts touch";
    EXPECT_EQ(c.frozen_patches(), 0);
  }
}

TEST(Classify, AVertexThatHoldsTwoPartsTogetherStays) {
  Index pin = none;
  const Mesh mesh = test::slit(pin);
  EXPECT_EQ(mesh.points.size(), 125 + 24);
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{12, 24, 17}));
  EXPECT_EQ(c.tag(pin).dimension(), 0);
}

TEST(Classify, VerticesAreWhereTheirTagsSay) {
  const Mesh mesh = test::askew(cube(4));
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{6, 12, 8}));
  const TetMesh& m = c.built.mesh;
  for (const VertexId v : ids<VertexId>(m.vertices.size())) {
    const Tag tag = m.tag_of_vertex[v];
    EXPECT_LT(norm(c.model.project(tag, m.x(v)) - m.x(v)), 1e-15);
    if (tag.dimension() == 2) {
      const Vec3 x = m.x(v) + Vec3{0.1, 0.2, 0.3}, p = c.model.project(tag, x);
      EXPECT_NEAR(norm(c.model.normal(tag, x)), 1, 1e-15);
      EXPECT_NEAR(dot(c.model.normal(tag, x), p - m.x(v)), 0, 1e-15);
      EXPECT_LT(norm(cross(c.model.normal(tag, x), p - x)), 1e-15) << "not projected orthogonally";
    }
  }
}

TEST(Classify, AnInterfaceMeetsTheBoundaryInLines) {
  const Classified c(test::two_regions(4));
  EXPECT_EQ(c.count(), (test::Count{11, 20, 12}));
  EXPECT_EQ(c.patch_refs(), (std::vector<int>{1, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7}));
  int of_three = 0;
  for (const Line& line : c.model.lines) of_three += line.patches.size() == 3 ? 1 : 0;
  EXPECT_EQ(of_three, 4);
  EXPECT_EQ(c.model.regions.size(), 2);
  EXPECT_FALSE(c.model.has_frozen_region);
}

TEST(Classify, AnInterfaceMayBeOrientedAnyhow) {
  Mesh mesh = test::two_regions(4);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2)
    if (mesh.triangle_refs[t] == 7) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{11, 20, 12}));
}

TEST(Classify, AnLShapeHasAnEdgeThatTurnsInward) {
  const Classified c(test::l_shape(4));
  EXPECT_EQ(c.count(), (test::Count{8, 18, 12}));
  EXPECT_EQ(c.frozen_patches(), 0);
}

TEST(Classify, ReferencesPartAFlatSide) {
  Mesh mesh = cube(4);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == 6 && test::centre_of(mesh, mesh.triangles[t])[0] < 0.5) mesh.triangle_refs[t] = 60;
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{7, 15, 10}));
  EXPECT_EQ(c.patch_refs(), (std::vector<int>{1, 2, 3, 4, 5, 6, 60}));
}

// A box under a roof whose two sides, 33.4 degrees apart, meet at x = 1/2.
Mesh roof() {
  Mesh mesh = cube(4);
  for (Point& p : mesh.points) p[2] *= 1.3 - 0.3 * std::abs(p[0] - 0.5);
  return mesh;
}

TEST(Classify, TheAngleDecidesWhatIsARidge) {
  const double angle = 2 * std::atan(0.3) * 180 / 3.14159265358979;
  const Classified sharp(roof(), Surface::planar, angle - 0.5), smooth(roof(), Surface::planar, angle + 0.5);
  EXPECT_EQ(sharp.count(), (test::Count{7, 15, 10}));
  EXPECT_EQ(sharp.frozen_patches(), 0);
  EXPECT_EQ(smooth.count().patches, 6);
  EXPECT_EQ(smooth.frozen_patches(), 1) << "a patch with a crease is not planar";
}

TEST(Classify, CurvedPatchesAreFrozen) {
  const Classified c(test::vault(cube(6)));
  EXPECT_EQ(c.model.patches.size(), 6);
  ASSERT_EQ(c.frozen_patches(), 1);
  for (const PatchId p : ids<PatchId>(6)) EXPECT_EQ(c.model.patches[p].frozen(), c.model.patches[p].ref == 6);
  const TetMesh& m = c.built.mesh;
  for (const Triangle& t : m.triangles)
    for (VertexId v : t.v) {
      EXPECT_TRUE(!c.model.patches[t.patch].frozen() || m.tag_of_vertex[v].dimension() == 0);
      EXPECT_EQ(c.model.on_patch(m.tag_of_vertex[v], t.patch), !c.model.patches[t.patch].frozen());
    }
  const auto tags = c.tags();
  EXPECT_GT(tags[1], 0);
  EXPECT_GT(tags[2], 0);

  const Classified ball(test::ball(cube(6)));
  EXPECT_EQ(ball.count(), (test::Count{1, 0, 0}));
  EXPECT_EQ(ball.frozen_patches(), 1);
  EXPECT_EQ(ball.tags(), (std::array<int, 4>{218, 0, 0, 125}));
}

TEST(Classify, NearlyPlanarIsPlanarAsWrittenWithTenDigits) {
  Mesh mesh = test::askew(cube(4));
  for (Point& p : mesh.points)
    for (double& x : p) x = std::round(x * 1e10) / 1e10;
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{6, 12, 8}));
  EXPECT_EQ(c.frozen_patches(), 0);
  mesh.points[2 * 25 + 2 * 5][2] += 1e-4;  // inside a side
  EXPECT_EQ(Classified(mesh).frozen_patches(), 1);
}

TEST(Classify, AFixedSurfaceIsAllFrozen) {
  const Classified c(test::two_regions(4), Surface::fixed);
  EXPECT_EQ(c.frozen_patches(), 11);
  for (const Line& line : c.model.lines) EXPECT_TRUE(line.frozen);
  const auto tags = c.tags();
  EXPECT_EQ(tags[1] + tags[2], 0);
  for (const Triangle& t : c.built.mesh.triangles)
    for (VertexId v : t.v) EXPECT_FALSE(c.model.on_patch(c.built.mesh.tag_of_vertex[v], t.patch));
}

}  // namespace
}  // namespace taut
