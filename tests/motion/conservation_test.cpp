// What a solver needs of a moving mesh: over many steps a uniform state stays uniform, and no mass is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "motion/room.hpp"

namespace taut::test {
namespace {

constexpr int all_steps = 100;
constexpr double size = 0.2;

/// The body travels and turns forth and back, and ends where it began.
RigidMotion place_after(int step) {
  const double phase = 2 * std::numbers::pi * step / all_steps;
  return RigidMotion::translation({0.08 * std::sin(phase), 0, 0.04 * std::sin(2 * phase)}) * turn(60 * std::sin(phase));
}

BodyMotion motion_in(int step) {
  return {body, place_after(step) * place_after(step - 1).inverse()};
}

/// The integral of a field that is linear on each tetrahedron.
double mass(const Mesh& mesh, const Field& field) {
  double sum = 0;
  for (const auto& t : mesh.tetrahedra) {
    const auto& p = mesh.points;
    double values = 0;
    for (const Index v : t) values += field.values[v];
    sum += six_volumes(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) / 24 * values;
  }
  return sum;
}

Field linear_field(const Mesh& mesh) {
  Field field;
  for (const Point& p : mesh.points) field.values.push_back(1 + 2 * p[0] - 3 * p[1] + p[2]);
  return field;
}

class HundredSteps : public testing::TestWithParam<MeshChanges> {};

TEST_P(HundredSteps, KeepAUniformStateAndTheVolume) {
  const Mesh start = room(6, size);
  MovingMesh mesh = moving(start, fixed_surface(GetParam()), size);
  const double before = volume_of(mesh.mesh());
  mesh.set_fields({{.values = std::vector<double>(mesh.points().size(), 1.25)}});
  for (int step = 1; step <= all_steps; ++step) {
    const Advance done = mesh.advance(std::array{motion_in(step)});
    ASSERT_EQ(done.share, 1);
    ASSERT_NEAR(volume_of(mesh.mesh()), before, 1e-12);
    ASSERT_EQ(mesh.fields()[0].values.size(), mesh.points().size());
    for (const double value : mesh.fields()[0].values) ASSERT_NEAR(value, 1.25, 1e-12);
  }
  EXPECT_EQ(defects(mesh.mesh()), std::vector<std::string>{});
  expect_near(points_of(mesh.mesh(), body), points_of(start, body), 1e-12);
}

/// A step first moves vertices, which carry their values along; that changes the mass, and a solver takes it into
/// account. Then the mesh is optimised, and the field transferred between two meshes of the same domain.
TEST_P(HundredSteps, KeepTheMassInEachTransfer) {
  MotionOptions options = fixed_surface(GetParam());
  const MovingMesh* seen = nullptr;
  double before = 0;
  options.adaptation.progress = [&](const Progress&) {  // vertices have moved, but nothing is transferred yet
    before = mass(seen->mesh(), seen->fields()[0]);
    return true;
  };
  MovingMesh mesh = moving(room(6, size), options, size);
  seen = &mesh;
  mesh.set_fields({linear_field(mesh.mesh())});
  double moved = 0;
  for (int step = 1; step <= all_steps; ++step) {
    const double last = mass(mesh.mesh(), mesh.fields()[0]);
    const Advance done = mesh.advance(std::array{motion_in(step)});
    ASSERT_EQ(done.parts, 1);
    ASSERT_NEAR(mass(mesh.mesh(), mesh.fields()[0]), before, 1e-12 * before);
    moved = std::max(moved, std::abs(before - last));
  }
  EXPECT_GT(moved, 1e-4);  // so it is not the mass before the step that was seen
}

INSTANTIATE_TEST_SUITE_P(Motion, HundredSteps, testing::Values(MeshChanges::flips, MeshChanges::all));

}  // namespace
}  // namespace taut::test
