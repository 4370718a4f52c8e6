#include "placing/placing.hpp"

#include <algorithm>
#include <cmath>

#include "base/each_once.hpp"
#include "operators/insertion.hpp"
#include "operators/relocation.hpp"
#include "operators/vertex_move.hpp"

namespace taut {
namespace {

constexpr int most_steps = 20;           // of Newton's method; the surface may cross the boundary at an angle
constexpr double on_surface_to = 1e-10;  // of the size of the metric
constexpr double difference = 1e-4;      // step of the gradient, of that size
constexpr double farthest = 1;      // move, of that size: the surface that a farther one meets is another part of it
constexpr double clearance = 0.15;  // of an edge: nearer to its ends no vertex is inserted
constexpr int most_sweeps = 12, relaxations = 3;
constexpr double lost_quality = 0.9;  // of what was bad before
constexpr double worst_moved = 4;     // a move that leaves bad tetrahedra makes it hard to insert vertices later
constexpr double insistence = 0.3;
constexpr int most_insistences = 2;
const IdNeed some_ids = {256, 8192, 1024};

}  // namespace

Placing::Placing(Session& session, const LevelFunction& function, const PlaceOptions& options)
    : kernel_{session.mesh, session.model, *session.target},
      mesh_(session.mesh),
      function_(function),
      options_(options),
      worst_inserted_(1 / options.Q_max),
      values_(session.mesh.vertices.size()) {
  kernel_.block = &whole_;
  for (std::size_t v = 0; v < values_.size(); ++v) {
    CellId host = mesh_.host_of_vertex[v];
    values_[v] = function.at(mesh_.vertices[v].x, host);
  }
}

void Placing::run() {
  move();
  split_crossed();
  relax();
  split_deviating();
  whole_.give_back(mesh_);
}

double Placing::size_at(VertexId v) const {
  const Sym3& m = mesh_.vertices[v].m;
  return std::sqrt(3 / (m[0] + m[3] + m[5]));
}

bool Placing::is_crossed(VertexId a, VertexId b) const {
  return (values_[a] < 0 && values_[b] > 0) || (values_[a] > 0 && values_[b] < 0);
}

std::size_t Placing::crossed() const {
  std::vector<std::array<VertexId, 2>> edges;
  for (const Tet& tet : mesh_.tets)
    for (const auto& [i, j] : edge_vertices)
      if (tet.alive() && is_crossed(tet.v[i], tet.v[j]))
        edges.push_back({std::min(tet.v[i], tet.v[j]), std::max(tet.v[i], tet.v[j])});
  keep_each_once(edges);
  return edges.size();
}

std::vector<VertexId> Placing::candidates(End end) const {
  std::vector<VertexId> found;
  for (const Tet& tet : mesh_.tets)
    for (const auto& [i, j] : edge_vertices) {
      const VertexId a = tet.v[i], b = tet.v[j];
      if (!tet.alive() || !is_crossed(a, b)) continue;
      found.push_back((std::abs(values_[a]) <= std::abs(values_[b])) == (end == End::nearer) ? a : b);
    }
  keep_each_once(found);
  std::ranges::stable_sort(found, {}, [&](VertexId v) { return std::abs(values_[v]); });
  return found;
}

void Placing::move() {
  for (const End end : {End::nearer, End::farther})
    for (const VertexId v : candidates(end))
      if (has_crossed_edge(v)) moved_ += move(v) ? 1 : 0;
}

/// Also collects the ball.
bool Placing::has_crossed_edge(VertexId v) {
  bool found = false;
  const auto visit = [&](const Tet& tet, int, VertexId) {
    for (const VertexId w : tet.v) found |= is_crossed(v, w);
  };
  return walk_ball(mesh_, v, kernel_.cavity.tets, visit) && found;
}

bool Placing::move(VertexId v) {
  const Tag tag = mesh_.tag_of_vertex[v];
  if (tag.is_at_corner()) return false;
  const auto x = on_surface(mesh_.x(v), tag, mesh_.host_of_vertex[v], size_at(v));
  if (!x) return false;
  VertexMove move(kernel_, v);
  if (move.gather() != Outcome::accepted || move.propose(*x - mesh_.x(v)) != Outcome::accepted) return false;
  const double least = std::min(worst_moved / options_.Q_max, lost_quality * move.old_quality());
  if (!kernel_.batch.all_above(least) || move.commit({}) != Outcome::accepted) return false;
  values_[v] = 0;
  return true;
}

/// Newton's method along the gradient; on a patch or line each step is taken back to it.
std::optional<Vec3> Placing::on_surface(Vec3 x, Tag tag, CellId host, double size) const {
  const Vec3 start = x;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 g = function_.gradient(x, host, difference * size);
    const double value = function_.at(x, host), slope = dot(g, g);
    if (!(slope > 0)) return {};
    if (std::abs(value) <= on_surface_to * size * std::sqrt(slope)) return x;
    x = kernel_.model.project(tag, x - (value / slope) * g);
    if (!(norm(x - start) <= farthest * size)) return {};
  }
  return {};
}

void Placing::lend_ids() {
  if (whole_.vertices.available() < 8 || whole_.tets.available() < 1024 || whole_.triangles.available() < 128)
    whole_.borrow(mesh_, some_ids);
}

