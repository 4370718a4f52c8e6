// Example 5.4 of Dobrzynski and Frey 2008: a propeller turns in a sphere, 3.6 degrees a step, and all vertices stay.
//
// usage: propeller MESH STEPS FOLDER
//
// MESH is that of propeller.geo. Adapts it once to the sizes that it has, made smooth, which from then on turn with the
// rotor. Writes FOLDER/steps.csv, the meshes of some steps and their metrics.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <taut/taut.hpp>

#include "../steps.hpp"

namespace {

constexpr int rotor = 2, steps_of_a_turn = 100;
constexpr double degrees = 360.0 / steps_of_a_turn;

bool is_kept(int step) {
  return step % steps_of_a_turn == 0 || step == 8 || step == 17;
}

/// The shapes of single tetrahedra do not count: they would turn away from the outer sphere, whose triangles stay.
taut::Sizes sizes_of(const taut::Mesh& mesh) {
  taut::Sizes sizes;
  for (const auto& [xx, xy, xz, yy, yz, zz] : taut::implied_metric(mesh)) {
    const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    sizes.push_back(std::pow(det, -1.0 / 6));
  }
  return sizes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int all_steps = std::atoi(argv[2]);
  const std::filesystem::path folder = argv[3];
  const taut::Mesh mesh = taut::read_mesh(argv[1]);
  taut::MotionOptions options{
      .changes = taut::MeshChanges::flips, .stiffening = 1.25, .shell = 3, .metric_follows = rotor};
  options.adaptation = {.limits = {.gradation = taut::Gradation{}}, .max_rounds = 40};
  taut::MovingMesh moving(mesh, sizes_of(mesh), options);

  steps::Log log(folder / "steps.csv");
  log.add(0, moving, {}, {});
  steps::write(folder, 0, moving);
  const std::array turn = {taut::BodyMotion{rotor, taut::RigidMotion::rotation({0, 0, 0}, {0, 0, 1}, degrees)}};
  for (int step = 1; step <= all_steps; ++step) {
    const steps::Watch watch;
    const taut::Advance done = moving.advance(turn);
    log.add(step, moving, done, watch.seconds());
    if (is_kept(step)) steps::write(folder, step, moving);
  }
}
