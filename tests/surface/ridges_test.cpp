#include "surface/ridges.hpp"

#include <gtest/gtest.h>

#include <set>

#include "sizing/curved_meshes.hpp"
#include "surface/surface_input.hpp"
#include "surface/surfaces.hpp"

namespace taut {
namespace {

using Edge = std::array<VertexId, 2>;

std::set<Edge> ridges_of(const Mesh& mesh, std::optional<double> angle = {}) {
  SurfaceInput input = surface_of(mesh);
  std::set<Edge> found;
  for (const RidgeEdge& ridge : split_at_ridges(input.facets, input.refs, input.edges, angle).ridges)
    found.insert(ridge.edge);
  return found;
}

Mesh surface_alone(Mesh mesh) {
  mesh.tetrahedra.clear();
  return mesh;
}

/// The edges between points that fulfil a condition, which no triangle has two of.
std::set<Edge> edges_between(const Mesh& mesh, const std::function<bool(const Point&)>& is_on) {
  std::set<Edge> found;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      if (is_on(mesh.points[a]) && is_on(mesh.points[b])) found.insert({VertexId{a}, VertexId{b}});
    }
  return found;
}

std::set<Edge> without(std::set<Edge> edges, const std::set<Edge>& others) {
  std::erase_if(edges, [&](const Edge& e) { return others.contains(e); });
  return edges;
}

double largest_dihedral(const Mesh& mesh) {
  const SurfaceInput input = surface_of(mesh);
  const auto normals = unit_normals(input.facets);
  double least = 1;
  for_each_edge(edge_uses(input.facets.triangles), [&](std::span<const EdgeUse> uses) {
    if (uses.size() == 2) least = std::min(least, dot(normals[uses[0].triangle], normals[uses[1].triangle]));
  });
  return std::acos(least) * 180 / std::numbers::pi;
}

TEST(Ridges, NoneOnCoarseSpheres) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const Mesh mesh = surface_alone(test::sphere(4, seed));
    EXPECT_GT(largest_dihedral(mesh), 25);
    EXPECT_TRUE(ridges_of(mesh).empty());
    EXPECT_FALSE(ridges_of(mesh, 20).empty());
  }
}

/// Of 40 to 60 degrees an edge, where quadrics of the sides turn further than the triangles.
TEST(Ridges, NoneOnVeryCoarseSpheres) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U})
    EXPECT_TRUE(ridges_of(surface_alone(test::sphere(3, seed))).empty()) << seed;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 8U})
    EXPECT_TRUE(ridges_of(surface_alone(test::sphere(2, seed))).empty()) << seed;
}

/// A few edges look like ridges; these are not followed along the long rows of triangles.
TEST(Ridges, FewOnATorusOfLongTriangles) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U})
    EXPECT_LT(ridges_of(test::torus(24, seed, 0.4)).size(), 20U) << seed;
}

TEST(Ridges, NoneOnATube) {
  EXPECT_TRUE(ridges_of(test::tube(40, 16)).empty());
}

TEST(Ridges, OfRoofs) {
  for (const double angle : {20.0, 30.0, 60.0, 100.0, 150.0, 170.0}) {
    const Mesh mesh = test::roof(6, angle);
    const auto border = ridges_of(mesh, 179);
    EXPECT_EQ(without(ridges_of(mesh), border), edges_between(mesh, [](const Point& p) { return p[0] == 0.5; }));
  }
  const Mesh flat = test::roof(6, 12);
  EXPECT_EQ(ridges_of(flat), ridges_of(flat, 179));
}

TEST(Ridges, OfASheetFoldedBack) {
  const Mesh mesh = test::sheet({.nu = 6, .nv = 6, .fixed_u = 3}, [](double u, double v) {
    return Vec3{std::abs(u - 0.5), v, 0};
  });
  EXPECT_EQ(ridges_of(mesh).size(), 24U + 6);
}

/// Triangles turn by more than the ridge does, at the ridge and elsewhere.
TEST(Ridges, OfRimsBetweenCurvedSides) {
  for (const Index n : {16U, 24U}) {
    const Mesh mesh = test::lens(n, 20);
    EXPECT_EQ(without(ridges_of(mesh), ridges_of(mesh, 179)),
              edges_between(mesh, [](const Point& p) { return std::abs(p[2]) < 1e-12; }));
  }
}

