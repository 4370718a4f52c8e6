// Curved bodies whose triangles are adapted while they move.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "adapt/hash.hpp"
#include "motion/round_room.hpp"

namespace taut::test {
namespace {

constexpr double on_it = 1e-9;  // how near to the surface Newton's method ends
const Vec3 axes = {0.2, 0.14, 0.16};

double farthest(const Geometry& geometry, const RigidMotion& way, const std::vector<Point>& points) {
  double distance = 0;
  for (const Point& p : points) distance = std::max(distance, geometry.closest(way.inverse()(p)).distance);
  return distance;
}

/// How far the points are from the ellipsoid itself, about.
double error(const RigidMotion& way, const std::vector<Point>& points) {
  double worst = 0;
  for (const Point& p : points) {
    const Vec3 q = Vec3{way.inverse()(p)} - middle;
    const double level = std::hypot(q[0] / axes[0], q[1] / axes[1], q[2] / axes[2]);
    worst = std::max(worst, std::abs(level - 1) * norm(q));
  }
  return worst;
}

/// How far the curved surface of the mesh is from the ellipsoid, of which its points are part.
double error_of_surface(const Mesh& mesh, const Geometry& geometry) {
  std::vector<Point> on_surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_refs[t] != body) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    constexpr int n = 6;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vec3 x = (1.0 / n) * (i * mesh.points[a] + j * mesh.points[b] + (n - i - j) * mesh.points[c]);
        on_surface.push_back(geometry.closest(x).point);
      }
  }
  return error({}, on_surface);
}

double volume_of_body(const Mesh& mesh) {
  return 1 - volume_of(mesh);
}

MotionOptions adapting(MeshChanges changes) {
  return {.changes = changes, .adaptation = {.max_rounds = 10}};
}

class CurvedBody : public testing::TestWithParam<MeshChanges> {};

TEST_P(CurvedBody, StaysOnItsSurfaceWhileItTravels) {
  const Mesh start = room_with_ellipsoid({0.18, 0.18, 0.18});
  const Geometry geometry(start);
  MovingMesh mesh(start, Sizes(start.points.size(), 0.08), adapting(GetParam()));
  const RigidMotion step = RigidMotion::translation({0.015, 0.01, 0.005});
  RigidMotion way;
  for (int i = 0; i < 6; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
    way = step * way;
    EXPECT_LT(farthest(geometry, way, points_of(mesh.mesh(), body)), on_it);
    EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  }
}

TEST_P(CurvedBody, TurnsOnceWithoutDrift) {
  const Mesh start = room_with_ellipsoid(axes);
  const Geometry geometry(start);
  constexpr double size = 0.08;
  MovingMesh mesh(start, Sizes(start.points.size(), size), adapting(GetParam()));
  constexpr int steps = 72;
  const RigidMotion step = turn(360.0 / steps);
  RigidMotion way;
  const double most_error = 1.1 * error_of_surface(start, geometry);
  double first_volume = 0;
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
    way = step * way;
    const std::vector<Point> points = points_of(mesh.mesh(), body);
    ASSERT_LT(farthest(geometry, way, points), on_it);
    ASSERT_LT(error(way, points), most_error);
    if (i == 0) first_volume = volume_of_body(mesh.mesh());
    ASSERT_NEAR(volume_of_body(mesh.mesh()), first_volume, 0.01 * first_volume);
  }
  const Quality quality = measure(mesh.mesh(), mesh.metric());
  EXPECT_LT(quality.Q_max, 8);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

/// A uniform state stays uniform although the domain changes a little with the triangles of the body.
TEST_P(CurvedBody, KeepsAUniformState) {
  const Mesh start = room_with_ellipsoid(axes);
  MovingMesh mesh(start, Sizes(start.points.size(), 0.08), adapting(GetParam()));
  mesh.set_fields({{.values = std::vector<double>(mesh.points().size(), 1.25)}});
  for (int i = 0; i < 8; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turn(10)}}).share, 1);
    ASSERT_EQ(mesh.fields()[0].values.size(), mesh.points().size());
    for (const double value : mesh.fields()[0].values) ASSERT_NEAR(value, 1.25, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Motion, CurvedBody, testing::Values(MeshChanges::flips, MeshChanges::all));

TEST(CurvedBodies, GetFinerAndCoarserWhileTheyMove) {
  const Mesh start = room_with_ellipsoid(axes);
  const Geometry geometry(start);
  MovingMesh mesh(start, Sizes(start.points.size(), 0.08), adapting(MeshChanges::all));
  const RigidMotion step = turn(5);
  RigidMotion way;
  std::vector<std::size_t> counts;
  for (const double size : {0.08, 0.05, 0.08}) {
    mesh.set_metric(
        [size](const Point&) { return Tensor{1 / (size * size), 0, 0, 1 / (size * size), 0, 1 / (size * size)}; });
    for (int i = 0; i < 4; ++i) {
      ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, step}}).share, 1);
      way = step * way;
    }
    EXPECT_LT(farthest(geometry, way, points_of(mesh.mesh(), body)), on_it);
    counts.push_back(points_of(mesh.mesh(), body).size());
  }
  EXPECT_GT(counts[1], counts[0] * 3 / 2);
  EXPECT_LT(counts[2], 1.2 * static_cast<double>(counts[0]));
}

