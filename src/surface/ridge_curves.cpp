#include "surface/ridge_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/handles.hpp"

namespace taut {
namespace {

constexpr double least_turn = 15, most_turn = 45;  ///< degrees
constexpr double least_share_of_turn = 0.6;

double degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// Ridge edges as a graph.
class RidgeGraph {
public:
  RidgeGraph(const std::vector<Vec3>& points, std::span<const RidgeEdge> ridges)
      : points_(points),
        ridges_(ridges),
        edges_at_(gather<Index>(ridges.size(), points.size(), [&](std::size_t e, auto put) {
          for (const VertexId v : ridges[e].edge) put(v, static_cast<Index>(e));
        })) {}

  [[nodiscard]] std::span<const Index> at(VertexId v) const { return edges_at_[v]; }
  [[nodiscard]] VertexId beyond(Index edge, VertexId v) const {
    return ridges_[edge].edge[0] == v ? ridges_[edge].edge[1] : ridges_[edge].edge[0];
  }
  [[nodiscard]] Index next(Index edge, VertexId v) const { return at(v)[0] == edge ? at(v)[1] : at(v)[0]; }

  /// Whether the chain ends at a vertex of two ridge edges.
  [[nodiscard]] bool parts(VertexId v, std::optional<double> angle) const {
    const Index e = at(v)[0], f = at(v)[1];
    if (ridges_[e].ref != ridges_[f].ref) return true;
    const Vec3 in = points_[v] - points_[beyond(e, v)], out = points_[beyond(f, v)] - points_[v];
    const double turn = degrees_between(in, out);
    if (angle) return turn >= *angle;
    if (turn <= least_turn || turn > most_turn) return turn > most_turn;
    const auto a = tangent_of_side(e, v), b = tangent_of_side(f, v);
    if (!a || !b) return false;
    const double jump = degrees_between(*a, -1 * *b);
    return jump > least_turn && jump > least_share_of_turn * turn;
  }

private:
  /// At v, towards it: of the circle through it and the two vertices before it. None if the chain is too short.
  [[nodiscard]] std::optional<Vec3> tangent_of_side(Index edge, VertexId v) const {
    const VertexId w = beyond(edge, v);
    if (at(w).size() != 2) return {};
    const VertexId u = beyond(next(edge, w), w);
    if (u == v) return {};
    return reflected(tangent_of_circle(points_[u], points_[w], points_[v]), points_[v] - points_[w]);
  }

  const std::vector<Vec3>& points_;
  std::span<const RidgeEdge> ridges_;
  Buckets<Index> edges_at_;
};

/// Follows the chain from `v` along `edge` to a corner, or around.
RidgeCurve follow(const RidgeGraph& graph, std::span<const std::uint8_t> is_corner, Index edge, VertexId v) {
  RidgeCurve curve;
  curve.vertices.push_back(v);
  while (true) {
    curve.edges.push_back(edge);
    v = graph.beyond(edge, v);
    curve.vertices.push_back(v);
    if (is_corner[v] != 0 || v == curve.vertices.front()) return curve;
    edge = graph.next(edge, v);
  }
}

/// At each vertex of a chain: of the circle through it and its neighbours, and at open ends that of the last one.
std::vector<Vec3> tangents_of(const std::vector<Vec3>& x, bool closed) {
  const std::size_t n = x.size();
  std::vector<Vec3> tangents(n);
  if (n == 2) return {x[1] - x[0], x[1] - x[0]};
  for (std::size_t i = 1; i + 1 < n; ++i) tangents[i] = tangent_of_circle(x[i - 1], x[i], x[i + 1]);
  if (closed) {
    tangents.front() = tangents.back() = tangent_of_circle(x[n - 2], x[0], x[1]);
  } else {
    tangents.front() = reflected(tangents[1], x[1] - x[0]);
    tangents.back() = reflected(tangents[n - 2], x[n - 1] - x[n - 2]);
  }
  return tangents;
}

/// A chain that folds back onto itself has no tangent there: then that of the edge.
Vec3 unit_or(const Vec3& tangent, const Vec3& edge) {
  const double length = norm(tangent);
  return length > 0 ? 1 / length * tangent : 1 / norm(edge) * edge;
}

std::vector<CubicSegment> segments_of(const RidgeCurve& curve, const std::vector<Vec3>& points, bool is_smooth_loop) {
  std::vector<Vec3> x;
  for (const VertexId v : curve.vertices) x.push_back(points[v]);
  std::vector<Vec3> tangents = tangents_of(x, is_smooth_loop);
  for (std::size_t i = 0; i < x.size(); ++i)
    tangents[i] = unit_or(tangents[i], x[i > 0 ? i : 1] - x[i > 0 ? i - 1 : 0]);
  std::vector<CubicSegment> segments;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const Vec3 e = x[i + 1] - x[i];
    segments.push_back(
        {x[i], x[i] + handle_along(e, tangents[i]), x[i + 1] - handle_along(e, tangents[i + 1]), x[i + 1]});
  }
  return segments;
}

}  // namespace

Vec3 tangent_of_circle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 in = b - a, out = c - b;
  return 1 / dot(in, in) * in + 1 / dot(out, out) * out;
}

Vec3 reflected(const Vec3& tangent, const Vec3& e) {
  return 2 * dot(tangent, e) / dot(e, e) * e - tangent;
}

RidgeCurves find_ridge_curves(const std::vector<Vec3>& points, std::span<const RidgeEdge> ridges,
                              std::span<const std::uint8_t> given, std::optional<double> angle) {
  const RidgeGraph graph(points, ridges);
  RidgeCurves found{{}, std::vector<CubicSegment>(ridges.size()), std::vector<std::uint8_t>(points.size(), 0)};
  for (const VertexId v : ids<VertexId>(points.size())) {
    const std::size_t degree = graph.at(v).size();
    found.is_corner[v] = degree != 0 && (degree != 2 || given[v] != 0 || graph.parts(v, angle));
  }
  std::vector<std::uint8_t> is_done(ridges.size(), 0);
  const auto add = [&](Index edge, VertexId from) {
    if (is_done[edge] != 0) return;
    RidgeCurve curve = follow(graph, found.is_corner, edge, from);
    curve.ref = ridges[edge].ref;
    curve.segments = segments_of(curve, points, curve.is_closed() && found.is_corner[from] == 0);
    for (std::size_t i = 0; i < curve.edges.size(); ++i) {
      is_done[curve.edges[i]] = 1;
      CubicSegment& segment = found.of_edge[curve.edges[i]] = curve.segments[i];
      if (curve.vertices[i] > curve.vertices[i + 1]) std::reverse(segment.begin(), segment.end());
    }
    found.curves.push_back(std::move(curve));
  };
  for (const VertexId v : ids<VertexId>(points.size()))
    if (found.is_corner[v] != 0)
      for (const Index e : graph.at(v)) add(e, v);
  for (Index e = 0; e < ridges.size(); ++e) add(e, ridges[e].edge[0]);  // loops without corners
  return found;
}

}  // namespace taut