TEST(Ridges, OfACylinderAreItsRims) {
  const Mesh mesh = surface_alone(test::cylinder(6, 1, 2));
  const auto ridges = ridges_of(mesh);
  EXPECT_EQ(ridges.size(), 2U * 4 * 6);
  for (const Edge& edge : ridges)
    for (const VertexId v : edge) {
      EXPECT_TRUE(mesh.points[v][2] == 0 || mesh.points[v][2] == 2);
      EXPECT_NEAR(std::hypot(mesh.points[v][0], mesh.points[v][1]), 1, 1e-9);
    }
}

TEST(Ridges, NoneAtTheTipOfACone) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Mesh mesh = test::cone(12, 1.5, seed);
    EXPECT_EQ(ridges_of(mesh), ridges_of(mesh, 179)) << seed;
  }
  for (const unsigned seed : {16U, 25U, 38U}) {  // with ridges on three rings of triangles, or with closed ones
    const Mesh mesh = test::cone(12, 2, seed);
    EXPECT_EQ(ridges_of(mesh), ridges_of(mesh, 179)) << seed;
  }
}

/// All edges of the triangles there turn sharply.
TEST(Ridges, NoneAtATipOfThreeTriangles) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    const Mesh mesh = test::cone(12, 1.5, seed, 3);
    EXPECT_EQ(ridges_of(mesh), ridges_of(mesh, 179)) << seed;
  }
}

TEST(Ridges, OfACubeWithTwoTrianglesASide) {
  Mesh mesh = surface_alone(test::cube(1));
  mesh.triangle_refs.clear();
  EXPECT_EQ(ridges_of(mesh).size(), 12U);
}

TEST(Ridges, GivenEdgesAreNoneWhereTheSurfaceIsSmooth) {
  Mesh mesh = surface_alone(test::sphere(6, 3));
  for (std::size_t t = 0; t < 60; ++t) mesh.edges.push_back({mesh.triangles[t][0], mesh.triangles[t][1]});
  EXPECT_TRUE(ridges_of(mesh).empty());
  mesh.ridges = {2};
  const auto [a, b] = std::minmax(mesh.edges[2][0], mesh.edges[2][1]);
  EXPECT_EQ(ridges_of(mesh), (std::set<Edge>{{VertexId{a}, VertexId{b}}}));
}

TEST(Ridges, GivenEdgesNeedTurnByLess) {
  Mesh mesh = test::roof(6, 8);
  const auto border = ridges_of(mesh);
  const auto line = edges_between(mesh, [](const Point& p) { return p[0] == 0.5; });
  for (const auto& [a, b] : line) mesh.edges.push_back({a, b});
  EXPECT_EQ(without(ridges_of(mesh), border), line);
}

TEST(Ridges, BetweenReferences) {
  Mesh mesh = surface_alone(test::sphere(6, 4));
  for (const auto& t : mesh.triangles) mesh.triangle_refs.push_back(test::centre_of(mesh, t)[0] > 0.3 ? 1 : 2);
  const auto ridges = ridges_of(mesh);
  EXPECT_GT(ridges.size(), 10U);
  EXPECT_EQ(ridges, ridges_of(mesh, 179));
}

TEST(Ridges, DoNotDependOnTheSenseOfTriangles) {
  Mesh mesh = surface_alone(test::cylinder(6, 1, 2));
  const auto plain = ridges_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  EXPECT_EQ(ridges_of(mesh), plain);
}

/// One edge remains at which the sides cannot agree.
TEST(Ridges, AMoebiusStripIsParted) {
  constexpr Index n = 30;
  Mesh mesh = test::sheet({.nu = n, .nv = 2, .jitter = 0}, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, r = 1 + 0.3 * (v - 0.5) * std::cos(a / 2);
    return Vec3{r * std::cos(a), r * std::sin(a), 0.3 * (v - 0.5) * std::sin(a / 2)};
  });
  for (auto& t : mesh.triangles)
    for (Index& v : t)
      if (v % (n + 1) == n) v = (2 - v / (n + 1)) * (n + 1);
  EXPECT_EQ(ridges_of(mesh, 179).size(), 2 * n + 2);
}

}  // namespace
}  // namespace taut
