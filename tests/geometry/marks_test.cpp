// What the input marks: required entities, corners, given edges.
#include <set>

#include "geometry/classified.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using test::Classified;
using test::cube;

// Points of the grid of n^3 boxes; those of the tests have n = 4.
constexpr Index at(Index i, Index j, Index k) {
  return 25 * i + 5 * j + k;
}

const Index on_line = at(0, 0, 2), on_side = at(0, 2, 2), inside = at(2, 2, 2);

TEST(Marks, PointsOfEachKindWithoutAny) {
  const Classified c(cube(4));
  EXPECT_EQ(c.tag(on_line).dimension(), 1);
  EXPECT_EQ(c.tag(on_side).dimension(), 2);
  EXPECT_EQ(c.tag(inside).dimension(), 3);
}

TEST(Marks, CornersAndRequiredPointsStay) {
  for (const bool corners : {true, false}) {
    Mesh mesh = cube(4);
    (corners ? mesh.corners : mesh.required_points) = {on_line, on_side, inside};
    const Classified c(mesh);
    for (const Index p : {on_line, on_side, inside}) EXPECT_EQ(c.tag(p).dimension(), 0);
    EXPECT_EQ(c.tags(), (std::array<int, 4>{11, 35, 53, 26}));
    // Its surroundings may still change: the corner knows its patches and lines.
    EXPECT_EQ(c.model.corners[c.tag(on_side).corner()].patches.size(), 1);
    EXPECT_EQ(c.model.corners[c.tag(on_line).corner()].patches.size(), 2);
    EXPECT_EQ(c.model.corners[c.tag(on_line).corner()].lines.size(), 2) << "the line is divided in two";
    EXPECT_EQ(c.model.lines.size(), 13);
    EXPECT_EQ(c.frozen_patches(), 0);
  }
}

TEST(Marks, AMarkOnAPointOfNoTetrahedronIsPassedOver) {
  Mesh mesh = cube(4);
  mesh.points.push_back({9, 9, 9});
  mesh.corners = mesh.required_points = {125};
  EXPECT_EQ(Classified(mesh).count(), (test::Count{6, 12, 8}));
}

TEST(Marks, ARequiredRidgeIsFrozenAndTheRestOfItIsNot) {
  Mesh mesh = cube(4);
  mesh.edges = {{at(0, 0, 1), at(0, 0, 2)}};
  mesh.edge_refs = {5};
  mesh.required_edges = {0};
  const Classified c(mesh);
  const Line* line = c.line(at(0, 0, 2), at(0, 0, 1));
  ASSERT_NE(line, nullptr);
  EXPECT_TRUE(line->frozen && line->required && line->sharp);
  EXPECT_EQ(line->ref, 5);
  EXPECT_EQ(c.model.lines.size(), 14) << "divided in three";
  EXPECT_EQ(c.tag(at(0, 0, 1)).dimension(), 0);
  EXPECT_EQ(c.tag(at(0, 0, 2)).dimension(), 0);
  EXPECT_EQ(c.tag(at(0, 0, 3)).dimension(), 1);
  EXPECT_FALSE(c.line(at(0, 0, 2), at(0, 0, 3))->frozen);
}

TEST(Marks, AGivenRidgeMayChangeAndKeepsItsReference) {
  Mesh mesh = cube(4);
  for (Index k = 0; k < 4; ++k) mesh.edges.push_back({at(0, 0, k + 1), at(0, 0, k)});
  mesh.edge_refs.assign(4, 8);
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{6, 12, 8}));
  EXPECT_EQ(c.line(at(0, 0, 0), at(0, 0, 1))->ref, 8);
  EXPECT_FALSE(c.line(at(0, 0, 0), at(0, 0, 1))->frozen);
  mesh.edge_refs[3] = 9;  // now two lines
  EXPECT_EQ(Classified(mesh).model.lines.size(), 13);
}

TEST(Marks, GivenEdgesThatCutASideInTwoPartIt) {
  Mesh mesh = cube(4);
  for (Index k = 0; k < 4; ++k) mesh.edges.push_back({at(0, 2, k), at(0, 2, k + 1)});
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{7, 15, 10}));
  EXPECT_FALSE(c.line(at(0, 2, 0), at(0, 2, 1))->frozen);
  EXPECT_FALSE(c.line(at(0, 2, 0), at(0, 2, 1))->sharp) << "written back as an edge, not as a ridge";
  mesh.ridges = {0, 1, 2, 3};
  EXPECT_TRUE(Classified(mesh).line(at(0, 2, 0), at(0, 2, 1))->sharp);
}

TEST(Marks, GivenEdgesThatBendAreLinesBetweenTheBends) {
  Mesh mesh = cube(4);
  const std::vector<Index> chain = {at(0, 1, 0), at(0, 1, 1), at(0, 2, 2), at(0, 2, 3), at(0, 2, 4)};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) mesh.edges.push_back({chain[i], chain[i + 1]});
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{7, 17, 12}));
  EXPECT_EQ(c.tag(chain[1]).dimension(), 0);
  EXPECT_EQ(c.tag(chain[2]).dimension(), 0);
  EXPECT_EQ(c.tag(chain[3]).dimension(), 1);
}

TEST(Marks, GivenEdgesThatDangleAreALine) {
  Mesh mesh = cube(4);
  mesh.edges = {{at(0, 2, 1), at(0, 2, 2)}, {at(0, 2, 2), at(0, 2, 3)}};
  const Classified c(mesh);
  EXPECT_EQ(c.model.patches.size(), 6);
  for (const Index k : {1, 3}) EXPECT_EQ(c.tag(at(0, 2, k)).dimension(), 0);
  EXPECT_EQ(c.tag(at(0, 2, 2)).dimension(), 1);
  const Line* line = c.line(at(0, 2, 1), at(0, 2, 2));
  ASSERT_NE(line, nullptr);
  EXPECT_FALSE(line->frozen);
  EXPECT_EQ(line->patches.size(), 2) << "one patch, on both sides";
  EXPECT_FALSE(line->required);
  EXPECT_EQ(c.frozen_patches(), 0);
}

