#include "motion/follow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

// What each point had, for the vertex that it is now.
template <class Value>
std::vector<Value> start_from(const std::vector<Value>& by_point, const TetMesh& mesh) {
  std::vector<Value> start(mesh.vertices.size());
  for_each_index(start.size(), [&](std::size_t v) {
    const std::uint32_t point = mesh.origin_of_vertex[v];
    if (point < by_point.size()) start[v] = by_point[point];
  });
  return start;
}

template <class Value>
std::vector<Value> by_point(const std::vector<Value>& values, const TetMesh& mesh) {
  std::vector<Value> result(values.size());
  for_each_index(values.size(), [&](std::size_t v) {
    const std::uint32_t point = mesh.origin_of_vertex[v];
    if (point < result.size()) result[point] = values[v];
  });
  return result;
}

bool is_translation(const RigidMotion& motion) {
  return motion.matrix() == RigidMotion{}.matrix();
}

/// Velocities of the last step are those of the next in a frame that turns with the body. With a loose tolerance, a
/// start that is not turned is worse than none; bodies that turn differently have no common frame.
void turn_with_bodies(std::vector<Vec3>& start, const Goal& goal) {
  if (std::ranges::all_of(goal.motions, is_translation)) return;
  if (goal.motions.size() != 1) return start.assign(start.size(), Vec3{});
  const auto& rows = goal.motions[0].matrix();
  for_each_index(start.size(), [&](std::size_t v) {
    const Vec3 u = start[v];
    for (std::size_t i = 0; i < 3; ++i) start[v][i] = dot(Vec3{rows[i]}, u);
  });
}

std::vector<Constraint<Vec3>> velocity_constraints(const TetMesh& mesh, const Boundary& boundary, const Goal& goal) {
  std::vector<Constraint<Vec3>> constraints(mesh.vertices.size());
  for_each_index(constraints.size(), [&](std::size_t v) {
    const Role& role = boundary.roles[v];
    const Vec3& x = mesh.vertices[v].x;
    if (role.driver == Driver::wall) constraints[v] = prescribed(Vec3{});
    if (role.driver == Driver::slide) constraints[v] = boundary.sliding[v];
    if (role.driver == Driver::body) constraints[v] = prescribed(goal.velocity(role, mesh.origin_of_vertex[v], x));
  });
  return constraints;
}

// What comes nearest to the velocity among the motions of the bodies, each done to a share.
struct Carried {
  std::size_t body = 0;
  double share = 0;
  Vec3 rest;  // of the velocity
};

Carried carried_by(const Goal& goal, const Vec3& x, const Vec3& velocity) {
  Carried best{.rest = velocity};
  for (std::size_t body = 0; body < goal.motions.size(); ++body) {
    const Vec3 whole = goal.motions[body].velocity(x);
    const double square = dot(whole, whole);
    const double share = square > 0 ? std::clamp(dot(velocity, whole) / square, 0.0, 1.0) : 0;
    const Vec3 rest = velocity - share * whole;
    if (dot(rest, rest) < dot(best.rest, best.rest)) best = {body, share, rest};
  }
  return best;
}

// On the screw of the body, and straight on with the rest. Straight ways alone would lead everything away from the axis
// of a body that turns (chords: towards it), by several percent per turn.
Vec3 way(const Goal& goal, const Vec3& x, const Vec3& velocity, double share) {
  const Carried carried = carried_by(goal, x, velocity);
  if (carried.share == 0) return share * velocity;
  return Vec3{goal.motions[carried.body].share(share * carried.share)(x)} - x + share * carried.rest;
}

std::vector<Constraint<double>> share_constraints(const Boundary& boundary, std::size_t body) {
  std::vector<Constraint<double>> constraints(boundary.roles.size());
  for_each_index(constraints.size(), [&](std::size_t v) {
    const Role& role = boundary.roles[v];
    if (role.driver == Driver::wall) constraints[v] = prescribed(0.0);
    if (role.driver == Driver::body) constraints[v] = prescribed(role.body == body ? 1.0 : 0.0);
  });
  return constraints;
}

}  // namespace

