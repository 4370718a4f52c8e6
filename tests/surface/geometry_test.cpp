#include "taut/geometry.hpp"

#include <gtest/gtest.h>

#include "sizing/curved_meshes.hpp"
#include "surface/surfaces.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

TEST(Geometry, IsMadeFromTetrahedraOrTheirTriangles) {
  Mesh mesh = test::cylinder(8, 1, 2);
  const Geometry whole(mesh);
  const std::vector<std::array<Index, 3>> triangles = std::exchange(mesh.triangles, {});
  const Geometry found(mesh);
  mesh.triangles = triangles;
  mesh.tetrahedra.clear();
  const Geometry alone(mesh);
  for (const Geometry& geometry : {whole, found, alone}) {
    EXPECT_EQ(geometry.patches(), 3U);
    EXPECT_EQ(geometry.ridges(), 2U);
    EXPECT_EQ(geometry.corners(), 0U);
    EXPECT_LT(norm(geometry.closest({2, 1, 1}).point - whole.closest({2, 1, 1}).point), 1e-12);
  }
}

TEST(Geometry, SaysAllOfTheClosestPoint) {
  Mesh mesh = test::tube(72, 28);
  mesh.triangle_refs.assign(mesh.triangles.size(), 7);
  const Geometry geometry(mesh);
  const ClosestPoint at = geometry.closest({0, 1.6, 0});
  EXPECT_LT(norm(at.point - Point{0, 1.35, 0}), 2e-4);
  EXPECT_LT(norm(at.normal - Point{0, 1, 0}), 1e-2);
  EXPECT_NEAR(at.distance, 0.25, 1e-4);
  EXPECT_EQ(at.reference, 7);
  EXPECT_NEAR(at.weights[0] + at.weights[1] + at.weights[2], 1, 1e-14);
  EXPECT_NEAR(at.curvatures[0], 1 / 1.35, 0.02);
  EXPECT_NEAR(at.curvatures[1], 1 / 0.35, 0.06);
  EXPECT_NEAR(std::abs(at.directions[0][0]), 1, 1e-3);
  EXPECT_NEAR(std::abs(at.directions[1][2]), 1, 1e-3);
}

TEST(Geometry, MayTakeRidgesByAngle) {
  Mesh mesh = test::sphere(4, 1);
  EXPECT_EQ(Geometry(mesh).ridges(), 0U);
  EXPECT_GT(Geometry(mesh, {.ridge_angle = 20}).ridges(), 0U);
  EXPECT_EQ(Geometry(mesh, {.ridge_angle = 60}).ridges(), 0U);
}

TEST(Geometry, ARequiredEdgePartsNoSmoothSurface) {
  const Mesh plain = test::tube(48, 24);
  Mesh mesh = plain;
  mesh.edges = {{plain.triangles[40][0], plain.triangles[40][1]}, {plain.triangles[200][1], plain.triangles[200][2]}};
  mesh.required_edges = {0, 1};
  const Geometry geometry(mesh);
  EXPECT_EQ(geometry.patches(), 1);
  EXPECT_EQ(geometry.ridges(), 0);
  EXPECT_EQ(geometry.corners(), 0);
  const Point& p = plain.points[plain.triangles[40][0]];
  EXPECT_EQ(geometry.closest(1.01 * p).point, Geometry(plain).closest(1.01 * p).point);
  mesh.ridges = {0};
  EXPECT_EQ(Geometry(mesh).ridges(), 1);
}

TEST(Geometry, IsSharedByItsCopies) {
  std::optional<Geometry> first(test::sphere(6, 1));
  const Geometry second = *first;
  EXPECT_EQ(&second.surface(), &first->surface());
  first.reset();
  EXPECT_NEAR(norm(second.closest({0, 0, 3}).point), 1, 1e-3);
}

std::string refused(const std::function<void()>& run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Geometry, RefusesWhatMakesNoSense) {
  Mesh mesh = test::sphere(3, 1);
  mesh.tetrahedra.clear();
  EXPECT_EQ(refused([&] { (void)Geometry(mesh, {.ridge_angle = 0}); }),
            "ridge angle 0 found, expected between 0 and 180 degrees");
  EXPECT_EQ(refused([&] { (void)Geometry(mesh).closest({0, std::nan(""), 0}); }), "coordinate nan is not finite");
  Mesh collapsed = mesh;
  collapsed.points[mesh.triangles[4][1]] = collapsed.points[mesh.triangles[4][0]];
  EXPECT_NE(refused([&] { (void)Geometry(collapsed); }).find(" lie at one place"), std::string::npos);
  mesh.triangles[4][1] = 100000;
  EXPECT_EQ(refused([&] { (void)Geometry(mesh); }).substr(0, 28), "triangle 5: vertex 100001 fo");
  mesh.triangles.clear();
  EXPECT_EQ(refused([&] { (void)Geometry(mesh); }),
            "the mesh has neither tetrahedra nor triangles, expected a surface");
}

/// Triangles without area have no normal, but are no reason to fail.
TEST(Geometry, BearsFlatTriangles) {
  Mesh mesh = test::sphere(6, 1);
  mesh.tetrahedra.clear();
  const auto [a, b, c] = mesh.triangles[0];
  mesh.points[c] = 0.5 * (mesh.points[a] + mesh.points[b]);
  const Geometry geometry(mesh);
  const ClosestPoint at = geometry.closest(mesh.points[c]);
  EXPECT_LT(at.distance, 1e-6);
  EXPECT_TRUE(std::isfinite(norm(at.normal)));
}

}  // namespace
}  // namespace taut
