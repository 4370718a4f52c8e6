#include "mesh/build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "base/with_threads.hpp"
#include "mesh/invariants.hpp"
#include "mesh/shapes.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using test::cube;
using test::two_regions;

std::multiset<std::array<Index, 4>> sorted_tets(const Mesh& mesh) {
  std::multiset<std::array<Index, 4>> tets;
  for (auto t : mesh.tetrahedra) {
    std::sort(t.begin(), t.end());
    tets.insert(t);
  }
  return tets;
}

// The tetrahedra of the built mesh in the numbers of the input.
std::multiset<std::array<Index, 4>> sorted_tets(const TetMesh& mesh) {
  std::multiset<std::array<Index, 4>> tets;
  for (const Tet& tet : mesh.tets) {
    std::array<Index, 4> v{};
    for (int k = 0; k < 4; ++k) v[k] = mesh.origin_of_vertex[tet.v[k]];
    std::sort(v.begin(), v.end());
    tets.insert(v);
  }
  return tets;
}

void expect_faithful(const Mesh& input, const Built& built) {
  EXPECT_EQ(first_broken_invariant(built.mesh), "");
  EXPECT_EQ(sorted_tets(built.mesh), sorted_tets(input));
  for (Index p = 0; p < input.points.size(); ++p) {
    const VertexId v = built.vertex_of_point[p];
    if (v == none) continue;
    EXPECT_EQ(built.mesh.x(v), input.points[p]);
    EXPECT_EQ(built.mesh.origin_of_vertex[v], p);
  }
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const Triangle& triangle = built.mesh.triangles[built.triangle_of_input[t]];
    for (Index p : input.triangles[t])
      EXPECT_NE(std::ranges::find(triangle.v, built.vertex_of_point[p]), triangle.v.end());
    const int ref = input.triangle_refs.empty() ? 0 : input.triangle_refs[t];
    EXPECT_EQ(built.triangle_refs[built.triangle_of_input[t]], ref);
  }
}

TEST(Build, KeepsWhatItIsGiven) {
  for (const Mesh& mesh : {cube(3), two_regions(4), test::l_shape(2), test::vault(cube(4)), test::ball(cube(4))}) {
    const Built built = build(mesh);
    expect_faithful(mesh, built);
    EXPECT_EQ(built.reoriented, 0);
    EXPECT_EQ(built.triangles_built, 0);
    EXPECT_EQ(built.mesh.triangles.size(), mesh.triangles.size());
  }
}

TEST(Build, PassesOverUnusedPoints) {
  Mesh mesh = cube(2);
  mesh.points.insert(mesh.points.begin(), Point{5, 5, 5});
  for (auto& t : mesh.tetrahedra)
    for (Index& v : t) ++v;
  for (auto& t : mesh.triangles)
    for (Index& v : t) ++v;
  const Built built = build(mesh);
  expect_faithful(mesh, built);
  EXPECT_EQ(built.vertex_of_point[0], none);
  EXPECT_EQ(built.mesh.vertex_count(), 27);
}

TEST(Build, MakesMissingTriangles) {
  Mesh mesh = two_regions(4);
  const std::size_t all = mesh.triangles.size();
  EXPECT_EQ(all, 6 * 32 + 32);
  std::erase_if(mesh.triangles, [&](const auto& t) { return (&t - mesh.triangles.data()) % 3 != 0; });
  mesh.triangle_refs.clear();
  const Built built = build(mesh);
  expect_faithful(mesh, built);
  EXPECT_EQ(built.mesh.triangles.size(), all);
  EXPECT_EQ(built.triangles_built, all - mesh.triangles.size());
  EXPECT_EQ(built.triangle_refs, std::vector<int>(all, 0));
}

TEST(Build, TurnsInvertedTetrahedra) {
  Mesh mesh = cube(2);
  for (const std::size_t t : {0, 7, 8, 31}) std::swap(mesh.tetrahedra[t][1], mesh.tetrahedra[t][2]);
  const Built built = build(mesh);
  expect_faithful(mesh, built);
  EXPECT_EQ(built.reoriented, 4);
}

TEST(Build, TurnsBoundaryTrianglesOutwardAndLeavesThoseBetweenRegions) {
  Mesh mesh = two_regions(2);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  const Built built = build(mesh);
  expect_faithful(mesh, built);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = built.mesh.triangles[built.triangle_of_input[i]];
    const Vec3 normal = cross(built.mesh.x(t.v[1]) - built.mesh.x(t.v[0]), built.mesh.x(t.v[2]) - built.mesh.x(t.v[0]));
    const bool between = mesh.triangle_refs[i] == 7;
    EXPECT_EQ(t.side[1] != outside, between);
    EXPECT_EQ(dot(normal, test::area_normal(mesh, mesh.triangles[i])) > 0, between);
  }
}

