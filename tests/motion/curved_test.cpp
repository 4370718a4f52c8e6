// Moving bodies between and with curved surfaces.
#include <gtest/gtest.h>

#include <array>

#include "motion/room.hpp"

namespace taut::test {
namespace {

double distance_from(const Geometry& geometry, const Mesh& mesh, int reference) {
  double farthest = 0;
  for (const Point& p : points_of(mesh, reference)) farthest = std::max(farthest, geometry.closest(p).distance);
  return farthest;
}

/// Its top and bottom are curved, as the top of the room is.
TEST(CurvedMotion, KeepsBodiesAndWallsOnTheirSurfaces) {
  const Mesh start = vault(room());
  const Geometry geometry(start);
  MovingMesh mesh(start, Sizes(start.points.size(), 0.09), {});
  const RigidMotion step = RigidMotion::translation({0.01, 0.005, 0});
  RigidMotion way;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
    way = step * way;
    EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  }
  for (const Point& p : points_of(mesh.mesh(), body)) EXPECT_LT(geometry.closest(way.inverse()(p)).distance, 1e-9);
  EXPECT_GT(points_of(mesh.mesh(), wall).size(), points_of(start, wall).size() * 5 / 4);
  EXPECT_LT(distance_from(geometry, mesh.mesh(), wall), 1e-9);
}

TEST(CurvedMotion, WithFlipsKeepsThePointsOfCurvedWallsOnTheirSurface) {
  const Mesh start = vault(room());
  MovingMesh mesh(start, Sizes(start.points.size(), 0.12), {.changes = MeshChanges::flips});
  for (int i = 0; i < 4; ++i) ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turn(9)}}).share, 1);
  EXPECT_EQ(mesh.points().size(), start.points.size());
  EXPECT_NE(points_of(mesh.mesh(), wall), points_of(start, wall));
  EXPECT_LT(distance_from(Geometry(start), mesh.mesh(), wall), 1e-9);
}

}  // namespace
}  // namespace taut::test
