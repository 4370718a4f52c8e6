#include <gtest/gtest.h>

#include <set>

#include "geometry/features.hpp"
#include "mesh/shapes.hpp"
#include "surface/sectors.hpp"

namespace taut {
namespace {

struct Split {
  Built built;
  Sectors sectors;
};

Split split(const Mesh& mesh) {
  Built built = build(mesh);
  const auto triangles = corners_of(built.mesh.triangles);
  const auto uses = edge_uses(triangles);
  const std::vector<std::uint8_t> required(built.mesh.triangles.size(), 0);
  std::vector<Feature> features = find_features(mesh, built, uses, required, {.angle = 45}).surface;
  std::erase_if(features, [](const Feature& f) { return !f.sharp; });
  std::vector<EdgePair> smooth;
  for_each_smooth_edge(uses, features, [&](const EdgeUse& s, const EdgeUse& t) { smooth.push_back({s, t}); });
  Sectors sectors = find_sectors(triangles, smooth);
  return {std::move(built), std::move(sectors)};
}

TEST(Sectors, AreOneForEachSideOfACubeAtAVertex) {
  constexpr Index n = 4;
  const auto [built, sectors] = split(test::cube(n));
  EXPECT_EQ(sectors.vertices.size(), 6U * (n + 1) * (n + 1));
  std::set<std::pair<VertexId, int>> sides;
  for (const TriangleId t : built.mesh.triangle_ids())
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(sectors.vertices[sectors.of_triangle[t][k]], built.mesh.triangles[t].v[k]);
      sides.insert({built.mesh.triangles[t].v[k], built.triangle_refs[t]});
    }
  EXPECT_EQ(sides.size(), sectors.vertices.size());
}

TEST(Sectors, AreOneAtAVertexOfASmoothSurface) {
  const auto [built, sectors] = split(test::ball(test::cube(8)));
  EXPECT_EQ(sectors.vertices.size(), 6U * 8 * 8 + 2);
}

/// A ridge that ends in a smooth surface does not part what one can reach around its end.
TEST(Sectors, GoAroundTheEndOfARidge) {
  Mesh mesh = test::ball(test::cube(8));
  const auto plain = split(mesh).sectors.vertices.size();
  const auto& t = mesh.triangles[0];
  mesh.edges = {{t[0], t[1]}, {t[1], t[2]}};
  mesh.ridges = {0, 1};
  EXPECT_EQ(split(mesh).sectors.vertices.size(), plain + 1);
}

}  // namespace
}  // namespace taut
