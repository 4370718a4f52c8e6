// Bodies that travel and turn through a mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "adapt/hash.hpp"
#include "base/with_threads.hpp"
#include "motion/room.hpp"

namespace taut::test {
namespace {

struct Case {
  MeshChanges changes;
  Following following;
};

class Turning : public testing::TestWithParam<Case> {};

TEST_P(Turning, BringsTheBodyBackAfterAWholeTurn) {
  const Mesh start = room();
  MotionOptions options = fixed_surface(GetParam().changes);
  options.following = GetParam().following;
  MovingMesh mesh = moving(start, options);
  const double before = volume(mesh.mesh(), mesh.metric());
  double worst = 0;
  for (int step = 0; step < 40; ++step) {
    const Advance done = mesh.advance(std::array{BodyMotion{body, turn(9)}});
    ASSERT_EQ(done.share, 1);
    const Quality quality = measure(mesh.mesh(), mesh.metric());
    ASSERT_NEAR(quality.volume, before, 1e-12);
    worst = std::max(worst, quality.Q_max);
  }
  EXPECT_LT(worst, 8);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  expect_near(points_of(mesh.mesh(), body), points_of(start, body), 1e-12);
  EXPECT_EQ(points_of(mesh.mesh(), wall), points_of(start, wall));
}

INSTANTIATE_TEST_SUITE_P(Motion, Turning,
                         testing::Values(Case{MeshChanges::all, Following::elastic},
                                         Case{MeshChanges::flips, Following::elastic},
                                         Case{MeshChanges::flips, Following::share}));

TEST(MovingMesh, KeepsItsPointsIfOnlyFlipsAreAllowed) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface(MeshChanges::flips));
  EXPECT_EQ(mesh.points(), start.points);
  const Advance done = mesh.advance(std::array{BodyMotion{body, turn(10)}});
  EXPECT_TRUE(done.is_changed);
  ASSERT_EQ(mesh.points().size(), start.points.size());
  for (Index v = 0; v < start.points.size(); ++v) EXPECT_EQ(done.new_of_old[v], v);
  for (const auto& triangle : start.triangles)
    for (const Index v : triangle) {
      const Point wanted = distance_from_middle(start.points[v]) < 0.4 ? turn(10)(start.points[v]) : start.points[v];
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(mesh.points()[v][i], wanted[i], 1e-15);
    }
}

/// On straight ways the vertices would leave the axis, by 0.0007 on average.
TEST(MovingMesh, TravelsOnArcsAroundABodyThatTurns) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface(MeshChanges::nothing));
  ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turn(18)}}).share, 1);
  const auto from_axis = [](const Point& p) {
    return norm(cross(Vec3{p} - Vec3{0.5, 0.5, 0.5}, (1 / std::sqrt(14.0)) * Vec3{1, 2, 3}));
  };
  double outwards = 0;
  for (std::size_t v = 0; v < start.points.size(); ++v)
    outwards += from_axis(mesh.points()[v]) - from_axis(start.points[v]);
  EXPECT_NEAR(outwards / static_cast<double>(start.points.size()), 0, 1e-4);
}

TEST(MovingMesh, KeepsItsTetrahedraIfNothingMayChange) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface(MeshChanges::nothing));
  const auto tetrahedra = mesh.mesh().tetrahedra;
  for (int step = 0; step < 3; ++step) {
    const Advance done = mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.01, 0, 0})}});
    EXPECT_EQ(done.share, 1);
    EXPECT_FALSE(done.is_changed);
  }
  EXPECT_EQ(mesh.mesh().tetrahedra, tetrahedra);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

TEST(MovingMesh, CarriesFieldsAlong) {
  for (const MeshChanges changes : {MeshChanges::flips, MeshChanges::all}) {
    MovingMesh mesh = moving(room(), fixed_surface(changes));
    Field constant{.kind = Field::Kind::scalar, .values = std::vector<double>(mesh.points().size(), 3)};
    mesh.set_fields({constant});
    for (int step = 0; step < 5; ++step) ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, turn(8)}}).share, 1);
    ASSERT_EQ(mesh.fields()[0].values.size(), mesh.points().size());
    for (const double value : mesh.fields()[0].values) EXPECT_NEAR(value, 3, 1e-12);
  }
}

