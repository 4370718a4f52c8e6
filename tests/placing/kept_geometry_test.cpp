// Placing vertices on a level set keeps those of the boundary on a given geometry.
#include <gtest/gtest.h>

#include "mesh/shapes.hpp"
#include "taut/placing.hpp"

namespace taut::test {
namespace {

Placed placed_on_a_plane(const Mesh& mesh, const PlaceOptions& options) {
  const auto height = [](const Point& p) { return p[2] - 0.1; };
  return place_on_level_set(mesh, Sizes(mesh.points.size(), 0.4), height, options);
}

TEST(PlacingOnAGeometry, TheBoundaryStaysOnIt) {
  const Geometry geometry(ball(cube(8)));
  const Mesh start = ball(cube(5));
  const Mesh mesh = adapt(start, Sizes(start.points.size(), 0.4), {.geometry = geometry}).mesh;
  const Placed placed = placed_on_a_plane(mesh, {.geometry = geometry});
  EXPECT_GT(placed.moved + placed.inserted, 0);
  EXPECT_EQ(placed.adapted.report.off_surface, 0);
  for (const auto& triangle : placed.adapted.mesh.triangles)
    for (const Index v : triangle) EXPECT_LT(geometry.closest(placed.adapted.mesh.points[v]).distance, 1e-9);
}

TEST(PlacingOnAGeometry, VerticesOffItAreCounted) {
  EXPECT_GT(placed_on_a_plane(ball(cube(5)), {.geometry = Geometry(ball(cube(8)))}).adapted.report.off_surface, 0);
}

TEST(PlacingOnAGeometry, NeedsASurfaceThatIsAdapted) {
  const Mesh mesh = ball(cube(4));
  EXPECT_THROW((void)placed_on_a_plane(mesh, {.surface = Surface::fixed, .geometry = Geometry(mesh)}), InputError);
}

}  // namespace
}  // namespace taut::test
