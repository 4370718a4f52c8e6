// A cubic room with a round body in its middle that can move.
#pragma once

#include <functional>

#include "motion/room.hpp"

namespace taut::test {

inline const Vec3 middle = {0.5, 0.5, 0.5};
inline constexpr int side = body, caps = 8;  // references of a cylinder

/// The room with a body of another shape: `shape` takes the surface of the cube with corners at -1 and 1 to that of the
/// body around the origin. Not adapted.
inline Mesh shaped_room(Index cells, const std::function<Vec3(const Vec3&)>& shape) {
  constexpr double half = 1.0 / 6;  // a side of the cubic body
  Mesh mesh = restricted(cube(cells), [](const Vec3& x) { return distance_from_middle(x) > half; });
  for (Point& p : mesh.points) {
    const double d = distance_from_middle(p), share = (d - half) / (0.5 - half);
    const Vec3 q = (1 / d) * (p - middle);
    p = middle + (1 - share) * shape(q) + 0.5 * share * q;
  }
  mesh.triangles.clear();
  mesh.triangle_refs.clear();
  add_triangles(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.triangle_refs[t] = distance_from_middle(centre_of(mesh, mesh.triangles[t])) < 0.45 ? body : wall;
  return mesh;
}

inline Mesh room_with_ellipsoid(const Vec3& axes, Index cells = 12) {
  return shaped_room(cells, [&](const Vec3& q) {
    const Vec3 s = (1 / norm(q)) * q;
    return Vec3{axes[0] * s[0], axes[1] * s[1], axes[2] * s[2]};
  });
}

/// Along z.
inline Mesh room_with_cylinder(double radius, double half_height, Index cells = 12) {
  Mesh mesh = shaped_room(cells, [&](const Vec3& q) {
    const double across = std::hypot(q[0], q[1]);
    const double scale = across > 0 ? radius * std::max(std::abs(q[0]), std::abs(q[1])) / across : 0;
    return Vec3{scale * q[0], scale * q[1], half_height * q[2]};
  });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_refs[t] == body &&
        std::abs(std::abs(centre_of(mesh, mesh.triangles[t])[2] - 0.5) - half_height) < 1e-9)
      mesh.triangle_refs[t] = caps;
  return mesh;
}

}  // namespace taut::test
