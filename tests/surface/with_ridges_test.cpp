// Edges marked as ridges, by number and by place.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/with_threads.hpp"
#include "mesh/shapes.hpp"
#include "taut/ridges.hpp"

namespace taut {
namespace {

using Edge = std::array<Index, 2>;
using test::refusal;

constexpr Index n = 4;  // boxes along a side

Index point(Index i, Index j, Index k) {
  return (i * (n + 1) + j) * (n + 1) + k;
}

/// Across the top of the cube, at x = 1/2.
std::vector<Edge> line_on_top() {
  std::vector<Edge> line;
  for (Index j = 0; j < n; ++j) line.push_back({point(n / 2, j, n), point(n / 2, j + 1, n)});
  return line;
}

/// The ridges, each with the smaller number first.
std::set<Edge> marked(const Mesh& mesh) {
  std::set<Edge> edges;
  for (const Index e : mesh.ridges) {
    const auto [a, b] = mesh.edges[e];
    edges.insert({std::min(a, b), std::max(a, b)});
  }
  return edges;
}

/// The line as a mesh of its own, with points in another order.
Mesh as_lines(const Mesh& mesh, const std::vector<Edge>& edges, double shift) {
  Mesh lines;
  for (auto e = edges.rbegin(); e != edges.rend(); ++e) {
    const auto first = static_cast<Index>(lines.points.size());
    lines.edges.push_back({first + 1, first});
    for (const Index p : *e) lines.points.push_back(mesh.points[p] + Vec3{shift, -shift, shift});
  }
  return lines;
}

TEST(WithRidges, AddsAndMarksEachEdgeOnce) {
  Mesh mesh = test::cube(n);
  const std::vector<Edge> line = line_on_top();
  mesh.edges = {line[2], {line[1][1], line[1][0]}, {point(0, 0, 0), point(1, 0, 0)}};
  mesh.edge_refs = {7, 8, 9};
  mesh.ridges = {1};
  std::vector<Edge> twice = line;
  twice.push_back({line[0][1], line[0][0]});
  const Mesh found = with_ridges(mesh, twice);
  EXPECT_EQ(found.edges.size(), 3U + 2U);
  EXPECT_EQ(found.edge_refs, (std::vector<int>{7, 8, 9, 0, 0}));
  EXPECT_EQ(found.ridges.size(), 4U);
  EXPECT_EQ(marked(found), (std::set<Edge>{line.begin(), line.end()}));
  EXPECT_EQ(with_ridges(found, line).ridges, found.ridges);
  mesh.edge_refs.clear();
  EXPECT_TRUE(with_ridges(mesh, line).edge_refs.empty());
}

TEST(WithRidges, TakesEdgesOfTrianglesThatAreMissing) {
  const Mesh mesh = test::grid(n);
  const std::vector<Edge> line = line_on_top();
  EXPECT_EQ(with_ridges(mesh, line).ridges.size(), n);
  Mesh parted = mesh;
  for (const auto& t : mesh.tetrahedra) parted.tetrahedron_refs.push_back(test::centre_of(mesh, t)[0] < 0.5 ? 1 : 2);
  const std::vector<Edge> inside = {{point(2, 1, 1), point(2, 1, 2)}};  // of the interface
  EXPECT_EQ(with_ridges(parted, inside).ridges.size(), 1U);
  EXPECT_EQ(refusal(1, [&] { return with_ridges(mesh, inside); }),
            "ridges: edge 1 (57 58) is no edge of a triangle of the boundary or between regions");
}

TEST(WithRidges, FindsEdgesByTheirPlaces) {
  const Mesh mesh = test::cube(n);
  const std::vector<Edge> line = line_on_top();
  Mesh lines = as_lines(mesh, line, 5e-7);
  EXPECT_EQ(marked(with_ridges(mesh, lines)), (std::set<Edge>{line.begin(), line.end()}));
  lines.ridges = {1};
  EXPECT_EQ(marked(with_ridges(mesh, lines)), (std::set<Edge>{line[n - 2]}));
}

TEST(WithRidges, ScalesTheToleranceWithTheMesh) {
  Mesh mesh = test::cube(n);
  for (Point& p : mesh.points) p = 1e-6 * p;
  EXPECT_EQ(with_ridges(mesh, as_lines(mesh, line_on_top(), 5e-13)).ridges.size(), n);
  const std::string message = refusal(1, [&] { return with_ridges(mesh, as_lines(mesh, line_on_top(), 5e-12)); });
  EXPECT_TRUE(message.starts_with("ridges: vertex 2 ")) << message;
}

TEST(WithRidges, MarksBothSidesOfASlit) {
  Index pin = 0;
  const Mesh mesh = test::slit(pin);
  Mesh lines;
  lines.points = {{0.25, 0.25, 0.5}, {0.25, 0.5, 0.5}};
  lines.edges = {{0, 1}};
  const Mesh found = with_ridges(mesh, lines);
  ASSERT_EQ(found.ridges.size(), 2U);
  const Edge a = found.edges[0], b = found.edges[1];
  for (int k = 0; k < 2; ++k) {
    EXPECT_NE(a[k], b[k]);
    EXPECT_EQ(mesh.points[a[k]], mesh.points[b[k]]);
  }
}

TEST(WithRidges, NamesWhatDoesNotMatch) {
  const Mesh mesh = test::cube(n);
  Mesh lines;
  lines.points = {{0, 0, 1}, {0, 1, 1}, {0.1, 0, 1}, {0.5, 0.5, 0.5}};
  lines.edges = {{0, 1}};
  EXPECT_EQ(refusal(1, [&] { return with_ridges(mesh, lines); }),
            "ridges: edge 1 (1 2) from (0 0 1) to (0 1 1) is no edge of a triangle of the boundary or between regions "
            "of the mesh");
  lines.edges = {{0, 2}};
  EXPECT_EQ(refusal(1, [&] { return with_ridges(mesh, lines); }),
            "ridges: vertex 3 (0.1 0 1): no vertex of a triangle of the mesh lies within 1.73e-06 of it");
  lines.edges = {{0, 3}};
  EXPECT_TRUE(refusal(1, [&] { return with_ridges(mesh, lines); }).starts_with("ridges: vertex 4 (0.5 0.5 0.5): no"));
  lines.edges = {{0, 4}};
  EXPECT_EQ(refusal(1, [&] { return with_ridges(mesh, lines); }), "ridges: edge 1: vertex 5 found, expected 1..4");
  EXPECT_EQ(refusal(1,
                    [&] {
                      return with_ridges(mesh, std::vector<Edge>{{0, 1}, {0, 999}});
                    }),
            "ridges: edge 2: vertex 1000 found, expected 1..125");
}

}  // namespace
}  // namespace taut