/// Fields are carried by the vertices, so a field is linear after a step if it is so where the vertices have gone: here
/// the body stays, and optimisation alone changes the mesh.
TEST(MovingMesh, TransfersALinearFieldExactly) {
  const auto linear = [](const Point& p) { return 1 + 2 * p[0] - 3 * p[1] + p[2]; };
  for (const Transfer method : {Transfer::conservative, Transfer::linear}) {
    MotionOptions options = fixed_surface();
    options.transfer = method;
    MovingMesh mesh = moving(room(), options);
    mesh.set_metric(Sizes(mesh.points().size(), 0.08));
    Field field;
    for (const Point& p : mesh.points()) field.values.push_back(linear(p));
    mesh.set_fields({field});
    const std::size_t before = mesh.points().size();
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, {}}}).share, 1);
    EXPECT_GT(mesh.points().size(), before + 100);
    for (std::size_t v = 0; v < mesh.points().size(); ++v)
      EXPECT_NEAR(mesh.fields()[0].values[v], linear(mesh.points()[v]), 1e-12);
  }
}

TEST(MovingMesh, GivesTheVelocityOfTheBody) {
  MovingMesh mesh = moving(room(), fixed_surface(MeshChanges::flips));
  ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.02, 0, 0.01})}}).share, 1);
  const std::vector<Point> velocities = mesh.velocities(0.1);
  for (std::size_t t = 0; t < mesh.mesh().triangles.size(); ++t)
    for (const Index v : mesh.mesh().triangles[t]) {
      const bool moves = mesh.mesh().triangle_refs[t] == body;
      EXPECT_NEAR(velocities[v][0], moves ? 0.2 : 0, 1e-9);
      EXPECT_NEAR(velocities[v][2], moves ? 0.1 : 0, 1e-9);
    }
}

TEST(MovingMesh, AddsUpTheVelocitiesOfTheParts) {
  MovingMesh mesh = moving(room(), fixed_surface());
  const Advance done = mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.25, 0, 0})}});
  ASSERT_EQ(done.share, 1);
  ASSERT_GT(done.parts, 1);
  const std::vector<Point> velocities = mesh.velocities(1);
  for (std::size_t t = 0; t < mesh.mesh().triangles.size(); ++t)
    for (const Index v : mesh.mesh().triangles[t])
      EXPECT_NEAR(velocities[v][0], mesh.mesh().triangle_refs[t] == body ? 0.25 : 0, 1e-9);
}

TEST(MovingMesh, MovesPointsAsTheCallerSays) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface());
  std::vector<std::uint8_t> listed(start.points.size(), 0);
  std::vector<PointMotion> motions;
  for (std::size_t t = 0; t < start.triangles.size(); ++t)
    for (const Index v : start.triangles[t])
      if (start.triangle_refs[t] == body && listed[v]++ == 0) motions.push_back({v, {0.03, 0.02, 0}});
  EXPECT_EQ(mesh.advance(motions).share, 1);
  std::vector<Point> wanted = points_of(start, body);
  for (Point& p : wanted) p = {p[0] + 0.03, p[1] + 0.02, p[2]};
  expect_near(points_of(mesh.mesh(), body), wanted, 1e-12);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

TEST(MovingMesh, SlidesAlongWallsThatAreNamed) {
  MotionOptions options = fixed_surface(MeshChanges::nothing);
  options.sliding = {wall};
  const Mesh start = room();
  MovingMesh mesh = moving(start, options);
  ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, RigidMotion::translation({0.02, 0, 0})}}).share, 1);
  double slid = 0;
  for (std::size_t t = 0; t < start.triangles.size(); ++t) {
    if (start.triangle_refs[t] != wall) continue;
    for (const Index v : start.triangles[t])
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = start.points[v][i], moved = std::abs(mesh.points()[v][i] - x);
        if (x == 0 || x == 1) {
          EXPECT_LT(moved, 1e-15);
        }
        slid = std::max(slid, moved);
      }
  }
  EXPECT_GT(slid, 1e-4);
}

