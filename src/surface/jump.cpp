#include "surface/jump.hpp"

#include <algorithm>
#include <cmath>

#include "surface/jet.hpp"

namespace taut {
namespace {

constexpr std::size_t fewest_points_of_side = 8;
constexpr int most_rings_of_side = 2;
constexpr double least_cosine_of_side = 0.2;  ///< to the triangle at the edge: the surface folds beyond

bool holds(const std::vector<VertexId>& vertices, VertexId v) {
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

Vec3 unit(const Vec3& a) {
  const double length = norm(a);
  return length > 0 ? 1 / length * a : a;
}

}  // namespace

JumpFinder::JumpFinder(const Facets& facets, std::span<const int> refs, std::span<const Vec3> normals)
    : facets_(facets),
      refs_(refs),
      normals_(normals),
      triangles_of_vertices_(triangles_of_vertices(facets)),
      tolerance_(flatness_tolerance(facets)) {}

double JumpFinder::jump_at(const EdgePair& pair) const {
  const Vec3 a = normal_of_side(pair[0], pair[1]), b = normal_of_side(pair[1], pair[0]);
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// Ring by ring, through triangles whose normals are nearer to that of this side's triangle than to the other's: this
// does not go around the end of the edge, whether the ridge goes on there or not.
std::vector<VertexId> JumpFinder::points_of_side(const EdgeUse& side, const EdgeUse& other) const {
  const Vec3 &own = normals_[side.triangle], apart = own - normals_[other.triangle];
  const auto is_of_side = [&](TriangleId t) {
    return refs_[t] == refs_[side.triangle] && dot(normals_[t], apart) >= 0 &&
           dot(normals_[t], own) >= least_cosine_of_side;
  };
  const Corners& first = facets_.triangles[side.triangle];
  std::vector<VertexId> points(first.begin(), first.end());
  std::size_t begin = 0;
  for (int ring = 0; ring < most_rings_of_side && points.size() < fewest_points_of_side; ++ring) {
    const std::size_t end = points.size();
    for (std::size_t i = begin; i < end; ++i)
      for (const TriangleId t : triangles_of_vertices_[points[i]]) {
        if (!is_of_side(t)) continue;
        for (const VertexId v : facets_.triangles[t])
          if (!holds(points, v)) points.push_back(v);
      }
    begin = end;
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
