// Curved patches and lines that move with their bodies.
#include "geometry/carry.hpp"

#include <algorithm>

#include "geometry/classified.hpp"
#include "geometry/fit.hpp"
#include "geometry/refit.hpp"
#include "sizing/curved_meshes.hpp"

namespace taut {
namespace {

constexpr double rounding = 1e-8;  // Newton's method ends somewhere within it

const RigidMotion motion =
    RigidMotion::translation({3, -1, 0.5}) * RigidMotion::rotation({0.2, 0.1, 0}, {1, 2, -1}, 70);

// A solid cylinder of radius 1 between z = 0 and z = 1.5: a side, two caps, two rims.
class CarriedCylinder : public testing::Test {
protected:
  CarriedCylinder() : c_(mesh(), Surface::adapt, std::nullopt) {
    moves_.of_vertex.assign(c_.built.mesh.vertices.size(), none);
  }

  static Mesh mesh() {
    Mesh mesh = test::cylinder(8, 1, 1.5);
    mesh.triangle_refs.assign(mesh.triangles.size(), 1);
    return mesh;
  }

  template <class Chosen>
  void move(const RigidMotion& by, Chosen chosen) {
    const auto number = static_cast<std::uint32_t>(moves_.motions.size());
    moves_.motions.push_back(by);
    for (const VertexId v : c_.built.mesh.vertex_ids()) {
      if (!chosen(c_.built.mesh.x(v))) continue;
      moves_.of_vertex[v] = number;
      moved_.push_back(v);
    }
    for (const VertexId v : moved_) c_.built.mesh.vertices[v].x = by(c_.built.mesh.x(v));
  }

  void refit() {
    std::vector<std::uint8_t> has_moved(c_.built.mesh.vertices.size(), 0);
    for (const VertexId v : moved_) has_moved[v] = 1;
    taut::refit(c_.model, c_.built.mesh, has_moved, moves_);
  }

  [[nodiscard]] std::size_t curved_patches() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(c_.model.patches, [](const Patch& p) { return p.curved() != nullptr; }));
  }
  [[nodiscard]] std::size_t moving_lines() const {
    return static_cast<std::size_t>(std::ranges::count(c_.model.lines, false, &Line::frozen));
  }

  test::Classified c_;
  RigidMoves moves_;
  std::vector<VertexId> moved_;
};

TEST_F(CarriedCylinder, IsAskedInItsFrame) {
  const test::Classified before(mesh(), Surface::adapt, std::nullopt);
  move(motion, [](const Vec3&) { return true; });
  refit();
  ASSERT_EQ(curved_patches(), 1);
  ASSERT_EQ(moving_lines(), 2);
  const TetMesh &old = before.built.mesh, &now = c_.built.mesh;
  for (const VertexId v : now.vertex_ids()) {
    const Tag tag = now.tag_of_vertex[v];
    ASSERT_EQ(tag, old.tag_of_vertex[v]);
    EXPECT_LT(norm(c_.model.project(tag, now.x(v)) - now.x(v)), rounding);
    const Vec3 beside = old.x(v) + Vec3{0.02, -0.01, 0.03};
    EXPECT_LT(norm(c_.model.project(tag, motion(beside)) - Vec3{motion(before.model.project(tag, beside))}), rounding);
    const Vec3 normal = before.model.normal(tag, beside);
    EXPECT_LT(norm(c_.model.normal(tag, motion(beside)) - (Vec3{motion(normal)} - Vec3{motion({})})), rounding);
  }
}

TEST_F(CarriedCylinder, IsFittedInItsFrame) {
  const test::Classified before(mesh(), Surface::adapt, std::nullopt);
  move(motion, [](const Vec3&) { return true; });
  refit();
  for (const Triangle& t : c_.built.mesh.triangles) {
    const auto fit_in = [&](const test::Classified& c) {
      const TetMesh& m = c.built.mesh;
      return misfit(c.model, t.patch, {m.x(t.v[0]), m.x(t.v[1]), m.x(t.v[2])}, identity3);
    };
    EXPECT_NEAR(fit_in(c_), fit_in(before), rounding);
  }
}

TEST_F(CarriedCylinder, DoesNotDriftInManySteps) {
  constexpr int steps = 3600;
  const RigidMotion step = RigidMotion::rotation({0.3, 0.2, 0.1}, {1, 2, 3}, 360.0 / steps);
  const Model before = c_.model;
  moves_.motions = {step};
  moves_.of_vertex.assign(c_.built.mesh.vertices.size(), 0);
  for (int i = 0; i < steps; ++i) carry(c_.model, c_.built.mesh, moves_);
  for (const VertexId v : c_.built.mesh.vertex_ids()) {
    const Tag tag = c_.built.mesh.tag_of_vertex[v];
    const Vec3 beside = c_.built.mesh.x(v) + Vec3{0.02, -0.01, 0.03};
    EXPECT_LT(norm(c_.model.project(tag, beside) - before.project(tag, beside)), rounding);
  }
}

TEST_F(CarriedCylinder, IsFrozenIfItsEndsMoveDifferently) {
  move(RigidMotion::translation({0, 0, 0.1}), [](const Vec3& x) { return x[2] > 1.4; });
  refit();
  EXPECT_EQ(curved_patches(), 0);
  EXPECT_EQ(moving_lines(), 1) << "the rim that stays where it is";
}

TEST_F(CarriedCylinder, IsFrozenIfAVertexMovesOtherwise) {
  move(motion, [](const Vec3&) { return true; });
  const auto on_side = std::ranges::find_if(moved_, [&](VertexId v) {
    const Tag tag = c_.built.mesh.tag_of_vertex[v];
    return tag.is_on_patch() && c_.model.patches[tag.patch()].curved() != nullptr;
  });
  moves_.of_vertex[*on_side] = none;
  refit();
  EXPECT_EQ(curved_patches(), 0);
  EXPECT_EQ(moving_lines(), 0);
}

}  // namespace
}  // namespace taut
