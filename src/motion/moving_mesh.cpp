#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "adapt/setup.hpp"
#include "motion/moving_state.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

void require(const MotionOptions& o) {
  require_options(o.adaptation);
  if (o.rounds < 0) throw InputError(fmt::format("{} rounds found, expected 0 or more", o.rounds));
  if (o.shell < 0) throw InputError(fmt::format("shell of {} layers found, expected 0 or more", o.shell));
  if (!(o.stiffening >= 0)) throw InputError(fmt::format("stiffening {} found, expected 0 or more", o.stiffening));
  if (!(o.poisson_ratio > -1 && o.poisson_ratio < 0.5))
    throw InputError(fmt::format("Poisson ratio {} found, expected between -1 and 1/2", o.poisson_ratio));
  if (!(o.tolerance > 0)) throw InputError(fmt::format("tolerance {} found, expected above 0", o.tolerance));
  if (!(o.smallest_share > 0 && o.smallest_share <= 1))
    throw InputError(fmt::format("smallest share {} found, expected above 0, at most 1", o.smallest_share));
}

constexpr double longest = 1e100;  // so that squares and cubes stay in the range of double

bool is_usable(const Point& by) {
  return std::ranges::all_of(by, [](double x) { return std::abs(x) <= longest; });
}

bool is_usable(const RigidMotion& motion) {
  const auto is_row = [](const Point& row) { return is_usable(row); };
  return is_usable(motion.offset()) && std::ranges::all_of(motion.matrix(), is_row);
}

void require_bodies(const Mesh& mesh, std::span<const BodyMotion> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int ref = bodies[i].reference;
    if (std::ranges::find(mesh.triangle_refs, ref) == mesh.triangle_refs.end())
      throw InputError(fmt::format("motion: no triangle has the reference {}", ref));
    for (std::size_t j = 0; j < i; ++j)
      if (bodies[j].reference == ref) throw InputError(fmt::format("motion: the reference {} comes twice", ref));
    if (!is_usable(bodies[i].motion))
      throw InputError(fmt::format("motion: that of the reference {} is not finite or above {}", ref, longest));
  }
}

Goal goal_of(std::span<const PointMotion> points, const Mesh& mesh) {
  std::vector<std::uint8_t> on_boundary(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle) on_boundary[v] = 1;
  Goal goal{.motions = {},
            .displacements = std::vector<Vec3>(mesh.points.size()),
            .is_driven = std::vector<std::uint8_t>(mesh.points.size(), 0)};
  for (const auto& [point, by] : points) {
    if (point >= mesh.points.size() || on_boundary[point] == 0)
      throw InputError(fmt::format("motion: point {} is not on the boundary", point));
    if (!is_usable(by))
      throw InputError(fmt::format("motion: the displacement of point {} is not finite or above {}", point, longest));
    if (goal.is_driven[point] != 0) throw InputError(fmt::format("motion: point {} comes twice", point));
    goal.is_driven[point] = 1;
    goal.displacements[point] = by;
  }
  return goal;
}

}  // namespace

MovingMesh::MovingMesh(const Mesh& mesh, const Metric& metric, const MotionOptions& options) {
  require(options);
  on_threads(options.adaptation.threads, [&] { state_ = std::make_unique<MovingState>(mesh, metric, options); });
}
MovingMesh::MovingMesh(MovingMesh&&) noexcept = default;
MovingMesh& MovingMesh::operator=(MovingMesh&&) noexcept = default;
MovingMesh::~MovingMesh() = default;

Advance MovingMesh::advance(std::span<const BodyMotion> bodies) {
  require_bodies(mesh(), bodies);
  Goal goal;
  std::vector<int> references;
  for (const auto& [reference, motion] : bodies) {
    references.push_back(reference);
    goal.motions.push_back(motion);
  }
  Advance done;
  on_threads(state_->options.adaptation.threads, [&] { done = state_->advance(goal, references); });
  return done;
}

Advance MovingMesh::advance(std::span<const PointMotion> points) {
  const Goal goal = goal_of(points, mesh());
  Advance done;
  on_threads(state_->options.adaptation.threads, [&] { done = state_->advance(goal, {}); });
  return done;
}

const Mesh& MovingMesh::mesh() const {
  return state_->mesh;
}

const Tensors& MovingMesh::metric() const {
  return state_->metric;
}

std::vector<Point> MovingMesh::velocities(double duration) const {
  if (!(duration > 0)) throw InputError(fmt::format("duration {} found, expected above 0", duration));
  std::vector<Point> result;
  on_threads(state_->options.adaptation.threads, [&] { result = state_->displacements(); });
  for (Point& v : result)
    for (double& x : v) x /= duration;
  return result;
}

void MovingMesh::set_metric(const Metric& metric) {
  on_threads(state_->options.adaptation.threads, [&] { state_->set_metric(metric); });
}

void MovingMesh::set_fields(std::vector<Field> fields) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].values.size() != fields[i].size() * points().size())
      throw InputError(fmt::format("fields: field {} has {} numbers, expected {}", i, fields[i].values.size(),
                                   fields[i].size() * points().size()));
  state_->fields = std::move(fields);
}

const std::vector<Field>& MovingMesh::fields() const {
  return state_->fields;
}

}  // namespace taut
