// Places in a mesh, and the tree over its cells.
#include "locate/places.hpp"

#include <gtest/gtest.h>

#include <random>

#include "locate/cell_tree.hpp"
#include "mesh/build.hpp"
#include "mesh/shapes.hpp"

namespace taut {
namespace {

Vec3 placed(const Background& mesh, const Place& place) {
  const auto x = mesh.corners_of(place.cell);
  return place.weights[0] * x[0] + place.weights[1] * x[1] + place.weights[2] * x[2] + place.weights[3] * x[3];
}

Mesh spiral() {  // an arm that turns round: most straight walks meet its walls
  return test::restricted(test::grid(16), [](const Vec3& c) {
    const bool first_wall = c[0] > 0.25 && c[0] < 0.3125 && c[1] < 0.75;
    const bool second_wall = c[0] > 0.625 && c[0] < 0.6875 && c[1] > 0.25;
    return !first_wall && !second_wall;
  });
}

TEST(Places, AreFoundAroundAnyCorner) {
  const Mesh mesh = spiral();
  const Background background(build(mesh).mesh);
  std::vector<Vec3> points;
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> weight(0, 1);
  for (std::size_t i = 0; i < 3000; ++i) {
    const auto& t = mesh.tetrahedra[generator() % mesh.tetrahedra.size()];
    std::array<double, 4> w = {weight(generator), weight(generator), weight(generator), weight(generator)};
    const double sum = w[0] + w[1] + w[2] + w[3];
    Vec3 x{};
    for (std::size_t k = 0; k < 4; ++k) x = x + w[k] / sum * mesh.points[t[k]];
    points.push_back(x);
  }
  const auto places = places_of(background, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(places[i].distance, 0);
    EXPECT_LT(norm(placed(background, places[i]) - points[i]), 1e-15);
    for (const double w : places[i].weights) EXPECT_GE(w, -1e-12);
  }
}

TEST(Places, OutsideAreTheNearestOnTheBoundary) {
  const Background background(build(test::cube(3)).mesh);
  const std::vector<Vec3> points = {{0.4, 0.3, 1.5}, {-1, 0.5, 0.25}, {2, 2, 2}, {0.1, -0.25, -0.25}, {0.5, 0.5, 0.5}};
  const std::vector<Vec3> nearest = {{0.4, 0.3, 1}, {0, 0.5, 0.25}, {1, 1, 1}, {0.1, 0, 0}, {0.5, 0.5, 0.5}};
  const auto places = places_of(background, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(norm(placed(background, places[i]) - nearest[i]), 1e-15);
    EXPECT_NEAR(places[i].distance, norm(points[i] - nearest[i]), 1e-15);
  }
}

TEST(CellTree, FindsEveryCellNearABox) {
  const Background background(build(test::cube(5)).mesh);
  const CellTree tree(background);
  const Box wanted{{0.1, 0.2, 0.3}, {0.25, 0.4, 0.35}};
  std::vector<std::uint8_t> visited(background.cell_count(), 0);
  std::uint32_t last = 0;
  tree.for_each_near(wanted, [&](CellId cell) {
    EXPECT_TRUE(cell >= last);
    last = cell;
    visited[cell] = 1;
  });
  std::size_t visits = 0;
  for (std::size_t c = 0; c < visited.size(); ++c) {
    Box box;
    for (const Vec3& x : background.corners_of(static_cast<CellId>(c))) box.include(x);
    EXPECT_TRUE(visited[c] == 1 || !box.meets(wanted));
    visits += visited[c];
  }
  EXPECT_LT(visits, background.cell_count() / 2);
}

}  // namespace
}  // namespace taut