TEST(CurvedBodies, StayAsTheyAreIfOnlyPlanarPatchesMayChange) {
  const Mesh start = room_with_ellipsoid(axes);
  MotionOptions options = adapting(MeshChanges::all);
  options.adaptation.surface = Surface::planar;
  MovingMesh mesh(start, Sizes(start.points.size(), 0.06), options);
  const double before = volume_of(mesh.mesh());
  for (int i = 0; i < 9; ++i) {
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turn(40)}}).share, 1);
    EXPECT_NEAR(volume_of(mesh.mesh()), before, 1e-12);
  }
  expect_near(points_of(mesh.mesh(), body), points_of(start, body), 1e-10);
}

TEST(CurvedBodies, ThatMovePointByPointStayAsTheyAre) {
  const Mesh start = room_with_ellipsoid(axes);
  MovingMesh mesh(start, Sizes(start.points.size(), 0.06), {});
  std::vector<PointMotion> motions;
  for (Index v = 0; v < start.points.size(); ++v)
    if (std::ranges::binary_search(points_of(start, body), start.points[v])) motions.push_back({v, {0.01, 0, 0}});
  ASSERT_EQ(mesh.advance(motions).share, 1);
  const std::vector<Point> moved = points_of(mesh.mesh(), body);
  EXPECT_EQ(moved.size(), points_of(start, body).size());
  (void)mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({-0.01, 0, 0})}});
  expect_near(points_of(mesh.mesh(), body), points_of(start, body), 1e-12);
}

/// Their references are those of two bodies, and both move alike.
TEST(CurvedBodies, KeepTheirRims) {
  constexpr double radius = 0.16, half_height = 0.13;
  const Mesh start = room_with_cylinder(radius, half_height);
  const Geometry geometry(start);
  for (const MeshChanges changes : {MeshChanges::flips, MeshChanges::all}) {
    MovingMesh mesh(start, Sizes(start.points.size(), 0.06), adapting(changes));
    const RigidMotion step = turn(6);
    RigidMotion way;
    std::size_t rim_points = 0;
    for (int i = 0; i < 10; ++i) {
      ASSERT_EQ(mesh.advance(std::array{BodyMotion{side, step}, BodyMotion{caps, step}}).share, 1);
      way = step * way;
      std::vector<Point> rims;
      std::ranges::set_intersection(points_of(mesh.mesh(), side), points_of(mesh.mesh(), caps),
                                    std::back_inserter(rims));
      for (const Point& p : rims) {
        const Vec3 q = Vec3{way.inverse()(p)} - middle;
        EXPECT_NEAR(std::hypot(q[0], q[1]), radius, 1e-4 * radius);
        EXPECT_NEAR(std::abs(q[2]), half_height, 1e-9);
      }
      EXPECT_LT(farthest(geometry, way, points_of(mesh.mesh(), side)), on_it);
      EXPECT_LT(farthest(geometry, way, points_of(mesh.mesh(), caps)), on_it);
      rim_points = rims.size();
    }
    EXPECT_GT(rim_points, 20U);
    EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  }
}

/// The rim goes with the first, so that the second does not move as a whole.
Mesh two_halves() {
  Mesh mesh = room_with_ellipsoid({0.16, 0.16, 0.16});
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == body && centre_of(mesh, mesh.triangles[t])[2] > 0.5) mesh.triangle_refs[t] = caps;
  return mesh;
}

TEST(CurvedBodies, AreFrozenIfTheirRimMovesDifferently) {
  const Mesh start = two_halves();
  MovingMesh mesh(start, Sizes(start.points.size(), 0.045), {});
  const auto turned = [](double degrees) { return RigidMotion::rotation(middle, {0, 0, 1}, degrees); };
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turned(2)}, BodyMotion{caps, turned(-2)}}).share, 1);
  EXPECT_EQ(points_of(mesh.mesh(), caps).size(), points_of(start, caps).size());
  EXPECT_GT(points_of(mesh.mesh(), body).size(), points_of(start, body).size());
  EXPECT_LT(farthest(Geometry(start), turned(4), points_of(mesh.mesh(), body)), on_it);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

/// A body that became flat where it meets the wall would pass into it.
TEST(CurvedBodies, StopAtAWall) {
  constexpr double radius = 0.18, size = 0.05;
  const Mesh start = room_with_ellipsoid({radius, radius, radius});
  MovingMesh mesh(start, Sizes(start.points.size(), size), adapting(MeshChanges::all));
  double way = 0;
  Advance done;
  for (int i = 0; i < 40 && !done.obstacle; ++i) {
    done = mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.02, 0, 0})}});
    way += 0.02 * done.share;
  }
  ASSERT_TRUE(done.obstacle);
  EXPECT_EQ(done.obstacle->reason, Obstacle::Reason::contact);
  EXPECT_NEAR(way, 0.5 - radius, size / 4);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

std::uint64_t hash_on(int threads) {
  const Mesh start = room_with_ellipsoid(axes);
  MotionOptions options = adapting(MeshChanges::all);
  options.adaptation.threads = threads;
  options.adaptation.block_size = 300;
  MovingMesh mesh(start, Sizes(start.points.size(), 0.08), options);
  for (int step = 0; step < 4; ++step) (void)mesh.advance(std::array{BodyMotion{body, turn(12)}});
  return hash_of(mesh.mesh(), mesh.metric());
}

TEST(CurvedBodies, HaveTheSameBitsOnAnyNumberOfThreads) {
  const std::uint64_t hash = hash_on(1);
  EXPECT_EQ(hash_on(2), hash);
  EXPECT_EQ(hash_on(3), hash);
}

}  // namespace
}  // namespace taut::test
