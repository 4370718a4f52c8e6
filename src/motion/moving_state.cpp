#include "motion/moving_state.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "adapt/rounds.hpp"
#include "adapt/setup.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "geometry/off_surface.hpp"
#include "motion/numbering.hpp"
#include "motion/obstacle.hpp"
#include "motion/rigid_moves.hpp"

namespace taut {
namespace {

Session session_for(const Mesh& mesh, const Metric& metric, const AdaptOptions& options) {
  Report report;
  Session session = set_up(mesh, metric, options, report);
  if (options.max_rounds > 0)
    run_rounds(session, {.most = options.max_rounds, .block_size = options.block_size}, options.progress, report);
  session.model.has_contacts = true;
  return session;
}

void add_seconds(Advance& done, const char* phase, double seconds) {
  const auto known = std::ranges::find(done.seconds, phase, [](const auto& entry) { return entry.first; });
  if (known != done.seconds.end())
    known->second += seconds;
  else
    done.seconds.emplace_back(phase, seconds);
}

template <class Wanted>
std::vector<VertexId> vertices_where(const TetMesh& mesh, Wanted wanted) {
  std::vector<VertexId> vertices;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
    if (const auto v = static_cast<VertexId>(i); wanted(v)) vertices.push_back(v);
  return vertices;
}

std::vector<VertexId> all_vertices(const TetMesh& mesh) {
  return vertices_where(mesh, [](VertexId) { return true; });
}

// Of both, one after the other.
void follow_on(std::vector<Index>& new_of_old, const std::vector<Index>& next) {
  for (Index& point : new_of_old)
    if (point != AdaptResult::gone) point = next[point];
}

}  // namespace

MovingState::MovingState(const Mesh& input, const Metric& target, const MotionOptions& asked)
    : options(asked), session_(session_for(input, target, asked.adaptation)), follower_(options) {
  AdaptResult result = numbered(session_, input);
  mesh = std::move(result.mesh);
  metric = std::move(result.metric);
  displacements_.assign(mesh.points.size(), Point{});
}

Advance MovingState::advance(const Goal& goal, std::span<const int> bodies) {
  Advance done;
  const int iterations = follower_.iterations();
  done.new_of_old.resize(mesh.points.size());
  std::iota(done.new_of_old.begin(), done.new_of_old.end(), Index{0});
  displacements_.assign(mesh.points.size(), Point{});
  displaced_.reset();
  while (done.share < 1 && do_part(goal, bodies, done)) {
  }
  done.iterations = follower_.iterations() - iterations;
  return done;
}

Boundary MovingState::boundary_for(const Goal& goal, std::span<const int> bodies) const {
  Boundary boundary = boundary_of(session_, bodies, options.sliding);
  if (!goal.motions.empty()) {
    add_shell(boundary, session_.mesh, options.shell);
    return boundary;
  }
  for (std::size_t v = 0; v < boundary.roles.size(); ++v) {
    const std::uint32_t point = session_.mesh.origin_of_vertex[v];
    if (point < goal.displacements.size() && goal.is_driven[point] != 0) boundary.roles[v] = {Driver::body};
  }
  return boundary;
}

bool MovingState::do_part(const Goal& goal, std::span<const int> bodies, Advance& done) {
  const Stopwatch solve_watch;
  const Boundary boundary = boundary_for(goal, bodies);
  const double left = 1 - done.share;
  const Places places = follower_.places(session_.mesh, boundary, goal);
  add_seconds(done, "solve", solve_watch.seconds());

  const Stopwatch move_watch;
  const Reach reach = reach_of(session_.mesh, places, left, options.smallest_share);
  if (reach.share == 0) {
    done.obstacle = obstacle_at(*reach.in_the_way, session_, mesh, movers_of(goal, bodies, mesh));
    return false;
  }
  const bool metric_moved = move_metric(goal, bodies, reach.share);
  const auto moved = move_to(reach.places);
  const auto in_another_target = metric_moved ? all_vertices(session_.mesh) : moved;
  session_.refresh(moved, rigid_moves(boundary, goal, reach.share), in_another_target);
  take_metrics(in_another_target);
  add_seconds(done, "move", move_watch.seconds());
  done.share += reach.share;
  // Points that the caller moves keep their numbers until they have arrived.
  const bool vertices_may_change = options.changes == MeshChanges::all && (!goal.motions.empty() || done.share == 1);
  if (options.changes != MeshChanges::nothing)
    optimise(vertices_may_change, done);
  else
    done.off_surface = vertices_off_surface(session_.mesh, session_.model).size();
  ++done.parts;
  return true;
}

// Returns the vertices that have moved.
std::vector<VertexId> MovingState::move_to(const std::vector<Vec3>& places) {
  displacements_ = displacements();
  displaced_.reset();
  TetMesh& work = session_.mesh;
  auto moved = vertices_where(work, [&](VertexId v) { return places[v] != work.x(v); });
  for_each_index(moved.size(), [&](std::size_t i) {
    Vec3& x = work.vertices[moved[i]].x;
    const std::uint32_t point = work.origin_of_vertex[moved[i]];
    displacements_[point] = Vec3{displacements_[point]} + (places[moved[i]] - x);
    mesh.points[point] = x = places[moved[i]];
  });
  return moved;
}

// A metric that follows a body changes everywhere.
bool MovingState::move_metric(const Goal& goal, std::span<const int> bodies, double share) {
  if (!options.metric_follows) return false;
  const auto body = std::ranges::find(bodies, *options.metric_follows);
  if (body == bodies.end()) return false;
  metric_placement_ = goal.motions[static_cast<std::size_t>(body - bodies.begin())].share(share) * metric_placement_;
  session_.target->place(metric_placement_);
  return true;
}

void MovingState::take_metrics(std::span<const VertexId> changed) {
  for (const VertexId v : changed) metric[session_.mesh.origin_of_vertex[v]] = session_.mesh.vertices[v].m;
}

void MovingState::optimise(bool vertices_may_change, Advance& done) {
  const Stopwatch watch;
  Report report;
  run_rounds(session_,
             {.most = options.rounds,
              .block_size = options.adaptation.block_size,
              .passes = {.insertion = vertices_may_change, .collapse = vertices_may_change},
              .swap_period = 1},
             options.adaptation.progress, report);
  for (const PassReport& pass : report.passes) done.passes.push_back(pass);
  done.off_surface = report.off_surface;
  add_seconds(done, "optimise", watch.seconds());
  renew_mesh(done);
}

// Optimisation moves vertices too, so fields are transferred whenever it has run.
void MovingState::renew_mesh(Advance& done) {
  const Stopwatch watch;
  AdaptResult result = numbered(session_, mesh);
  follower_.forget_connectivity();
  add_seconds(done, "result", watch.seconds());
  transfer_fields_to(result.mesh, done);
  done.is_changed = true;
  follow_on(done.new_of_old, result.new_of_old);
  displaced_ = std::exchange(mesh, std::move(result.mesh));
  metric = std::move(result.metric);
}

void MovingState::transfer_fields_to(const Mesh& next, Advance& done) {
  if (fields.empty()) return;
  const Stopwatch watch;
  fields = transfer(mesh, fields, next, {.method = options.transfer}).fields;
  add_seconds(done, "transfer", watch.seconds());
}

std::vector<Point> MovingState::displacements() const {
  if (!displaced_) return displacements_;
  Field field{.kind = Field::Kind::vector, .values = {}};
  for (const Point& d : displacements_) field.values.insert(field.values.end(), d.begin(), d.end());
  const Field here = transfer(*displaced_, {field}, mesh, {.method = Transfer::linear}).fields[0];
  std::vector<Point> result(mesh.points.size());
  for (std::size_t i = 0; i < result.size(); ++i) std::copy_n(&here.values[3 * i], 3, result[i].begin());
  return result;
}

void MovingState::set_metric(const Metric& given) {
  set_target(session_, mesh, given, options.adaptation);
  metric_placement_ = {};
  const auto all = all_vertices(session_.mesh);
  session_.refresh_metrics(all);
  take_metrics(all);
}

}  // namespace taut
