// Two spheres approach each other until the gap between them is a tenth of the edges around, and leave again.
//
// usage: pinch MESH RUN FOLDER
//
// MESH is that of pinch.geo. RUN is "gap", or "wall", in which the upper sphere is driven into the wall above it. The
// metric is that of the spheres' edges, whatever the gap. After each step the mesh is checked. Writes FOLDER/steps.csv,
// FOLDER/checks.csv and the meshes of some steps with their metrics.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <taut/taut.hpp>
#include <vector>

#include "../steps.hpp"

namespace {

constexpr int lower = 2, upper = 3;     // references of the spheres
constexpr int steps_there = 20;         // and as many back
constexpr double edge = 0.1;            // of the spheres' triangles
constexpr double first_gap = 1;         // of pinch.geo
constexpr double least_gap = edge / 10;
constexpr double way_to_wall = 0.6, top = 1.8;
constexpr double coarsest = 0.4, growth = 0.3;

using Shifts = std::array<double, 2>;  // of the lower and the upper sphere, along the z axis

/// Where the spheres are after some steps; the speed is the same in all steps.
Shifts shifts_between_spheres(int step) {
  const double way = (first_gap - least_gap) / 2 * std::min(step, 2 * steps_there - step) / steps_there;
  return {way, -way};
}
Shifts shifts_to_wall(int step) {
  return {0, way_to_wall * step / steps_there};
}

double distance_from(const taut::Point& p, double z, double radius) {
  return std::max(std::sqrt(p[0] * p[0] + p[1] * p[1] + (p[2] - z) * (p[2] - z)) - radius, 0.0);
}

/// Sizes that grow from the edges of the spheres.
taut::MetricFunction metric(const Shifts& shifts) {
  return [shifts](const taut::Point& p) {
    const double d = std::min(distance_from(p, shifts[0] - 1.1, 0.5), distance_from(p, shifts[1] + 0.8, 0.4));
    const double h = std::min(edge + growth * d, coarsest);
    return taut::Tensor{1 / (h * h), 0, 0, 1 / (h * h), 0, 1 / (h * h)};
  };
}

/// The vertices of the spheres, where they were at the beginning, and their numbers now.
class Followed {
public:
  explicit Followed(const taut::Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.triangle_refs[t] == lower || mesh.triangle_refs[t] == upper)
        for (const taut::Index v : mesh.triangles[t])
          vertices_.push_back({mesh.points[v], v, mesh.triangle_refs[t] == lower ? 0U : 1U});
  }
  void renumber(const std::vector<taut::Index>& new_of_old) {
    for (auto& v : vertices_) v.now = new_of_old[v.now];
  }
  /// How far the vertices are from where they ought to be.
  [[nodiscard]] double error(const taut::Mesh& mesh, const Shifts& shifts) const {
    double worst = 0;
    for (const auto& v : vertices_) {
      const taut::Point& x = mesh.points.at(v.now);
      worst = std::max({worst, std::abs(x[0] - v.start[0]), std::abs(x[1] - v.start[1]),
                        std::abs(x[2] - v.start[2] - shifts[v.sphere])});
    }
    return worst;
  }
  /// Between the spheres, and between the upper one and the wall.
  [[nodiscard]] std::array<double, 2> gaps(const taut::Mesh& mesh) const {
    double highest[2] = {-1e9, -1e9}, lowest[2] = {1e9, 1e9};
    for (const auto& v : vertices_) {
      highest[v.sphere] = std::max(highest[v.sphere], mesh.points.at(v.now)[2]);
      lowest[v.sphere] = std::min(lowest[v.sphere], mesh.points.at(v.now)[2]);
    }
    return {lowest[1] - highest[0], top - highest[1]};
  }

private:
  struct Vertex {
    taut::Point start;
    taut::Index now;
    unsigned sphere;
  };
  std::vector<Vertex> vertices_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const bool is_gap = std::string(argv[2]) == "gap";
  const auto shifts_at = is_gap ? shifts_between_spheres : shifts_to_wall;
  const int all_steps = is_gap ? 2 * steps_there : steps_there;
  const std::filesystem::path folder = argv[3];
  taut::MotionOptions options;
  options.adaptation.max_rounds = 40;
  taut::MovingMesh moving(taut::read_mesh(argv[1]), metric({0, 0}), options);
  Followed spheres(moving.mesh());
  const double volume = taut::measure(moving.mesh(), moving.metric()).volume;
  steps::Log log(folder / "steps.csv");
  log.add(0, moving, {}, {});
  steps::write(folder, 0, moving);
  for (int step = 1; step <= all_steps; ++step) {
    const steps::Watch watch;
    const Shifts before = shifts_at(step - 1), after = shifts_at(step);
    moving.set_metric(metric(after));
    std::vector<taut::BodyMotion> motions;
    for (int k : {0, 1}) motions.push_back({k ? upper : lower, taut::RigidMotion::translation({0, 0, after[k] - before[k]})});
    const taut::Advance done = moving.advance(motions);
    spheres.renumber(done.new_of_old);
    log.add(step, moving, done, watch.seconds());
    const auto q = taut::measure(moving.mesh(), moving.metric());
    Shifts now;
    for (int k : {0, 1}) now[k] = before[k] + done.share * (after[k] - before[k]);
    const auto gaps = spheres.gaps(moving.mesh());
    std::printf("%2d gap %.5f %.5f share %.4f parts %d v %zu Q %.2f Q3 %.5f tau %.4f err %.1e vol %.1e defects %zu %.2fs %s\n", step, gaps[0], gaps[1],
                done.share, done.parts, q.vertices, q.Q_max, q.Q_up_to_3, q.tau, spheres.error(moving.mesh(), now), q.volume / volume - 1,
                taut::defects(moving.mesh()).size(), watch.seconds().elapsed, done.stopped_by.c_str());
    std::fflush(stdout);
    steps::write(folder, step, moving);
    if (done.share < 1) break;
  }
}
