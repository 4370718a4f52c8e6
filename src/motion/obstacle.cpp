#include "motion/obstacle.hpp"

#include <fmt/format.h>

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

/// Who moves how: references, those that stay among them.
class Movers {
public:
  explicit Movers(const MotionOfReference& motions) : motions_(motions) {}

  [[nodiscard]] bool moves(int reference) const { return motions_.empty() || !are_alike(motion_of(reference), {}); }
  [[nodiscard]] bool differ(int a, int b) const {
    return motions_.empty() ? a != b : !are_alike(motion_of(a), motion_of(b));
  }

private:
  static bool are_alike(const RigidMotion& a, const RigidMotion& b) {
    return a.matrix() == b.matrix() && a.offset() == b.offset();
  }
  [[nodiscard]] RigidMotion motion_of(int reference) const {
    const auto found = motions_.find(reference);
    return found == motions_.end() ? RigidMotion{} : found->second;
  }

  const MotionOfReference& motions_;
};

TriangleTree tree_of(const Mesh& mesh, int reference) {
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == reference) triangles.push_back(mesh.triangles[t]);
  return {mesh.points, triangles};
}

/// A way from one surface to another.
struct Way {
  Vec3 from, to;
  [[nodiscard]] double length() const { return norm(to - from); }
};

/// The shortest way that begins at a vertex of a reference, and not farther from x than `radius`; `best` if no way is
/// shorter.
Way shortest_from(const Mesh& mesh, int reference, const TriangleTree& to, const Vec3& x, double radius, Way best) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangle_refs[t] != reference) continue;
    for (const Index v : mesh.triangles[t]) {
      const Vec3& from = mesh.points[v];
      if (norm(from - x) > radius) continue;
      const Way way{from, to.closest(from).point};
      if (way.length() < best.length()) best = way;
    }
  }
  return best;
}

/// The shortest way from surface a to b near x, which is within some edges of it. A way between two edges is at most
/// replaced by one from a vertex, which is hardly longer.
Way across(const Mesh& mesh, int a, int b, const Vec3& x, double edge) {
  const TriangleTree on_a = tree_of(mesh, a), on_b = tree_of(mesh, b);
  const Vec3 start = on_a.closest(x).point;
  const Way first{start, on_b.closest(start).point};
  const double radius = 2 * (edge + first.length());
  const Way there = shortest_from(mesh, a, on_b, x, radius, first);
  const Way back = shortest_from(mesh, b, on_a, x, radius, {there.to, there.from});
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

Obstacle obstacle_at(TetId tet, const Session& session, const Mesh& mesh, const MotionOfReference& motions) {
  const Movers movers(motions);
  Obstacle found{.reason = Obstacle::Reason::tangle, .place = middle_of(session.mesh, tet)};
  const auto body = nearest_reference(mesh, found.place, [&](int ref) { return movers.moves(ref); });
  found.body = body.value_or(0);
  const auto other = nearest_reference(mesh, found.place, [&](int ref) { return movers.differ(ref, found.body); });
  found.other = other.value_or(found.body);
  found.size = size_along(session.mesh, tet, Vec3{});
  if (!body || !other) return found;
  const Way way = across(mesh, *body, *other, found.place, found.size);
  found.gap = way.length();
  found.size = size_along(session.mesh, tet, way.to - way.from);
  if (found.gap < found.size) {
    found.reason = Obstacle::Reason::contact;
    found.place = 0.5 * (way.from + way.to);
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