/// The vertex goes to the surface's place nearest to `near`.
bool Placing::insert(TetId t, int edge, const Vec3& near) {
  lend_ids();
  const auto& [i, j] = edge_vertices[edge];
  const VertexId a = mesh_.tets[t].v[i];
  const auto x = on_surface(near, Tag{}, mesh_.host_of_vertex[a], size_at(a));
  if (!x) return false;
  const VertexId made = whole_.vertices.next();
  const InsertionRules rules = {
      .shortest_new_edge = 0.05, .worst_quality = worst_inserted_, .share_of_old = lost_quality};
  if (insert_on_edge(kernel_, t, edge, *x, rules) != Outcome::accepted) return false;
  if (values_.size() < mesh_.vertices.size()) values_.resize(mesh_.vertices.size());
  CellId host = mesh_.host_of_vertex[made];
  values_[made] = mesh_.x(made) == *x ? 0 : function_.at(mesh_.x(made), host);
  if (values_[made] != 0) (void)move(made);  // on a patch or line it was taken off the surface
  ++inserted_;
  return true;
}

/// Calls choose(t) for the tetrahedra that exist now, and inserts a vertex where it says.
template <class Choose>
std::size_t Placing::split_where(Choose choose) {
  std::size_t done = 0;
  const std::size_t count = mesh_.tets.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<TetId>(i);
    if (!mesh_.tets[t].alive()) continue;
    const std::optional<Split> split = choose(t);
    if (split && insert(t, split->edge, split->near)) ++done;
  }
  return done;
}

std::optional<Placing::Split> Placing::at_crossing(TetId t) const {
  const auto& v = mesh_.tets[t].v;
  for (int edge = 0; edge < 6; ++edge) {
    const VertexId a = v[edge_vertices[edge][0]], b = v[edge_vertices[edge][1]];
    if (!is_crossed(a, b)) continue;
    const double share = values_[a] / (values_[a] - values_[b]);
    if (share < clearance || share > 1 - clearance) continue;
    return Split{edge, mesh_.x(a) + share * (mesh_.x(b) - mesh_.x(a))};
  }
  return {};
}

double Placing::deviation_at(const Vec3& x, VertexId near) const {
  CellId host = mesh_.host_of_vertex[near];
  const double slope = norm(function_.gradient(x, host, difference * size_at(near)));
  return slope > 0 ? std::abs(function_.at(x, host)) / slope : 0;
}

/// The edge on the surface whose middle is farthest from it, or else the longest one of a face whose centre is too far.
std::optional<Placing::Split> Placing::at_deviation(TetId t) const {
  const auto& v = mesh_.tets[t].v;
  const auto middle = [&](int edge) {
    return 0.5 * (mesh_.x(v[edge_vertices[edge][0]]) + mesh_.x(v[edge_vertices[edge][1]]));
  };
  std::optional<Split> worst;
  double most = options_.deviation, longest = 0;
  for (int edge = 0; edge < 6; ++edge) {
    const auto& [i, j] = edge_vertices[edge];
    if (values_[v[i]] != 0 || values_[v[j]] != 0) continue;
    const double found = deviation_at(middle(edge), v[i]);
    if (found <= most) continue;
    most = found;
    worst = Split{edge, middle(edge)};
  }
  if (worst) return worst;
  for (const auto& [i, j, k] : face_vertices) {
    if (values_[v[i]] != 0 || values_[v[j]] != 0 || values_[v[k]] != 0) continue;
    const Vec3 centre = (1.0 / 3) * (mesh_.x(v[i]) + mesh_.x(v[j]) + mesh_.x(v[k]));
    if (deviation_at(centre, v[i]) <= options_.deviation) continue;
    for (const int edge : {edge_between[i][j], edge_between[j][k], edge_between[k][i]}) {
      const double length = kernel_.length(v[edge_vertices[edge][0]], v[edge_vertices[edge][1]]);
      if (length <= longest) continue;
      longest = length;
      worst = Split{edge, middle(edge)};
    }
  }
  return worst;
}

void Placing::split_crossed() {
  split_where([&](TetId t) { return at_crossing(t); });
}

void Placing::split_deviating() {
  if (!(options_.deviation > 0)) return;
  int insisted = 0;
  for (int sweep = 0; sweep < most_sweeps && insisted <= most_insistences; ++sweep) {
    const std::size_t done = split_where([&](TetId t) { return at_deviation(t); });
    relax();
    if (done > 0) continue;
    worst_inserted_ *= insistence;  // where the mesh is bad, a bad vertex is better than none
    ++insisted;
  }
}

/// Relocates vertices that are not on the surface. It bounds the tetrahedra around them, so they stay on their side.
void Placing::relax() {
  for (int sweep = 0; sweep < relaxations; ++sweep)
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto v = static_cast<VertexId>(i);
      if (values_[v] == 0 || !mesh_.is_vertex_alive(v) || !mesh_.state_of_vertex[v].restless) continue;
      if (relocate(kernel_, v, {}) != Outcome::accepted) continue;
      CellId host = mesh_.host_of_vertex[v];
      values_[v] = function_.at(mesh_.x(v), host);
    }
}

}  // namespace taut
