// Two spheres approach each other until the gap between them is a tenth of their edges, and leave again; or one of them
// is driven into the wall.
//
// usage: pinch MESH RUN FOLDER
//
// MESH is that of pinch.geo. RUN is
//   gap    there and back; the metric asks for edges as long as those of the spheres, however narrow the gap
//   layer  the same with a metric that asks for one layer of tetrahedra in the gap
//   wall   the upper sphere moves up until it is stopped
// Writes FOLDER/steps.csv, FOLDER/checks.csv, meshes and their metrics; prints what stops the sphere. The status is 1
// if a mesh is not as it ought to be.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <taut/taut.hpp>
#include <vector>

#include "../steps.hpp"

namespace {

constexpr int steps_there = 20, steps_between_meshes = 5;
constexpr double edge = 0.1, growth = 0.3, coarsest = 0.4;  // of the metric
constexpr double first_gap = 1, least_gap = edge / 10;      // between the spheres
constexpr double top = 1.8, step_to_wall = 0.035;

struct Ball {
  int reference;
  double radius, z;  ///< of the centre at the beginning
};
constexpr std::array<Ball, 2> balls = {{{2, 0.5, -1.1}, {3, 0.4, 0.8}}};

using Shifts = std::array<double, 2>;  // of the balls, along the z axis

/// The gap shrinks by the same factor in each step, then grows again.
Shifts shifts_in_gap(int step) {
  const double there = static_cast<double>(std::min(step, 2 * steps_there - step)) / steps_there;
  const double way = (first_gap - first_gap * std::pow(least_gap / first_gap, there)) / 2;
  return {way, -way};
}

Shifts shifts_to_wall(int step) {
  return {0, step_to_wall * step};
}

double distance(const Ball& ball, double shift, const taut::Point& p) {
  return std::max(std::hypot(p[0], p[1], p[2] - ball.z - shift) - ball.radius, 0.0);
}

/// Edges grow with the distance from the spheres. With a layer, they are no longer across the gap than the gap is wide.
taut::MetricFunction metric(const Shifts& shifts, bool has_layer) {
  return [shifts, has_layer](const taut::Point& p) {
    const double below = distance(balls[0], shifts[0], p), above = distance(balls[1], shifts[1], p);
    const double h = std::min(edge + growth * std::min(below, above), coarsest);
    const double across = has_layer ? std::min(h, below + above) : h;
    return taut::Tensor{1 / (h * h), 0, 0, 1 / (h * h), 0, 1 / (across * across)};
  };
}

/// The vertices of the balls, with their places at the beginning.
class BallVertices {
public:
  explicit BallVertices(const taut::Mesh& mesh) {
    for (std::size_t ball = 0; ball < balls.size(); ++ball) {
      std::set<taut::Index> found;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (mesh.triangle_refs[t] == balls[ball].reference)
          found.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
      for (const taut::Index v : found) all_[ball].push_back({v, mesh.points[v]});
    }
  }

  void renumber(const std::vector<taut::Index>& new_of_old) {
    for (auto& vertices : all_)
      for (auto& vertex : vertices) vertex.number = new_of_old[vertex.number];
  }

  /// The largest distance of a vertex from where its ball is now.
  [[nodiscard]] double error(const taut::Mesh& mesh, const Shifts& shifts) const {
    double worst = 0;
    for (std::size_t ball = 0; ball < balls.size(); ++ball)
      for (const auto& [number, start] : all_[ball]) {
        const taut::Point& x = mesh.points.at(number);
        worst = std::max(worst, std::hypot(x[0] - start[0], x[1] - start[1], x[2] - start[2] - shifts[ball]));
      }
    return worst;
  }

private:
  struct BallVertex {
    taut::Index number;
    taut::Point start;
  };
  std::array<std::vector<BallVertex>, balls.size()> all_;
};

/// Checks each mesh, and writes a line about it.
class Checks {
public:
  Checks(const std::filesystem::path& path, const taut::MovingMesh& moving)
      : vertices_(moving.mesh()), volume_(volume_of(moving)), file_(std::fopen(path.c_str(), "w")) {
    std::fprintf(file_, "step,gap,gap_to_wall,place_error,volume_error,defects\n");
  }
  Checks(const Checks&) = delete;
  Checks& operator=(const Checks&) = delete;
  ~Checks() { std::fclose(file_); }

  void check(int step, const taut::MovingMesh& moving, const taut::Advance& done, const Shifts& shifts) {
    if (step > 0) vertices_.renumber(done.new_of_old);
    const double place_error = vertices_.error(moving.mesh(), shifts);
    const double volume_error = std::abs(volume_of(moving) / volume_ - 1);
    const std::size_t defects = taut::defects(moving.mesh()).size();  // orientations are exact
    all_hold_ = all_hold_ && place_error < 1e-10 && volume_error < 1e-12 && defects == 0;
    const double gap = first_gap + shifts[1] - shifts[0];  // poles are vertices, so triangles have the spheres' gap
    const double gap_to_wall = top - balls[1].z - balls[1].radius - shifts[1];
    std::fprintf(file_, "%d,%.6f,%.6f,%.2e,%.2e,%zu\n", step, gap, gap_to_wall, place_error, volume_error, defects);
  }
  [[nodiscard]] bool all_hold() const { return all_hold_; }

private:
  static double volume_of(const taut::MovingMesh& moving) {
    return taut::measure(moving.mesh(), moving.metric()).volume;
  }

  BallVertices vertices_;
  double volume_;
  std::FILE* file_;
  bool all_hold_ = true;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string run = argv[2];
  const auto shifts_at = run == "wall" ? shifts_to_wall : shifts_in_gap;
  const bool has_layer = run == "layer";
  const std::filesystem::path folder = argv[3];
  taut::MotionOptions options;
  options.adaptation.surface = taut::Surface::planar;  // each vertex of the spheres can be checked
  options.adaptation.max_rounds = 40;
  taut::MovingMesh moving(taut::read_mesh(argv[1]), metric({}, has_layer), options);

  steps::Log log(folder / "steps.csv");
  Checks checks(folder / "checks.csv", moving);
  log.add(0, moving, {}, {});
  checks.check(0, moving, {}, {});
  steps::write(folder, 0, moving);
  Shifts now{};
  bool is_last = false;
  for (int step = 1; !is_last; ++step) {
    const steps::Watch watch;
    const Shifts next = shifts_at(step);
    moving.set_metric(metric(next, has_layer));
    std::array<taut::BodyMotion, 2> motions;
    for (std::size_t i : {0, 1})
      motions[i] = {balls[i].reference, taut::RigidMotion::translation({0, 0, next[i] - now[i]})};
    const taut::Advance done = moving.advance(motions);
    for (std::size_t i : {0, 1}) now[i] += done.share * (next[i] - now[i]);
    log.add(step, moving, done, watch.seconds());
    checks.check(step, moving, done, now);
    is_last = done.obstacle || step == 2 * steps_there;
    if (is_last || step % steps_between_meshes == 0) steps::write(folder, step, moving);
    if (done.obstacle)
      std::printf("step %d: stopped after %.3f of it: %s\n", step, done.share, description(*done.obstacle).c_str());
  }
  return checks.all_hold() ? 0 : 1;
}