TEST(Build, KeepsATriangleInsideARegion) {
  Mesh mesh = cube(2);
  mesh.triangles.push_back({mesh.tetrahedra[0][0], mesh.tetrahedra[0][1], mesh.tetrahedra[0][3]});
  mesh.triangle_refs.push_back(9);
  const Built built = build(mesh);
  expect_faithful(mesh, built);
  EXPECT_EQ(built.triangles_built, 0);
}

TEST(Build, NumbersRegionsByReference) {
  Mesh mesh = two_regions(2);
  for (int& ref : mesh.tetrahedron_refs) ref = ref == 1 ? 30 : -4;
  mesh.required_tetrahedra = {0, 1};
  const Built built = build(mesh);
  EXPECT_EQ(built.region_refs, (std::vector<int>{-4, 30, 30}));
  EXPECT_EQ(built.region_required, (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_EQ(std::ranges::count(built.mesh.region_of_tet, RegionId{2}), 2);
  EXPECT_EQ(built.triangles_built, 0) << "required tetrahedra have the reference of their neighbours";
  EXPECT_EQ(first_broken_invariant(built.mesh, built.region_refs), "");
}

void expect_refused(const Mesh& mesh, const std::string& message) {
  try {
    (void)build(mesh);
    ADD_FAILURE() << "not refused: " << message;
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), message);
  }
}

template <class Damage>
void expect_refused(Damage damage, const std::string& message) {
  Mesh mesh = cube(2);
  damage(mesh);
  expect_refused(mesh, message);
}

TEST(Build, RefusesWhatIsNoMesh) {
  expect_refused(Mesh{}, "the mesh has no tetrahedra");
  expect_refused([](Mesh& m) { m.points[4][1] = std::numeric_limits<double>::quiet_NaN(); },
                 "vertex 5: coordinate nan is not finite");
  expect_refused([](Mesh& m) { m.points[0][2] = std::numeric_limits<double>::infinity(); },
                 "vertex 1: coordinate inf is not finite");
  expect_refused([](Mesh& m) { m.tetrahedra[7][2] = 27; }, "tetrahedron 8: vertex 28 found, expected 1..27");
  expect_refused([](Mesh& m) { m.triangles[3][0] = 99; }, "triangle 4: vertex 100 found, expected 1..27");
  expect_refused([](Mesh& m) { m.edges = {{0, 1}, {2, 27}}; }, "edge 2: vertex 28 found, expected 1..27");
  expect_refused([](Mesh& m) { m.tetrahedra[1] = {3, 4, 5, 4}; }, "tetrahedron 2 (4 5 6 5) repeats vertex 5");
  expect_refused([](Mesh& m) { m.triangles[0] = {8, 8, 1}; }, "triangle 1 (9 9 2) repeats vertex 9");
  expect_refused([](Mesh& m) { m.edges = {{6, 6}}; }, "edge 1 (7 7) repeats vertex 7");
}

TEST(Build, RefusesMarksAndReferencesThatDoNotFit) {
  expect_refused(
      [](Mesh& m) {
        m.tetrahedron_refs = {1, 2};
      },
      "2 references found, expected 48, one for each of the tetrahedra");
  expect_refused([](Mesh& m) { m.triangle_refs.pop_back(); },
                 "47 references found, expected 48, one for each of the triangles");
  expect_refused([](Mesh& m) { m.point_refs = {1}; }, "1 references found, expected 27, one for each of the vertices");
  expect_refused([](Mesh& m) { m.edge_refs = {1}; }, "1 references found, expected 0, one for each of the edges");
  expect_refused([](Mesh& m) { m.corners = {0, 27}; }, "corner 2: 28 found, expected 1..27");
  expect_refused([](Mesh& m) { m.required_points = {30}; }, "required vertex 1: 31 found, expected 1..27");
  expect_refused([](Mesh& m) { m.ridges = {0}; }, "ridge 1: 1 found, expected 1..0");
  expect_refused([](Mesh& m) { m.required_edges = {0}; }, "required edge 1: 1 found, expected 1..0");
  expect_refused([](Mesh& m) { m.required_triangles = {48}; }, "required triangle 1: 49 found, expected 1..48");
  expect_refused([](Mesh& m) { m.required_tetrahedra = {5, 48}; }, "required tetrahedron 2: 49 found, expected 1..48");
}

