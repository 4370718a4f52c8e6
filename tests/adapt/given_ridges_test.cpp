// Edges that a user marks as ridges stay, whatever the angle there.
#include <algorithm>

#include "adapt/checks.hpp"
#include "taut/ridges.hpp"

namespace taut {
namespace {

/// Edges of triangles between points for which `on_line` holds.
std::vector<std::array<Index, 2>> edges_on(const Mesh& mesh, const std::function<bool(const Point&)>& on_line) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3] && on_line(mesh.points[t[k]]) && on_line(mesh.points[t[(k + 1) % 3]]))
        edges.push_back({t[k], t[(k + 1) % 3]});
  return edges;
}

double length_of_ridges(const Mesh& mesh, const std::function<bool(const Point&)>& on_line) {
  double sum = 0;
  for (const Index e : mesh.ridges) {
    const auto [a, b] = mesh.edges[e];
    if (on_line(mesh.points[a]) && on_line(mesh.points[b])) sum += norm(mesh.points[a] - mesh.points[b]);
  }
  return sum;
}

TEST(GivenRidges, StayOnAPlane) {
  const Mesh mesh = test::cube(6);
  const auto on_line = [](const Point& p) { return std::abs(p[0] - 0.5) < 1e-12 && p[2] == 1; };
  for (const double size : {0.08, 0.4}) {
    const Sizes sizes(mesh.points.size(), size);
    EXPECT_EQ(length_of_ridges(adapt(mesh, sizes).mesh, on_line), 0);
    const Mesh found = adapt(with_ridges(mesh, edges_on(mesh, on_line)), sizes).mesh;
    EXPECT_NEAR(length_of_ridges(found, on_line), 1, 1e-12) << size;
  }
}

// On a curved surface, unlike a given edge that is not marked.
TEST(GivenRidges, StayOnASphere) {
  Mesh mesh = test::ball(test::cube(8));
  const auto on_equator = [](const Point& p) { return std::abs(p[2]) < 1e-9; };
  for (const double size : {0.15, 0.5}) {
    const Sizes sizes(mesh.points.size(), size);
    const Mesh found = adapt(with_ridges(mesh, edges_on(mesh, on_equator)), sizes).mesh;
    EXPECT_NEAR(length_of_ridges(found, on_equator), 2 * 3.14159265358979, size * size) << size;
  }
  mesh.edges = edges_on(mesh, on_equator);
  EXPECT_EQ(length_of_ridges(adapt(mesh, Sizes(mesh.points.size(), 0.5)).mesh, on_equator), 0);
}

}  // namespace
}  // namespace taut
