#include "levelset/cut_tetrahedra.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "mesh/door.hpp"
#include "mesh/orientation.hpp"

namespace taut {
namespace {

constexpr std::size_t tets_per_cut_task = std::size_t{1} << 13;

using Polygon = std::array<Crossing, 4>;

Polygon polygon_of(const Cut& cut, const std::array<Index, 4>& v) {
  Polygon polygon{};
  for (std::size_t k = 0; k < cut.count; ++k) {
    const auto [i, j] = detail::ends_of(cut.corners[k]);
    polygon[k] = {std::min(v[i], v[j]), std::max(v[i], v[j])};
  }
  return polygon;
}

double squared_length(const LevelField& field, const Crossing& a, const Crossing& b) {
  const Vec3 d = field.position(b) - field.position(a);
  return dot(d, d);
}

/// The four corners lie in one plane, so the diagonal is free: the shorter gives the better triangles.
std::array<CrossingTriangle, 2> halves(const LevelField& field, const Polygon& p) {
  if (squared_length(field, p[1], p[3]) < squared_length(field, p[0], p[2]))
    return {{{p[0], p[1], p[3]}, {p[1], p[2], p[3]}}};
  return {{{p[0], p[1], p[2]}, {p[0], p[2], p[3]}}};
}

bool is_inverted_at(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.tetrahedra[t];
  const int sign = orientation(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  if (sign == 0) throw_flat(t, v);
  return sign < 0;
}

void add_cut(const LevelField& field, std::size_t t, std::vector<CrossingTriangle>& triangles) {
  const auto& v = field.mesh.tetrahedra[t];
  const Cut& cut = cuts[pattern_of(field.signs(v))];
  if (cut.count == 0) return;
  Polygon polygon = polygon_of(cut, v);
  if (is_inverted_at(field.mesh, t))
    std::reverse(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(cut.count));
  if (cut.count == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
  } else {
    for (const CrossingTriangle& half : halves(field, polygon)) triangles.push_back(half);
  }
}

}  // namespace

std::vector<CrossingTriangle> cut_tetrahedra(const LevelField& field) {
  const Chunks chunks(field.mesh.tetrahedra.size(), tets_per_cut_task);
  return collect_in_order<CrossingTriangle>(
      chunks, [&](std::vector<CrossingTriangle>& triangles, std::size_t t) { add_cut(field, t, triangles); });
}

}  // namespace taut
