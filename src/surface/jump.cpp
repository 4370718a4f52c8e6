#include "surface/jump.hpp"

#include <algorithm>
#include <cmath>

#include "surface/jet.hpp"

namespace taut {
namespace {

constexpr std::size_t fewest_points_of_side = 8;
constexpr std::size_t fewest_points_by_normal = 6;
constexpr int most_rings_of_side = 2;
constexpr double least_cosine_of_side = 0.2;          ///< to the triangle at the edge: the surface folds beyond
constexpr double largest_cosine_of_fold = 0.8660254;  ///< 30 degrees: an edge that turns by less is no end of a side

template <class Id>
bool holds(const std::vector<Id>& ids, Id id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

Vec3 unit(const Vec3& a) {
  const double length = norm(a);
  return length > 0 ? 1 / length * a : a;
}

}  // namespace

JumpFinder::JumpFinder(const Facets& facets, std::span<const EdgePair> pairs, std::span<const int> refs,
                       std::span<const Vec3> normals)
    : facets_(facets),
      refs_(refs),
      normals_(normals),
      beyond_(facets.triangles.size(), {none, none, none}),
      tolerance_(flatness_tolerance(facets)) {
  for (const auto& [s, t] : pairs) {
    beyond_[s.triangle][s.corner] = t.triangle;
    beyond_[t.triangle][t.corner] = s.triangle;
  }
}

double JumpFinder::jump_at(const EdgePair& pair) const {
  const Vec3 a = normal_of_side(pair[0], pair[1]), b = normal_of_side(pair[1], pair[0]);
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// Triangles of a side have normals that are, seen along the edge, nearer to that of this side's triangle than to the
// other's: so a side does not go around the end of the edge, whether the ridge goes on there or not. Where the surface
// bends to and fro, this leaves too few; then those count that lie on this side of the edge.
std::vector<VertexId> JumpFinder::points_of_side(const EdgeUse& side, const EdgeUse& other) const {
  const Vec3 &own = normals_[side.triangle], &opposite = normals_[other.triangle];
  const Vec3& origin = facets_.points[side.edge[0]];
  const Vec3 along = facets_.points[side.edge[1]] - origin, middle = own + opposite;
  const Vec3 apart = own - opposite, to_own_normal = apart - dot(apart, along) / dot(along, along) * along,
             to_side = cross(along, middle);
  const auto by_normal = grown(side, other, [&](TriangleId t) { return dot(normals_[t], to_own_normal) >= 0; });
  if (by_normal.size() >= fewest_points_by_normal) return by_normal;
  const auto place = [&](TriangleId t) {
    const auto [a, b, c] = places_of(facets_, t);
    return dot(to_side, a + b + c - 3 * origin);
  };
  const bool is_positive = place(side.triangle) > 0;
  return grown(side, other, [&](TriangleId t) { return (place(t) > 0) == is_positive; });
}

// Ring by ring around the points so far, and not across edges that turn by clearly more than this one.
template <class IsOfSide>
std::vector<VertexId> JumpFinder::grown(const EdgeUse& side, const EdgeUse& other, IsOfSide is_of_side) const {
  const Vec3& own = normals_[side.triangle];
  const double cosine = dot(own, normals_[other.triangle]);
  const double sharper = std::min(cosine * std::abs(cosine), largest_cosine_of_fold);
  const auto may_enter = [&](TriangleId from, TriangleId to) {
    return to != none && to != other.triangle && refs_[to] == refs_[side.triangle] &&
           dot(normals_[to], own) >= least_cosine_of_side && dot(normals_[to], normals_[from]) >= sharper &&
           is_of_side(to);
  };
  std::vector<TriangleId> triangles{side.triangle};
  std::vector<VertexId> points(facets_.triangles[side.triangle].begin(), facets_.triangles[side.triangle].end());
  for (int ring = 0; ring < most_rings_of_side && points.size() < fewest_points_of_side; ++ring) {
    const std::vector<VertexId> inner = points;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (const TriangleId t : beyond_[triangles[i]]) {
        if (!may_enter(triangles[i], t) || holds(triangles, t)) continue;
        const Corners& corners = facets_.triangles[t];
        if (std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return holds(inner, v); })) continue;
        triangles.push_back(t);
        for (const VertexId v : corners)
          if (!holds(points, v)) points.push_back(v);
      }
  }
  return points;
}

Vec3 JumpFinder::normal_of_side(const EdgeUse& side, const EdgeUse& other) const {
  const std::vector<VertexId> points = points_of_side(side, other);
  Vec3 sum{};
  std::vector<Vec3> offsets;
  for (const VertexId end : side.edge) {
    offsets.clear();
    for (const VertexId v : points)
      if (v != end) offsets.push_back(facets_.points[v] - facets_.points[end]);
    sum = sum + unit(jet(normals_[side.triangle], offsets, tolerance_).gradient);
  }
  return unit(sum);
}

}  // namespace taut
