// Coarse bodies that lie on the surface of a finer mesh while they move.
#include <gtest/gtest.h>

#include "adapt/hash.hpp"
#include "motion/round_room.hpp"

namespace taut::test {
namespace {

constexpr double radius = 0.18, on_it = 1e-9;

double farthest(const Geometry& geometry, const RigidMotion& way, const Mesh& mesh, int reference) {
  double distance = 0;
  for (const Point& p : points_of(mesh, reference))
    distance = std::max(distance, geometry.closest(way.inverse()(p)).distance);
  return distance;
}

MotionOptions on(const Geometry& geometry, MeshChanges changes, int rounds_at_first) {
  return {.changes = changes, .adaptation = {.geometry = geometry, .max_rounds = rounds_at_first}};
}

Mesh coarse_ball() {
  Mesh mesh = room_with_ellipsoid({radius, radius, radius}, 6);
  for (Point& p : mesh.points)  // off the fine surface
    if (distance_from_middle(p) < 0.25) p = middle + (1 + 0.02 * std::sin(40 * p[0])) * (p - middle);
  return mesh;
}

Mesh fine_ball() {
  return room_with_ellipsoid({radius, radius, radius}, 18);
}

TEST(GivenGeometry, IsCarriedWithABallThatTravelsAndTurns) {
  const Geometry geometry(fine_ball());
  const Mesh start = coarse_ball();
  ASSERT_GT(farthest(geometry, {}, start, body), 1e-3);
  for (const MeshChanges changes : {MeshChanges::flips, MeshChanges::all})
    for (const int rounds_at_first : {0, 10}) {
      MovingMesh mesh(start, Sizes(start.points.size(), 0.12), on(geometry, changes, rounds_at_first));
      if (rounds_at_first > 0) {
        EXPECT_LT(farthest(geometry, {}, mesh.mesh(), body), on_it);
      }
      const RigidMotion step = RigidMotion::translation({0.015, 0.01, 0.005}) * turn(5);
      RigidMotion way;
      for (int i = 0; i < 6; ++i) {
        ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
        way = step * way;
        EXPECT_LT(farthest(geometry, way, mesh.mesh(), body), on_it) << "step " << i;
        EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
      }
    }
}

TEST(GivenGeometry, CountsWhatIsOffIt) {
  const Geometry geometry(fine_ball());
  const Mesh start = coarse_ball();
  const auto off_after = [&](MeshChanges changes) {
    MovingMesh mesh(start, Sizes(start.points.size(), 0.12), on(geometry, changes, 0));
    return mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.015, 0.01, 0.005})}}).off_surface;
  };
  EXPECT_GT(off_after(MeshChanges::nothing), 0U) << "only rounds bring vertices onto it";
  EXPECT_EQ(off_after(MeshChanges::flips), 0U);
}

TEST(GivenGeometry, LeavesWhatDoesNotMoveWhereItIs) {
  const Mesh hill = vault(room(9, 0.15));
  Mesh fine = hill;
  fine.tetrahedra.clear();
  fine.tetrahedron_refs.clear();
  const Geometry geometry(fine);
  MovingMesh mesh(hill, Sizes(hill.points.size(), 0.12), on(geometry, MeshChanges::all, 10));
  const RigidMotion step = RigidMotion::translation({0.02, 0, 0});
  RigidMotion way;
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
    way = step * way;
    EXPECT_LT(farthest(geometry, {}, mesh.mesh(), wall), on_it);
    EXPECT_LT(farthest(geometry, way, mesh.mesh(), body), on_it);
  }
}

/// A cube with curved sides. With `off`, its corners are off their places, too.
Mesh bulging_cube(Index cells, double off) {
  Mesh mesh = shaped_room(cells, [off](const Vec3& q) {
    Vec3 p = 0.16 * q;
    for (std::size_t d = 0; d < 3; ++d) p[d] *= 1 + 0.15 * (1 - q[(d + 1) % 3] * q[(d + 1) % 3]);
    return (1 + off * q[0]) * p;
  });
  return mesh;
}

TEST(GivenGeometry, TakesCornersAlong) {
  const Geometry geometry(bulging_cube(18, 0));
  const Mesh start = bulging_cube(6, 0.02);
  std::vector<Point> corners;
  for (const double x : {-0.16, 0.16})
    for (const double y : {-0.16, 0.16})
      for (const double z : {-0.16, 0.16}) corners.push_back(middle + Vec3{x, y, z});
  MovingMesh mesh(start, Sizes(start.points.size(), 0.12), on(geometry, MeshChanges::all, 0));
  const RigidMotion step = RigidMotion::translation({0.01, 0.005, 0}) * turn(6);
  RigidMotion way;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
    way = step * way;
    const std::vector<Point> points = points_of(mesh.mesh(), body);
    for (const Point& corner : corners)
      EXPECT_TRUE(std::ranges::any_of(points, [&](const Point& p) { return norm(p - way(corner)) < on_it; }));
    EXPECT_LT(farthest(geometry, way, mesh.mesh(), body), on_it);
  }
}

TEST(GivenGeometry, IsLeftWherePointsMoveOneByOne) {
  const Geometry geometry(fine_ball());
  const Mesh start = coarse_ball();
  MovingMesh mesh(start, Sizes(start.points.size(), 0.12), on(geometry, MeshChanges::flips, 0));
  std::vector<PointMotion> motions;
  const std::vector<Point> before = points_of(start, body);
  for (Index v = 0; v < start.points.size(); ++v)
    if (std::ranges::binary_search(before, start.points[v])) motions.push_back({v, {0.01, 0, 0}});
  ASSERT_EQ(mesh.advance(motions).share, 1);
  std::vector<Point> expected = before;
  for (Point& p : expected) p[0] += 0.01;
  expect_near(points_of(mesh.mesh(), body), expected, 1e-12);
}

TEST(GivenGeometry, HasTheSameBitsOnAnyNumberOfThreads) {
  const Geometry geometry(fine_ball());
  const Mesh start = coarse_ball();
  const auto hash_on = [&](int threads) {
    MotionOptions options = on(geometry, MeshChanges::all, 5);
    options.adaptation.threads = threads;
    options.adaptation.block_size = 200;
    MovingMesh mesh(start, Sizes(start.points.size(), 0.1), options);
    for (int i = 0; i < 3; ++i) (void)mesh.advance(std::array{BodyMotion{body, turn(10)}});
    return hash_of(mesh.mesh(), mesh.metric());
  };
  const std::uint64_t hash = hash_on(1);
  EXPECT_EQ(hash_on(2), hash);
  EXPECT_EQ(hash_on(3), hash);
}

}  // namespace
}  // namespace taut::test