TEST(MovingMesh, HasTheSameBitsOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    MotionOptions options = fixed_surface();
    options.adaptation.threads = threads;
    options.adaptation.block_size = 300;
    MovingMesh mesh = moving(room(), options);
    for (int step = 0; step < 4; ++step) (void)mesh.advance(std::array{BodyMotion{body, turn(12)}});
    hashes.push_back(hash_of(mesh.mesh(), mesh.metric()));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(MovingMesh, TakesAMetricWithTheBody) {
  const Mesh start = room();
  const MetricFunction layer = [](const Point& p) {
    const double h = 0.08 + 0.3 * std::abs(p[0] - 0.5);
    return Tensor{1 / (h * h), 0, 0, 1 / 0.04, 0, 1 / 0.04};
  };
  MotionOptions options = fixed_surface();
  options.metric_follows = body;
  MovingMesh mesh(start, layer, options);
  const RigidMotion quarter = RigidMotion::rotation({0.5, 0.5, 0.5}, {0, 0, 1}, 90);
  for (int step = 0; step < 9; ++step)
    ASSERT_EQ(mesh.advance(std::array{BodyMotion{body, quarter.share(1.0 / 9)}}).share, 1);
  for (std::size_t v = 0; v < mesh.points().size(); ++v) {
    const Tensor wanted = quarter.rotated(layer(quarter.inverse()(mesh.points()[v])));
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(mesh.metric()[v][i], wanted[i], 1e-9 * std::abs(wanted[0] + wanted[3]));
  }
}

TEST(MovingMesh, TakesANewMetric) {
  MovingMesh mesh = moving(room(), fixed_surface());
  const std::size_t coarse = mesh.points().size();
  mesh.set_metric(Sizes(coarse, 0.08));
  (void)mesh.advance(std::array{BodyMotion{body, turn(1)}});
  EXPECT_GT(mesh.points().size(), 1.5 * static_cast<double>(coarse));
  EXPECT_THROW(mesh.set_metric(Sizes(3, 0.1)), InputError);
}

/// Its vertices are spread for sizes that are equal in all directions, so flips alone cannot make it good in either of
/// the metrics: almost everything has been tried in the first one.
TEST(MovingMesh, TriesShapesAgainIfOnlyTheMetricChanged) {
  MotionOptions options = fixed_surface(MeshChanges::flips);
  options.rounds = 1;
  MovingMesh mesh = moving(room(), options);
  const auto shapes_tried = [&] {
    std::size_t tried = 0;
    for (const PassReport& pass : mesh.advance(std::array{BodyMotion{body, {}}}).passes)
      if (pass.name.starts_with("swap")) tried += pass.tried;
    return tried;
  };
  const auto flat_across = [&](std::size_t axis) {
    Tensor tensor{25, 0, 0, 25, 0, 25};
    tensor[std::array{0, 3, 5}[axis]] = 60;
    mesh.set_metric(Tensors(mesh.points().size(), tensor));
  };
  flat_across(0);
  const std::size_t first = shapes_tried();
  for (int step = 0; step < 20; ++step) (void)shapes_tried();
  EXPECT_LT(shapes_tried(), first / 10);
  flat_across(1);
  EXPECT_GT(shapes_tried(), first + first / 2);  // as many as before if only those that were never tried
}

TEST(MovingMesh, RefusesWhatMakesNoSense) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface());
  const auto bodies = [&](std::vector<BodyMotion> list) { return refusal(1, [&] { return mesh.advance(list); }); };
  EXPECT_EQ(bodies({{9, {}}}), "motion: no triangle has the reference 9");
  EXPECT_EQ(bodies({{body, {}}, {body, {}}}), "motion: the reference 7 comes twice");
  EXPECT_EQ(bodies({{body, RigidMotion::translation({0, 1e101, 0})}}),
            "motion: that of the reference 7 is not finite or above 1e+100");
  const Index inside =
      static_cast<Index>(std::ranges::find_if(start.points,
                                              [](const Point& p) {
                                                return distance_from_middle(p) > 0.2 && distance_from_middle(p) < 0.45;
                                              }) -
                         start.points.begin());
  const auto points = [&](std::vector<PointMotion> list) { return refusal(1, [&] { return mesh.advance(list); }); };
  EXPECT_EQ(points({{inside, {}}}), "motion: point " + std::to_string(inside) + " is not on the boundary");
  const Index corner = start.triangles[0][0];
  EXPECT_EQ(points({{corner, {NAN, 0, 0}}}),
            "motion: the displacement of point " + std::to_string(corner) + " is not finite or above 1e+100");
  EXPECT_EQ(points({{corner, {}}, {corner, {}}}), "motion: point " + std::to_string(corner) + " comes twice");
  EXPECT_EQ(refusal(1, [&] { return moving(start, {.rounds = -1}); }), "-1 rounds found, expected 0 or more");
  EXPECT_EQ(refusal(1, [&] { return moving(start, {.poisson_ratio = 0.5}); }),
            "Poisson ratio 0.5 found, expected between -1 and 1/2");
  EXPECT_EQ(refusal(1, [&] { return moving(start, {.smallest_share = 0}); }),
            "smallest share 0 found, expected above 0, at most 1");
  EXPECT_EQ(mesh.points(), start.points);
}

}  // namespace
}  // namespace taut::test
