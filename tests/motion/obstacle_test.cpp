// Narrow gaps, and what stops a body.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "motion/room.hpp"

namespace taut::test {
namespace {

BodyMotion shift(double x) {
  return {body, RigidMotion::translation({x, 0, 0})};
}

void expect_contact(const Advance& done, double gap) {
  EXPECT_LT(done.share, 1);
  ASSERT_TRUE(done.obstacle);
  const Obstacle& found = *done.obstacle;
  EXPECT_EQ(found.reason, Obstacle::Reason::contact);
  EXPECT_EQ(found.body, body);
  EXPECT_EQ(found.other, wall);
  EXPECT_NEAR(found.gap, gap, 1e-12);
  EXPECT_NEAR(found.size, 0.12, 1e-12);
  EXPECT_NEAR(found.place[0], 1 - gap / 2, 1e-12);
  EXPECT_TRUE(description(found).starts_with("the triangles of reference 7 meet those of reference 1 near ("))
      << description(found);
}

TEST(NarrowGap, OfATenthOfAnEdgeLetsTheBodyInAndOut) {
  for (const MeshChanges changes : {MeshChanges::flips, MeshChanges::all}) {
    const Mesh start = room();
    MovingMesh mesh = moving(start, fixed_surface(changes));
    const double before = volume(mesh.mesh(), mesh.metric());
    const double way = 1.0 / 3 - 0.012;
    for (int step = 1; step <= 16; ++step) {
      ASSERT_EQ(mesh.advance(std::array{shift(step <= 8 ? way / 8 : -way / 8)}).share, 1) << step;
      EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
      EXPECT_NEAR(volume(mesh.mesh(), mesh.metric()), before, 1e-12);
    }
    expect_near(points_of(mesh.mesh(), body), points_of(start, body), 1e-12);
    EXPECT_LT(measure(mesh.mesh(), mesh.metric()).Q_max, 8);
  }
}

TEST(Obstacle, StopsAtAWall) {
  MovingMesh mesh = moving(room(), fixed_surface());
  Advance done;
  double way = 0;
  for (int step = 0; step < 20 && !done.obstacle; ++step) {
    done = mesh.advance(std::array{shift(0.05)});
    way += 0.05 * done.share;
    EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  }
  EXPECT_GT(way, 0.32);
  expect_contact(done, 1.0 / 3 - way);
}

/// Parts of one body do not meet each other.
TEST(Obstacle, IsNoneBetweenWhatMovesAlike) {
  constexpr int upper = 8;
  Mesh start = room();
  for (std::size_t t = 0; t < start.triangles.size(); ++t)
    if (start.triangle_refs[t] == body && centre_of(start, start.triangles[t])[2] > 0.5) start.triangle_refs[t] = upper;
  MovingMesh mesh = moving(start, fixed_surface());
  BodyMotion other = shift(0.4);
  other.reference = upper;
  const Advance done = mesh.advance(std::array{shift(0.4), other});
  ASSERT_TRUE(done.obstacle);
  EXPECT_TRUE(done.obstacle->body == body || done.obstacle->body == upper);
  EXPECT_EQ(done.obstacle->other, wall);
}

TEST(Obstacle, StopsPointsThatTheCallerMoves) {
  const Mesh start = room();
  MovingMesh mesh = moving(start, fixed_surface());
  std::set<Index> points;
  for (std::size_t t = 0; t < start.triangles.size(); ++t)
    if (start.triangle_refs[t] == body) points.insert(start.triangles[t].begin(), start.triangles[t].end());
  std::vector<PointMotion> motions;
  for (const Index v : points) motions.push_back({v, {0.4, 0, 0}});
  const Advance done = mesh.advance(motions);
  EXPECT_GT(done.share, 0.8);
  expect_contact(done, 1.0 / 3 - 0.4 * done.share);
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
}

TEST(Obstacle, NamesATangle) {
  MotionOptions options = fixed_surface(MeshChanges::nothing);
  options.smallest_share = 1;
  MovingMesh mesh = moving(room(), options);
  const Advance done = mesh.advance(std::array{BodyMotion{body, turn(120)}});
  EXPECT_LT(done.share, 1);
  ASSERT_TRUE(done.obstacle);
  EXPECT_EQ(done.obstacle->reason, Obstacle::Reason::tangle);
  EXPECT_EQ(done.obstacle->body, body);
  EXPECT_EQ(done.obstacle->other, wall);
  EXPECT_GT(done.obstacle->gap, 0.12);
  EXPECT_NE(description(*done.obstacle).find("would turn over near ("), std::string::npos);
}

}  // namespace
}  // namespace taut::test
