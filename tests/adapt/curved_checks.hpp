// What must hold for an adaptation of a domain with curved patches.
#pragma once

#include <algorithm>

#include "adapt/checks.hpp"
#include "taut/geometry.hpp"

namespace taut::test {

/// The points of triangles, each once.
inline std::set<Index> surface_points(const Mesh& mesh) {
  std::set<Index> points;
  for (const auto& t : mesh.triangles) points.insert(t.begin(), t.end());
  return points;
}

inline void expect_near_sums(const std::map<int, double>& found, const std::map<int, double>& expected, double share,
                             const char* what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (const auto& [ref, value] : expected) {
    ASSERT_TRUE(found.contains(ref)) << "no " << what << " of reference " << ref << " is left";
    EXPECT_NEAR(found.at(ref), value, share * value) << what << " of reference " << ref;
  }
}

/// Vertices minus edges plus triangles: what no operation may change of a surface.
inline long long euler_characteristic(const Mesh& mesh) {
  std::set<std::array<Index, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  return static_cast<long long>(surface_points(mesh).size()) - static_cast<long long>(edges.size()) +
         static_cast<long long>(mesh.triangles.size());
}

/// Every vertex of a triangle lies on the surface that the input's triangles stand for, and no triangle is folded over.
inline void expect_on_surface_of(const Mesh& out, const Mesh& in) {
  const Geometry geometry(in);
  for (const Index p : surface_points(out))
    ASSERT_LT(geometry.closest(out.points[p]).distance, 1e-9) << "point " << p << " has left the surface";
  EXPECT_EQ(euler_characteristic(out), euler_characteristic(in));
}

/// How many triangles look away from their tetrahedra, all of which the surface encloses.
inline std::size_t inward_triangles(const Mesh& mesh) {
  std::map<std::array<Index, 3>, Vec3> centres;
  for (const auto& t : mesh.tetrahedra)
    for (const auto& [i, j, k] : face_vertices) {
      std::array<Index, 3> face = {t[i], t[j], t[k]};
      std::ranges::sort(face);
      centres[face] = centre_of(mesh, t);
    }
  return static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, [&](std::array<Index, 3> t) {
    const Vec3 outward = area_normal(mesh, t), centre = centre_of(mesh, t);
    std::ranges::sort(t);
    return !centres.contains(t) || dot(outward, centre - centres[t]) <= 0;
  }));
}

/// Volumes and areas may differ by the given shares: by how much flat triangles differ from the curved surface.
inline void expect_near_curved(const AdaptResult& result, const Mesh& in, double share = 0.1) {
  expect_valid(result, in);
  expect_on_surface_of(result.mesh, in);
  expect_near_sums(volumes(result.mesh), volumes(in), share, "region");
  expect_near_sums(areas(result.mesh), areas(in), share, "patch");
}

}  // namespace taut::test