template <class Value>
std::vector<Value> Follower::solved(const VertexSystem<Value>& system,
                                    const std::vector<Constraint<Value>>& constraints,
                                    const std::vector<Value>& start) {
  Solution<Value> solution = system.solve(
      constraints, start, {.stop = {.residual = options_.tolerance}, .preconditioner = Preconditioner::block_jacobi});
  iterations_ += solution.convergence.iterations;
  if (!solution.converged)
    throw Failure(fmt::format("motion: the solver stopped after {} iterations at the residual {:.2g}, expected {:.2g}",
                              solution.convergence.iterations, solution.convergence.residual, options_.tolerance));
  return std::move(solution.values);
}

Places Follower::places(const TetMesh& mesh, const Boundary& boundary, const Goal& goal) {
  if (!graph_) graph_.emplace(mesh);
  const bool is_rigid = !goal.motions.empty();
  return options_.following == Following::share && is_rigid ? by_shares(mesh, boundary, goal)
                                                            : elastic(mesh, boundary, goal);
}

Places Follower::elastic(const TetMesh& mesh, const Boundary& boundary, const Goal& goal) {
  ElasticSystem system(*graph_);
  system.assemble(elements_of(mesh, {.exponent = options_.stiffening}), {.poisson_ratio = options_.poisson_ratio});
  std::vector<Vec3> start = start_from(last_velocities_, mesh);
  turn_with_bodies(start, goal);
  auto velocities = solved<Vec3>(system, velocity_constraints(mesh, boundary, goal), start);
  last_velocities_ = by_point(velocities, mesh);
  return [&mesh, &boundary, &goal, velocities = std::move(velocities)](double share) {
    const Goal part = goal.part(share);
    std::vector<Vec3> x(velocities.size());
    for_each_index(x.size(), [&](std::size_t v) {
      const Role& role = boundary.roles[v];
      const Vec3& from = mesh.vertices[v].x;
      const std::uint32_t point = mesh.origin_of_vertex[v];
      const auto free_way = [&] { return way(goal, from, velocities[v], share); };
      x[v] = role.driver == Driver::body    ? part.place(role, point, from)
             : role.driver == Driver::slide ? from + boundary.sliding[v].free * free_way()
             : role.driver == Driver::wall  ? from
                                            : from + free_way();
    });
    return x;
  };
}

std::vector<double> Follower::share_of(const ShareSystem& system, const TetMesh& mesh, const Boundary& boundary,
                                       std::size_t body) {
  auto share = solved<double>(system, share_constraints(boundary, body), start_from(last_shares_[body], mesh));
  last_shares_[body] = by_point(share, mesh);
  return share;
}

Places Follower::by_shares(const TetMesh& mesh, const Boundary& boundary, const Goal& goal) {
  const std::size_t bodies = goal.motions.size();
  last_shares_.resize(bodies);
  ShareSystem system(*graph_);
  system.assemble(elements_of(mesh, {.exponent = options_.stiffening}));
  std::vector<std::vector<double>> shares(bodies);
  for (std::size_t body = 0; body < bodies; ++body) shares[body] = share_of(system, mesh, boundary, body);
  return [&mesh, &boundary, &goal, shares = std::move(shares)](double share) {
    std::vector<Vec3> x(mesh.vertices.size());
    for_each_index(x.size(), [&](std::size_t v) {
      const Vec3& from = mesh.vertices[v].x;
      Vec3 by{};
      for (std::size_t body = 0; body < shares.size(); ++body)
        if (shares[body][v] != 0) by = by + (goal.motions[body].share(share * shares[body][v])(from) - from);
      const Role& role = boundary.roles[v];
      x[v] = from + (role.driver == Driver::slide ? boundary.sliding[v].free * by : by);
    });
    return x;
  };
}

}  // namespace taut
