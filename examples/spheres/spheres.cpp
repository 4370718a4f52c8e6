// Example 5.3 of Dobrzynski and Frey 2008: two spheres travel down through a planar layer at z = -4, one past the
// other.
//
// usage: spheres MESH ROUNDS FOLDER
//
// MESH is that of spheres.geo. Adapts it to the metric at the beginning, then moves the spheres in 34 steps; the metric
// is a function, renewed before each step. Writes FOLDER/steps.csv, the meshes of some steps and their metrics.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <taut/taut.hpp>

#include "../steps.hpp"

namespace {

constexpr int all_steps = 34, steps_between_meshes = 8;
constexpr double coarsest = 0.455, thinnest = 0.03, layer = -4;

struct Ball {
  int reference;
  double radius;
  double edge;  // of its triangles
  taut::Point from, to;

  [[nodiscard]] taut::Point centre(double time) const {
    taut::Point c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = from[i] + time * (to[i] - from[i]);
    return c;
  }
  [[nodiscard]] double distance(const taut::Point& p, double time) const {
    const taut::Point c = centre(time);
    return std::sqrt((p[0] - c[0]) * (p[0] - c[0]) + (p[1] - c[1]) * (p[1] - c[1]) + (p[2] - c[2]) * (p[2] - c[2])) -
           radius;
  }
  [[nodiscard]] taut::BodyMotion step() const {
    taut::Point by;
    for (std::size_t i = 0; i < 3; ++i) by[i] = (to[i] - from[i]) / all_steps;
    return {reference, taut::RigidMotion::translation(by)};
  }
};

constexpr std::array<Ball, 2> balls = {
    {{2, 0.5, 0.12, {0, 0, 0}, {0, 4, -8.5}}, {3, 0.3, 0.08, {0, 4, 0}, {0, 0, -5.5}}}};

/// Eq. (5) of the paper, turned and moved. Near the spheres no size is larger than an edge of theirs, nor smaller than
/// half of it, so that the layer does not refine them.
taut::Tensor metric_at(const taut::Point& p, double time) {
  constexpr double growth = 0.5;
  double along = coarsest;
  double across = coarsest * std::abs(1 - std::exp(-std::abs(p[2] - layer))) + thinnest;
  for (const Ball& ball : balls) {
    const double d = std::max(ball.distance(p, time), 0.0);
    along = std::min(along, ball.edge + growth * d);
    across = std::max(across, ball.edge / 2 - growth * d);
  }
  across = std::min(across, along);
  return {1 / (along * along), 0, 0, 1 / (along * along), 0, 1 / (across * across)};
}

taut::MetricFunction metric(double time) {
  return [time](const taut::Point& p) { return metric_at(p, time); };
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::filesystem::path folder = argv[3];
  taut::MotionOptions options{.rounds = std::atoi(argv[2]), .stiffening = 0};
  options.adaptation.max_rounds = 40;
  taut::MovingMesh moving(taut::read_mesh(argv[1]), metric(0), options);

  steps::Log log(folder / "steps.csv");
  log.add(0, moving, {}, {});
  steps::write(folder, 0, moving);
  for (int step = 1; step <= all_steps; ++step) {
    const steps::Watch watch;
    moving.set_metric(metric(static_cast<double>(step) / all_steps));
    const std::array motions = {balls[0].step(), balls[1].step()};
    const taut::Advance done = moving.advance(motions);
    log.add(step, moving, done, watch.seconds());
    if (step % steps_between_meshes == 0 || step == all_steps) steps::write(folder, step, moving);
  }
}
