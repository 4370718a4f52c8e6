// How near the triangles of an adapted part are to the exact surfaces of its CAD model.
#pragma once

#include "adapt/part_checks.hpp"

namespace taut::test {

inline double longest_edge(const Mesh& mesh, const std::array<Index, 3>& t) {
  double most = 0;
  for (int k = 0; k < 3; ++k) most = std::max(most, norm(mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]));
  return most;
}

/// Of the centre and of the middles of the edges.
inline double distance_of(const Mesh& mesh, const std::array<Index, 3>& t, const Shape& shape) {
  double most = std::abs(shape.distance(centre_of(mesh, t)));
  for (int k = 0; k < 3; ++k)
    most = std::max(most, std::abs(shape.distance(0.5 * (mesh.points[t[k]] + mesh.points[t[(k + 1) % 3]]))));
  return most;
}

/// How far the flat triangle of this longest edge may be from a surface on which its corners lie: no point of it is
/// farther from the nearest corner than the centre of an equilateral triangle.
inline double sag_of(const Mesh& mesh, const std::array<Index, 3>& t, const Shape& shape) {
  double radius = shape.radius(mesh.points[t[0]]);
  for (const Index p : t) radius = std::min(radius, shape.radius(mesh.points[p]));
  const double reach = longest_edge(mesh, t) / std::numbers::sqrt3;
  return reach < radius ? radius - std::sqrt(radius * radius - reach * reach) : reach;
}

struct Accuracy {
  double of_vertices = 0;   ///< largest distance
  double mean = 0;          ///< distance of the corners of triangles
  double of_triangles = 0;  ///< largest distance
  double excess = 0;        ///< largest, of the distance of a triangle over its sag_of()
  double volume = 0;        ///< sum of the areas times the distances of triangles: as much as volumes may differ
};

inline Accuracy accuracy_of(const Mesh& mesh, const std::map<int, Shape>& shapes) {
  Accuracy a;
  double corners = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto found = shapes.find(ref_of(mesh.triangle_refs, i));
    if (found == shapes.end()) continue;
    const auto& [ref, shape] = *found;
    const auto& t = mesh.triangles[i];
    for (const Index p : t) {
      const double distance = std::abs(shape.distance(mesh.points[p]));
      a.of_vertices = std::max(a.of_vertices, distance);
      a.mean += distance;
      ++corners;
    }
    const double distance = distance_of(mesh, t, shape);
    a.of_triangles = std::max(a.of_triangles, distance);
    a.excess = std::max(a.excess, distance - sag_of(mesh, t, shape));
    a.volume += norm(area_normal(mesh, t)) * distance;
  }
  a.mean /= std::max(corners, 1.0);
  return a;
}

}  // namespace taut::test
