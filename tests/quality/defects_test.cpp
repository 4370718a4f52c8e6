#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/vec3.hpp"
#include "base/with_threads.hpp"
#include "mesh/faces.hpp"
#include "mesh/grid.hpp"
#include "taut/quality.hpp"

namespace taut {
namespace {

/// A grid with a triangle on each boundary face.
Mesh sound() {
  Mesh mesh = test::grid(2);
  const auto by_vertex = faces_of(mesh.tetrahedra, mesh.points.size());
  const auto faces = by_vertex.all();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool before = i > 0 && faces[i - 1].vertices == faces[i].vertices;
    const bool after = i + 1 < faces.size() && faces[i + 1].vertices == faces[i].vertices;
    if (!before && !after) mesh.triangles.push_back(faces[i].vertices);
  }
  return mesh;
}

void expect_defect(const Mesh& mesh, const std::string& expected) {
  const auto found = defects(mesh);
  for (const std::string& defect : found) {
    if (defect.starts_with(expected)) return;
  }
  ADD_FAILURE() << "expected: " << expected << "\nfound: " << testing::PrintToString(found);
}

TEST(Defects, OverlappingNeighbours) {
  Mesh mesh = test::grid(4);  // with its middle vertex moved beyond its ball
  mesh.points[62] = {0.85, 0.605, 0.535};
  for (auto& v : mesh.tetrahedra)
    if (six_volumes(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) < 0)
      std::swap(v[0], v[1]);
  expect_defect(mesh, "tetrahedra that overlap a neighbour");
}

TEST(Defects, OfASoundMeshAreNone) {
  const Mesh mesh = sound();
  EXPECT_EQ(mesh.triangles.size(), 6 * 4 * 2);
  EXPECT_EQ(defects(mesh), std::vector<std::string>{});
}

TEST(Defects, IndicesOutOfRange) {
  Mesh mesh = sound();
  mesh.tetrahedra[5][1] = 27;
  expect_defect(mesh, "tetrahedra with an index out of range: 1, the first is number 6");
  mesh = sound();
  mesh.ridges = {0};
  expect_defect(mesh, "ridges with an index out of range: 1, the first is number 1");
  mesh = sound();
  mesh.corners = {0, 26, 27};
  expect_defect(mesh, "corners with an index out of range: 1, the first is number 3");
}

TEST(Defects, NumbersOfReferences) {
  Mesh mesh = sound();
  mesh.triangle_refs = {1};
  expect_defect(mesh, "references of triangles: 1 found, expected 48 or none");
}

TEST(Defects, CoordinatesThatAreNotFinite) {
  Mesh mesh = sound();
  mesh.points[3][2] = std::numeric_limits<double>::quiet_NaN();
  mesh.points[9][0] = std::numeric_limits<double>::infinity();
  expect_defect(mesh, "points with a coordinate that is not finite: 2, the first is number 4");
}

TEST(Defects, Orientation) {
  Mesh mesh = sound();
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  expect_defect(mesh, "inverted tetrahedra: 1, the first is number 8");
  mesh = sound();
  mesh.points[13] = {0.5, 0.5, 0};
  expect_defect(mesh, "flat tetrahedra");
}

TEST(Defects, Faces) {
  Mesh mesh = sound();
  const auto faces = faces_of(mesh.tetrahedra, mesh.points.size());
  const auto shared = std::ranges::adjacent_find(faces.all(), {}, &Face::vertices);
  mesh.tetrahedra.push_back({shared->vertices[0], shared->vertices[1], shared->vertices[2], 26});
  expect_defect(mesh, "faces shared by more than two tetrahedra");
  mesh = sound();
  mesh.triangles.pop_back();
  expect_defect(mesh, "boundary faces without a triangle (numbers of tetrahedra): 1");
  mesh = sound();
  mesh.triangles.push_back({0, 13, 26});
  expect_defect(mesh, "triangles that are not a face of any tetrahedron: 1, the first is number 49");
}

TEST(Defects, RegionsWithoutTrianglesBetween) {
  Mesh mesh = sound();
  mesh.tetrahedron_refs.assign(mesh.tetrahedra.size(), 1);
  EXPECT_TRUE(defects(mesh).empty());
  mesh.tetrahedron_refs[0] = 2;
  expect_defect(mesh, "faces between regions without a triangle");
}

TEST(Defects, Duplicates) {
  Mesh mesh = sound();
  mesh.tetrahedra.push_back(mesh.tetrahedra[3]);
  expect_defect(mesh, "duplicate tetrahedra: 1, the first is number 49");
  mesh = sound();
  mesh.triangles.push_back({mesh.triangles[4][1], mesh.triangles[4][2], mesh.triangles[4][0]});
  expect_defect(mesh, "duplicate triangles: 1, the first is number 49");
  mesh = sound();
  mesh.edges = {{0, 1}, {1, 2}, {1, 0}};
  expect_defect(mesh, "duplicate edges: 1, the first is number 3");
}

TEST(Defects, UnusedPoints) {
  Mesh mesh = sound();
  mesh.points.push_back({5, 5, 5});
  expect_defect(mesh, "points that belong to no tetrahedron: 1, the first is number 28");
}

TEST(Defects, AreTheSameOnAnyNumberOfThreads) {
  Mesh mesh = test::grid(28);
  mesh.triangles.assign(20000, {0, 13, 26});
  mesh.tetrahedron_refs.assign(mesh.tetrahedra.size(), 1);
  mesh.points.push_back({5, 5, 5});
  for (const std::size_t t : {30000U, 70000U, 110000U}) {
    std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][1]);
    mesh.tetrahedra[t + 5] = mesh.tetrahedra[t];
    mesh.tetrahedron_refs[t + 9] = 2;
  }
  const auto compute = [&] { return defects(mesh); };
  const auto found = test::with_threads(1, compute);
  EXPECT_EQ(found[0], "inverted tetrahedra: 6, the first is number 30001");
  EXPECT_EQ(found.back(), "points that belong to no tetrahedron: 1, the first is number 24390");
  EXPECT_EQ(test::with_threads(3, compute), found);
}

}  // namespace
}  // namespace taut
