// A front that runs through [0, 1]^3 from a corner, u = tanh(40 (|x| - 0.2 - 0.8 t)), t from 0 to 1.
//
// usage: travelling-front INTERVALS ITERATIONS COMPLEXITY FOLDER
//
// Computes the whole time ITERATIONS times, each time on meshes that are adapted to the solution of the time before:
// one mesh for each of INTERVALS parts of the time, COMPLEXITY in space and time for all. What stands for a solver
// takes 40 time steps and knows u. Writes the mesh of every iteration and interval to
// FOLDER/mesh-ITERATION-INTERVAL.meshb, and prints the complexity of the metrics that each solution asks for. A run
// that was interrupted goes on where it was.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <taut/taut.hpp>
#include <vector>

namespace {

constexpr int all_steps = 40;

double front(const taut::Point& p, double time) {
  return std::tanh(40 * (std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 0.2 - 0.8 * time));
}

/// The state of the solver: one scalar.
std::vector<taut::Field> state_at(const taut::Mesh& mesh, double time) {
  taut::Field u{.kind = taut::Field::Kind::scalar, .values = std::vector<double>(mesh.points.size())};
  std::ranges::transform(mesh.points, u.values.begin(), [&](const taut::Point& p) { return front(p, time); });
  return {u};
}

/// The solver. Another one computes the state after each step from that before, which it finds in `interval.state`. The
/// samples are from the middle of the steps: their ends alone say nothing of the beginning of the sub-interval.
void advance(taut::Interval& interval) {
  const auto steps = std::lround((interval.end - interval.begin) * all_steps);
  const double dt = (interval.end - interval.begin) / static_cast<double>(steps);
  for (long step = 0; step < steps; ++step) {
    const double time = interval.begin + static_cast<double>(step) * dt;
    interval.sample(state_at(*interval.mesh, time + dt / 2)[0].values, dt);
    interval.state = state_at(*interval.mesh, time + dt);
  }
}

/// The cube, adapted to one size.
taut::Mesh uniform(double complexity) {
  taut::Mesh cube;
  for (const double x : {0, 1})
    for (const double y : {0, 1})
      for (const double z : {0, 1}) cube.points.push_back({x, y, z});
  cube.tetrahedra = {{0, 4, 6, 7}, {0, 6, 2, 7}, {0, 2, 3, 7}, {0, 3, 1, 7}, {0, 1, 5, 7}, {0, 5, 4, 7}};
  return taut::adapt(cube, taut::Sizes(8, std::cbrt(1 / complexity))).mesh;
}

std::vector<double> equal_parts(int count) {
  std::vector<double> bounds;
  for (int i = 0; i <= count; ++i) bounds.push_back(static_cast<double>(i) / count);
  return bounds;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const double complexity = std::atof(argv[3]);
  const std::filesystem::path folder = argv[4];
  taut::UnsteadyOptions options;
  options.times = equal_parts(std::atoi(argv[1]));
  options.iterations = static_cast<std::size_t>(std::atoi(argv[2]));
  options.sizing = {.complexity = complexity, .limits = {.hmax = 0.25}};
  options.checkpoint = folder / "checkpoint";

  const auto initial = [](const taut::Mesh& mesh) { return state_at(mesh, 0); };
  const auto solve = [&](taut::Interval& interval) {
    const std::string name = "mesh-" + std::to_string(interval.iteration) + "-" + std::to_string(interval.index);
    taut::write_mesh(folder / (name + ".meshb"), *interval.mesh);
    advance(interval);
  };
  const taut::UnsteadyResult result =
      taut::unsteady_fixed_point(uniform(complexity / all_steps), initial, solve, options);

  for (const taut::IterationReport& report : result.iterations) std::printf("%.0f\n", report.complexity);
  std::filesystem::remove_all(options.checkpoint);  // the run is complete
}