TEST(Marks, AnEdgeInsideFreezesTheTetrahedraRoundIt) {
  Mesh mesh = cube(4);
  mesh.edges = {{inside, at(2, 2, 3)}};
  mesh.edge_refs = {3};
  const Classified c(mesh);
  ASSERT_EQ(c.model.inner_edges.size(), 1);
  EXPECT_EQ(c.model.inner_edges[0].ref, 3);
  EXPECT_EQ((std::set<std::uint32_t>{c.model.inner_edges[0].points[0], c.model.inner_edges[0].points[1]}),
            (std::set<std::uint32_t>{inside, at(2, 2, 3)}));
  EXPECT_TRUE(c.model.has_frozen_region);
  std::size_t frozen = 0, around = 0;
  for (const TetId t : ids<TetId>(c.built.mesh.tets.size())) {
    const bool is_frozen = c.model.regions[c.built.mesh.region_of_tet[t]].frozen;
    for (VertexId v : c.built.mesh.tets[t].v) EXPECT_TRUE(!is_frozen || c.built.mesh.tag_of_vertex[v].dimension() == 0);
    frozen += is_frozen ? 1 : 0;
  }
  for (const auto& t : mesh.tetrahedra)
    around += std::ranges::count(t, inside) + std::ranges::count(t, at(2, 2, 3)) == 2 ? 1 : 0;
  EXPECT_EQ(frozen, around);
  EXPECT_GT(around, 0);
}

void expect_refused(const Mesh& mesh, const std::string& message) {
  try {
    const Classified c(mesh);
    ADD_FAILURE() << "not refused: " << message;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), message);
  }
}

TEST(Marks, AnEdgeThatIsNotInTheMeshIsRefused) {
  Mesh mesh = cube(4);
  mesh.edges = {{at(0, 0, 0), at(0, 0, 1)}, {at(4, 4, 4), at(0, 0, 0)}};
  try {
    const Classified c(mesh);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("is not an edge of any tetrahedron"), std::string::npos) << message;
    EXPECT_NE(message.find("125"), std::string::npos) << message;
  }
}

TEST(Marks, AnEdgeAtAPointOfNoTetrahedronIsPassedOverUnlessItIsRequired) {
  Mesh mesh = cube(4);
  mesh.points.insert(mesh.points.end(), {{9, 9, 9}, {9, 9, 8}});
  mesh.edges = {{0, 125}, {126, 125}, {at(0, 0, 0), at(0, 0, 1)}};
  mesh.edge_refs = {5, 6, 7};
  mesh.ridges = {0, 1, 2};
  const Classified c(mesh);
  EXPECT_EQ(c.count(), (test::Count{6, 13, 9})) << "the third edge has a reference of its own";
  EXPECT_EQ(c.line(at(0, 0, 0), at(0, 0, 1))->ref, 7);
  EXPECT_EQ(Classified(mesh, Surface::adapt, std::nullopt).count(), c.count());
  mesh.required_edges = {0};
  expect_refused(mesh, "edge 1 (1 126) is required, but vertex 126 belongs to no tetrahedron");
}

TEST(Marks, RequiredTrianglesAreAFrozenPatch) {
  Mesh mesh = cube(4);
  Index t = 0;
  while (std::ranges::count(mesh.triangles[t], on_side) == 0) ++t;
  mesh.required_triangles = {t};
  const Classified c(mesh);
  EXPECT_EQ(c.model.patches.size(), 7);
  EXPECT_EQ(c.frozen_patches(), 1);
  const Triangle& triangle = c.built.mesh.triangles[c.built.triangle_of_input[t]];
  EXPECT_TRUE(c.model.patches[triangle.patch].required);
  EXPECT_EQ(c.model.patches[triangle.patch].ref, mesh.triangle_refs[t]);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(c.tag(mesh.triangles[t][k]).dimension(), 0);
    ASSERT_NE(triangle.line[k], none);
    EXPECT_TRUE(c.model.lines[triangle.line[k]].implicit) << "this edge was not given: it must not be written";
  }
  // If every triangle is required, nothing can change.
  for (Index i = 0; i < mesh.triangles.size(); ++i) mesh.required_triangles.push_back(i);
  const Classified all(mesh);
  EXPECT_EQ(all.count().patches, 6);
  EXPECT_EQ(all.frozen_patches(), 6);
}

TEST(Marks, RequiredTetrahedraAreAFrozenRegion) {
  Mesh mesh = test::two_regions(4);
  mesh.required_tetrahedra = {0, 100, 101};
  const Classified c(mesh);
  EXPECT_TRUE(c.model.has_frozen_region);
  std::vector<std::pair<int, bool>> regions;
  for (const Region& r : c.model.regions) regions.emplace_back(r.ref, r.frozen);
  std::size_t frozen = 0;
  for (const TetId t : ids<TetId>(c.built.mesh.tets.size()))
    frozen += regions[c.built.mesh.region_of_tet[t]].second ? 1 : 0;
  EXPECT_EQ(frozen, 3);
  for (const Index t : mesh.required_tetrahedra)
    for (const Index p : mesh.tetrahedra[t]) EXPECT_EQ(c.tag(p).dimension(), 0);
}

}  // namespace
}  // namespace taut
