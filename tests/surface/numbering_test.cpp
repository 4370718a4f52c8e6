#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "sizing/curved_meshes.hpp"
#include "surface/reference_surface.hpp"
#include "surface/surfaces.hpp"

namespace taut {
namespace {

struct Renumbered {
  Mesh mesh;
  std::vector<Index> new_of_old;
};

/// A surface with its vertices, its triangles and their corners in another order.
Renumbered renumbered(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  Renumbered result{{}, std::vector<Index>(mesh.points.size())};
  for (Index p = 0; p < mesh.points.size(); ++p) result.new_of_old[p] = p;
  std::shuffle(result.new_of_old.begin(), result.new_of_old.end(), random);
  result.mesh.points.resize(mesh.points.size());
  for (Index p = 0; p < mesh.points.size(); ++p) result.mesh.points[result.new_of_old[p]] = mesh.points[p];
  for (auto t : mesh.triangles) {
    for (Index& v : t) v = result.new_of_old[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    result.mesh.triangles.push_back(t);
  }
  std::shuffle(result.mesh.triangles.begin(), result.mesh.triangles.end(), random);
  return result;
}

using Edges = std::set<std::array<Index, 2>>;

/// The ridges, in other numbers.
Edges ridges_of(const ReferenceSurface& surface, const std::vector<Index>& new_of_old) {
  Edges edges;
  for (const ReferenceCurve& curve : surface.curves())
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) {
      const auto [a, b] = std::minmax({new_of_old[curve.vertices[i]], new_of_old[curve.vertices[i + 1]]});
      edges.insert({a, b});
    }
  return edges;
}

Mesh surface_alone(Mesh mesh) {
  if (mesh.triangles.empty())
    for (const Corners& t : surface_of(mesh).facets.triangles) mesh.triangles.push_back({t[0], t[1], t[2]});
  mesh.tetrahedra.clear();
  mesh.triangle_refs.clear();
  return mesh;
}

Mesh ellipsoid() {
  Mesh mesh = surface_alone(test::sphere(8, 5));
  for (Point& p : mesh.points) p = {p[0], 0.6 * p[1], 0.3 * p[2]};
  return mesh;
}

/// Choices between alternatives that are about as good must not differ either.
TEST(Numbering, DoesNotMatterToTheSurface) {
  for (const Mesh& mesh :
       {ellipsoid(), surface_alone(test::sphere(2, 7)), surface_alone(test::sphere(3, 7)), test::tube(30, 12),
        test::lens(8, 25), test::lens(16, 20), test::cone(12, 1.5), surface_alone(test::cylinder(5, 1, 2)),
        surface_alone(test::torus(16, 1, 0.4)), surface_alone(test::torus(24, 1, 0.4))}) {
    const ReferenceSurface plain(surface_of(mesh), {});
    std::vector<Index> same(mesh.points.size());
    for (Index p = 0; p < same.size(); ++p) same[p] = p;
    for (const unsigned seed : {1U, 2U, 3U}) {
      const auto [other_mesh, new_of_old] = renumbered(mesh, seed);
      const ReferenceSurface other(surface_of(other_mesh), {});
      EXPECT_EQ(ridges_of(plain, new_of_old), ridges_of(other, std::vector<Index>(same)));
      EXPECT_EQ(plain.patches().size(), other.patches().size());
      EXPECT_EQ(plain.corners().size(), other.corners().size());
      for (const auto& t : mesh.triangles) {
        const Vec3 x = (1.0 / 3) * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]);
        EXPECT_NEAR(plain.closest(x).distance, other.closest(x).distance, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace taut