TEST(Build, RefusesWhatDoesNotFitTogether) {
  // Moved onto the plane of the others, exactly.
  Mesh flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.5, 0}};
  flat.tetrahedra = {{0, 1, 2, 3}};
  expect_refused(flat, "tetrahedron 1 (1 2 3 4) is flat: its volume is exactly zero");

  Mesh crowded;
  crowded.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}};
  crowded.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}};
  try {
    (void)build(crowded);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.ends_with("is shared by more than two tetrahedra")) << message;
    for (const char digit : {'1', '2', '3'}) EXPECT_NE(message.find(digit), std::string::npos) << message;
  }
  expect_refused(
      [](Mesh& m) {
        m.triangles[2] = {0, 13, 26};
      },
      "triangle 3 (1 14 27) is not a face of any tetrahedron");
  expect_refused(
      [](Mesh& m) {
        m.points.push_back({7, 7, 7});
        m.triangles[2][1] = 27;
        m.triangles[2][0] = 0;
        m.triangles[2][2] = 1;
      },
      "triangle 3 (1 28 2) is not a face of any tetrahedron");
  expect_refused(
      [](Mesh& m) {
        m.triangles.push_back({m.triangles[5][1], m.triangles[5][0], m.triangles[5][2]});
        m.triangle_refs.push_back(0);
      },
      "triangle 49 repeats triangle 6");
}

// Many times the number of entities of one task.
const Mesh& large() {
  static const Mesh mesh = [] {
    Mesh made = test::grid(28);
    test::jitter(made, 0.004, 1);
    for (const auto& t : made.tetrahedra) made.tetrahedron_refs.push_back(test::centre_of(made, t)[0] < 0.5 ? 1 : 2);
    for (std::size_t t = 0; t < made.tetrahedra.size(); t += 1000)
      std::swap(made.tetrahedra[t][0], made.tetrahedra[t][1]);
    return made;
  }();
  return mesh;
}

TEST(Build, IsTheSameOnAnyNumberOfThreads) {
  const Built one = test::with_threads(1, [] { return build(large()); });
  const Built three = test::with_threads(3, [] { return build(large()); });
  expect_faithful(large(), one);
  EXPECT_EQ(one.triangles_built, 6 * 28 * 28 * 2 + 28 * 28 * 2);
  EXPECT_EQ(one.reoriented, 132);
  EXPECT_EQ(one.region_refs, (std::vector<int>{1, 2}));
  EXPECT_EQ(one.vertex_of_point, three.vertex_of_point);
  EXPECT_EQ(one.mesh.tet_of_vertex, three.mesh.tet_of_vertex);
  EXPECT_EQ(one.mesh.origin_of_vertex, three.mesh.origin_of_vertex);
  EXPECT_EQ(one.mesh.region_of_tet, three.mesh.region_of_tet);
  const auto same_tet = [](const Tet& a, const Tet& b) { return a.v == b.v && a.n == b.n; };
  EXPECT_TRUE(std::ranges::equal(one.mesh.tets, three.mesh.tets, same_tet));
  const auto same_triangle = [](const Triangle& a, const Triangle& b) { return a.v == b.v && a.side == b.side; };
  EXPECT_TRUE(std::ranges::equal(one.mesh.triangles, three.mesh.triangles, same_triangle));
}

template <class Damage>
void expect_refused_alike(Damage damage, const std::string& message) {
  Mesh mesh = large();
  damage(mesh);
  for (const int threads : {1, 3}) EXPECT_EQ(test::refusal(threads, [&] { return build(mesh); }), message);
}

TEST(Build, RefusesTheFirstOfSeveralOnAnyNumberOfThreads) {
  expect_refused_alike([](Mesh& m) { m.points[17000][2] = m.points[24000][1] = m.points[3000][0] = INFINITY; },
                       "vertex 3001: coordinate inf is not finite");
  expect_refused_alike(
      [](Mesh& m) { m.tetrahedra[20000][1] = m.tetrahedra[120000][0] = m.tetrahedra[70000][2] = 99999; },
      "tetrahedron 20001: vertex 100000 found, expected 1..24389");
  expect_refused_alike(
      [](Mesh& m) {
        m.triangles.assign(40000, {0, 1, 29 * 29});
        m.triangles[17000] = m.triangles[39000] = {5, 6, 5};
      },
      "triangle 17001 (6 7 6) repeats vertex 6");
  const auto add_tet = [](Mesh& m, std::size_t t, double z) {  // two of them are in different tasks
    auto v = m.tetrahedra[t];
    v[3] = static_cast<Index>(m.points.size());
    m.points.push_back({0.5, 0.5, z});
    m.tetrahedra.push_back(v);
    m.tetrahedron_refs.push_back(1);
  };
  Mesh crowded = large();
  add_tet(crowded, 20000, 9);
  add_tet(crowded, 120000, -9);
  const std::string message = test::refusal(1, [&] { return build(crowded); });
  EXPECT_TRUE(message.ends_with("is shared by more than two tetrahedra")) << message;
  EXPECT_EQ(test::refusal(3, [&] { return build(crowded); }), message);
}

TEST(Build, RefusesMoreRegionsThanIdsHold) {
  Mesh mesh = test::grid(23);  // 73,002 tetrahedra
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) mesh.tetrahedron_refs.push_back(static_cast<int>(t));
  expect_refused(mesh, "73002 regions found, expected at most 65535");
}

}  // namespace
}  // namespace taut
