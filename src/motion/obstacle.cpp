#include "motion/obstacle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "locate/closest_on_triangle.hpp"
#include "locate/triangle_tree.hpp"
#include "metric/length.hpp"

namespace taut {
namespace {

Vec3 middle_of(const TetMesh& mesh, TetId tet) {
  Vec3 sum{};
  for (const VertexId v : mesh.tets[tet].v) sum = sum + 0.25 * mesh.x(v);
  return sum;
}

/// The reference of the triangle nearest to x among those whose reference is wanted.
std::optional<int> nearest_reference(const Mesh& mesh, const Vec3& x, const std::function<bool(int)>& is_wanted) {
  std::optional<int> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_wanted(mesh.triangle_refs[t])) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    const double distance = closest_on_triangle(x, {mesh.points[a], mesh.points[b], mesh.points[c]}).squared_distance;
    if (distance >= least) continue;
    least = distance;
    nearest = mesh.triangle_refs[t];
  }
  return nearest;
}

bool are_alike(const RigidMotion& a, const RigidMotion& b) {
  return a.matrix() == b.matrix() && a.offset() == b.offset();
}

bool is_moved(const Goal& goal, const std::array<Index, 3>& triangle) {
  return std::ranges::any_of(triangle, [&](Index v) {
    return v < goal.is_driven.size() && goal.is_driven[v] != 0 && goal.displacements[v] != Vec3{};
  });
}

constexpr std::size_t nobody = 0;

std::size_t mover(const Movers& movers, int reference) {
  const auto found = movers.find(reference);
  return found == movers.end() ? nobody : found->second;
}

TriangleTree tree_of(const Mesh& mesh, int reference) {
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == reference) triangles.push_back(mesh.triangles[t]);
  return {mesh.points, triangles};
}

/// A straight line from one surface to another.
struct Gap {
  Vec3 from, to;
  [[nodiscard]] double width() const { return norm(to - from); }
};

/// The narrowest gap that begins at a vertex of a reference, and not farther from x than `radius`; `best` if none is
/// narrower.
Gap narrowest_from(const Mesh& mesh, int reference, const TriangleTree& to, const Vec3& x, double radius, Gap best) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_refs[t] != reference) continue;
    for (const Index v : mesh.triangles[t]) {
      const Vec3& from = mesh.points[v];
      if (norm(from - x) > radius) continue;
      const Gap gap{from, to.closest(from).point};
      if (gap.width() < best.width()) best = gap;
    }
  }
  return best;
}

/// The narrowest gap between surfaces a and b near x, where `edge` is a length of edges. If it is between two edges,
/// the one from a vertex is hardly wider.
Gap gap_between(const Mesh& mesh, int a, int b, const Vec3& x, double edge) {
  const TriangleTree on_a = tree_of(mesh, a), on_b = tree_of(mesh, b);
  const Vec3 start = on_a.closest(x).point;
  const Gap first{start, on_b.closest(start).point};
  const double radius = 2 * (edge + first.width());
  const Gap there = narrowest_from(mesh, a, on_b, x, radius, first);
  const Gap back = narrowest_from(mesh, b, on_a, x, radius, {there.to, there.from});
  return {back.to, back.from};
}

/// The length of an edge of the metric of a tetrahedron along d; in no direction in particular if that is zero.
double size_along(const TetMesh& mesh, TetId tet, const Vec3& d) {
  const double length = norm(d);
  double size = 0;
  for (const VertexId v : mesh.tets[tet].v) {
    const Sym3& m = mesh.vertices[v].m;
    size += 0.25 * (length > 0 ? length / length_in(m, d) : std::pow(determinant(m), -1.0 / 6));
  }
  return size;
}

}  // namespace

Movers movers_of(const Goal& goal, std::span<const int> bodies, const Mesh& mesh) {
  Movers movers;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidMotion& motion = goal.motions[i];
    const auto first = std::ranges::find_if(goal.motions, [&](const RigidMotion& m) { return are_alike(m, motion); });
    if (!are_alike(motion, {})) movers[bodies[i]] = 1 + static_cast<std::size_t>(first - goal.motions.begin());
  }
  if (!goal.motions.empty()) return movers;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (is_moved(goal, mesh.triangles[t])) movers.try_emplace(mesh.triangle_refs[t], 1 + movers.size());
  return movers;
}

Obstacle obstacle_at(TetId tet, const Session& session, const Mesh& mesh, const Movers& movers) {
  Obstacle found{.reason = Obstacle::Reason::tangle, .place = middle_of(session.mesh, tet)};
  const auto body = nearest_reference(mesh, found.place, [&](int ref) { return mover(movers, ref) != nobody; });
  found.body = body.value_or(0);
  const auto other =
      nearest_reference(mesh, found.place, [&](int ref) { return mover(movers, ref) != mover(movers, found.body); });
  found.other = other.value_or(found.body);
  found.size = size_along(session.mesh, tet, Vec3{});
  if (!body || !other) return found;
  const Gap gap = gap_between(mesh, *body, *other, found.place, found.size);
  found.gap = gap.width();
  found.size = size_along(session.mesh, tet, gap.to - gap.from);
  if (found.gap < found.size) {
    found.reason = Obstacle::Reason::contact;
    found.place = 0.5 * (gap.from + gap.to);
  }
  return found;
}

std::string description(const Obstacle& o) {
  const std::string where = fmt::format("({:.6g}, {:.6g}, {:.6g})", o.place[0], o.place[1], o.place[2]);
  const std::string measures = fmt::format("the gap is {:.3g}, the edges of the metric are {:.3g}", o.gap, o.size);
  if (o.reason == Obstacle::Reason::contact)
    return fmt::format("the triangles of reference {} meet those of reference {} near {}: {}", o.body, o.other, where,
                       measures);
  return fmt::format("a tetrahedron between the triangles of references {} and {} would turn over near {}: {}", o.body,
                     o.other, where, measures);
}

}  // namespace taut
