// Ridges with one patch on both sides: cuts into a patch, creases that fade, loops that part nothing.
#include <functional>
#include <numbers>

#include "adapt/curved_checks.hpp"
#include "adapt/rounds.hpp"
#include "adapt/setup.hpp"
#include "sizing/curved_meshes.hpp"
#include "surface/surface_edges.hpp"

namespace taut {
namespace {

constexpr int marked = 5;  // reference of the ridges

using Where = std::function<bool(const Point&)>;

bool holds(const std::vector<Where>& parts, const Point& p) {
  return std::ranges::any_of(parts, [&](const Where& part) { return part(p); });
}

/// With the edges of triangles within one of the smooth parts of a path as ridges.
Mesh with_ridges_on(Mesh mesh, const std::vector<Where>& parts) {
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array edge{t[k], t[(k + 1) % 3]};
      const auto has_edge = [&](const Where& part) { return part(mesh.points[edge[0]]) && part(mesh.points[edge[1]]); };
      if (edge[0] > edge[1] || std::ranges::none_of(parts, has_edge)) continue;
      mesh.ridges.push_back(static_cast<Index>(mesh.edges.size()));
      mesh.edges.push_back(edge);
      mesh.edge_refs.push_back(marked);
    }
  return mesh;
}

std::size_t count_marked(const Mesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count(mesh.edge_refs, marked));
}

std::vector<Point> marked_points(const Mesh& mesh) {
  std::vector<Point> points;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.edge_refs[e] == marked)
      for (const Index v : mesh.edges[e]) points.push_back(mesh.points[v]);
  return points;
}

/// Triangles at an edge must agree on its line, and two of them must be there.
void expect_lines_agree(const Mesh& mesh, double size) {
  Report report;
  Session session = set_up(mesh, Sizes(mesh.points.size(), size), {}, report);
  run_rounds(session, {.block_size = 200}, {}, report);
  const TetMesh& m = session.mesh;
  for_each_edge(edge_uses(corners_of(m.triangles)), [&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses)
      ASSERT_EQ(m.triangles[use.triangle].line[use.corner], m.triangles[uses[0].triangle].line[uses[0].corner]);
  });
}

struct Path {
  const char* name;
  std::vector<Where> parts;
  double length;
  std::vector<Point> corners;
};

/// Along x or y on the top of the unit cube.
Where segment(const Point& a, const Point& b) {
  return [a, b](const Point& p) {
    const bool between = norm(p - a) + norm(b - p) < norm(b - a) + 1e-12;
    return between && p[2] == 1;
  };
}

/// On the top of a unit cube of 8^3 boxes.
std::vector<Path> paths_on_top() {
  const Point a = {0.25, 0.25, 1}, b = {0.75, 0.25, 1}, c = {0.75, 0.75, 1}, d = {0.25, 0.75, 1};
  const Point west = {0.125, 0.5, 1}, middle = {0.5, 0.5, 1}, east = {0.875, 0.5, 1}, north = {0.5, 0.875, 1};
  const Point rim = {0, 0.5, 1};
  return {{"inside", {segment(west, east)}, 0.75, {west, east}},
          {"from the rim", {segment(rim, middle)}, 0.5, {rim, middle}},
          {"bent", {segment(a, b), segment(b, c)}, 1, {a, b, c}},
          {"forked", {segment(west, east), segment(middle, north)}, 1.125, {west, middle, east, north}},
          {"closed", {segment(a, b), segment(b, c), segment(c, d), segment(d, a)}, 2, {a, b, c, d}}};
}

TEST(InnerRidges, AreRemeshedOnAPlane) {
  for (const Path& path : paths_on_top()) {
    SCOPED_TRACE(path.name);
    const Mesh mesh = with_ridges_on(test::cube(8), path.parts);
    for (const double size : {0.06, 0.6}) {
      const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), size));
      test::expect_faithful(result, mesh);
      EXPECT_EQ(result.report.triangles_frozen, 0);
      EXPECT_NEAR(test::lengths(result.mesh).at(marked), path.length, 1e-12);
      const std::vector<Point> points = marked_points(result.mesh);
      for (const Point& p : points) EXPECT_TRUE(holds(path.parts, p)) << p[0] << " " << p[1] << " " << p[2];
      for (const Point& corner : path.corners) EXPECT_NE(std::ranges::find(points, corner), points.end());
      if (size < 0.1)
        EXPECT_GT(count_marked(result.mesh), count_marked(mesh) * 3 / 2);
      else
        EXPECT_LE(count_marked(result.mesh), count_marked(mesh) / 2);
      expect_lines_agree(mesh, size);
    }
  }
}

TEST(InnerRidges, NeedNotBeMarkedOnAPlane) {
  const Path bent = paths_on_top()[2];
  Mesh mesh = with_ridges_on(test::cube(8), bent.parts);
  mesh.ridges.clear();
  for (const double size : {0.08, 0.6}) {
    const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), size));
    test::expect_faithful(result, mesh);
    EXPECT_NEAR(test::lengths(result.mesh).at(marked), bent.length, 1e-12);
    EXPECT_EQ(count_marked(result.mesh) > count_marked(mesh), size < 0.1);
  }
}

/// As many edges are unit as without the ridge, or nearly.
TEST(InnerRidges, DoNotSpoilTheMeshAround) {
  const Mesh mesh = test::cube(8);
  const Metric sizes = Sizes(mesh.points.size(), 0.06);
  const Quality without = adapt(mesh, sizes).report.quality;
  const Quality with = adapt(with_ridges_on(mesh, paths_on_top()[0].parts), sizes).report.quality;
  EXPECT_GT(with.unit_edges, without.unit_edges - 0.01);
  EXPECT_LT(with.Q_max, 1.5 * without.Q_max);
}

TEST(InnerRidges, AreRemeshedOnASphere) {
  const auto on_half_equator = [](const Point& p) { return std::abs(p[2]) < 1e-9 && p[1] > -1e-9; };
  const Mesh mesh = with_ridges_on(test::ball(test::cube(8)), {on_half_equator});
  ASSERT_EQ(count_marked(mesh), 16);
  for (const double size : {0.1, 0.7}) {
    const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), size));
    test::expect_near_curved(result, mesh, size < 0.5 ? 0.05 : 0.25);
    EXPECT_EQ(result.report.triangles_frozen, 0);
    EXPECT_NEAR(test::lengths(result.mesh).at(marked), std::numbers::pi, size < 0.5 ? 0.01 : 0.2);
    const std::vector<Point> points = marked_points(result.mesh);
    for (const Point& p : points) {
      EXPECT_TRUE(on_half_equator(p)) << p[0] << " " << p[1] << " " << p[2];
      EXPECT_NEAR(norm(p), 1, 1e-4);
    }
    for (const Point& end : {Point{1, 0, 0}, Point{-1, 0, 0}})
      EXPECT_TRUE(std::ranges::any_of(points, [&](const Point& p) { return norm(p - end) < 1e-15; }));
    if (size < 0.5)
      EXPECT_GT(count_marked(result.mesh), 24);
    else
      EXPECT_LT(count_marked(result.mesh), 10);
    expect_lines_agree(mesh, size);
  }
}

constexpr double tube = 0.4;

/// A solid torus around the unit circle, from a square ring of 6^2 boxes.
Mesh torus() {
  const auto from_axis = [](const Point& p) { return std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)); };
  const double third = 1.0 / 3;
  Mesh mesh = test::restricted(
      test::grid(18), [&](const Vec3& x) { return from_axis(x) > third / 2 && x[2] > third && x[2] < 2 * third; });
  for (Point& p : mesh.points) {
    const double s = 6 * from_axis(p) - 2, t = 6 * p[2] - 3, angle = std::atan2(p[1] - 0.5, p[0] - 0.5);
    const double r = 1 + tube * s * std::sqrt(1 - t * t / 2);
    p = {r * std::cos(angle), r * std::sin(angle), tube * t * std::sqrt(1 - s * s / 2)};
  }
  test::add_triangles(mesh);
  mesh.triangle_refs.assign(mesh.triangles.size(), 1);
  return mesh;
}

/// A loop around the tube leaves the torus in one piece, and so does one around the axis that crosses it.
TEST(InnerRidges, MayBeLoopsThatPartNothing) {
  const auto around_tube = [](const Point& p) {
    return std::abs(p[1]) < 1e-9 && p[0] > 0 && std::abs(test::from_unit_circle(p) - tube) < 1e-3;
  };
  const auto around_axis = [](const Point& p) {
    return std::abs(p[2]) < 1e-9 && std::abs(std::hypot(p[0], p[1]) - 1 - tube) < 1e-3;
  };
  const double short_way = 2 * std::numbers::pi * tube, long_way = 2 * std::numbers::pi * (1 + tube);
  for (const auto& [loops, length] : {std::pair<std::vector<Where>, double>{{around_tube}, short_way},
                                      {{around_tube, around_axis}, short_way + long_way}}) {
    const Mesh mesh = with_ridges_on(torus(), loops);
    for (const double size : {0.07, 1.0}) {
      const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), size));
      test::expect_near_curved(result, mesh, size < 0.5 ? 0.03 : 0.3);
      EXPECT_EQ(result.report.triangles_frozen, 0);
      EXPECT_NEAR(test::lengths(result.mesh).at(marked), length, (size < 0.5 ? 0.01 : 0.15) * length);
      for (const Point& p : marked_points(result.mesh))
        EXPECT_TRUE(holds(loops, p)) << p[0] << " " << p[1] << " " << p[2];
      if (size < 0.5)
        EXPECT_GT(count_marked(result.mesh), count_marked(mesh) * 9 / 8);
      else
        EXPECT_LT(count_marked(result.mesh), count_marked(mesh) / 2);
    }
    expect_lines_agree(mesh, 1);
  }
}

/// The top falls on both sides of a ridge along x that becomes flatter, until there is none any more.
TEST(InnerRidges, AreFoundWhereACreaseFades) {
  Mesh mesh = test::cube(12);
  for (Point& p : mesh.points) p[2] *= 1 - std::abs(p[1] - 0.5) * std::max(0.0, 0.8 - p[0]);
  mesh.triangle_refs.assign(mesh.triangles.size(), 1);
  const auto crease = [](const Point& p) { return std::abs(p[1] - 0.5) < 1e-9 && std::abs(p[2] - 1) < 1e-9; };
  std::vector<double> found;
  for (const double size : {0.05, 0.3}) {
    const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), size));
    test::expect_near_curved(result, mesh);
    EXPECT_EQ(result.report.triangles_frozen, 0);
    double length = 0;
    for (const Index e : result.mesh.ridges) {
      const auto [a, b] = result.mesh.edges[e];
      if (crease(result.mesh.points[a]) && crease(result.mesh.points[b]))
        length += norm(result.mesh.points[a] - result.mesh.points[b]);
    }
    found.push_back(length);
  }
  EXPECT_GT(found[0], 0.3);
  EXPECT_LT(found[0], 0.9);
  EXPECT_NEAR(found[1], found[0], 1e-9);
}

TEST(InnerRidges, GiveTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = with_ridges_on(test::cube(8), paths_on_top()[3].parts);
  const auto hash_on = [&](int threads) {
    AdaptOptions options;
    options.threads = threads;
    options.block_size = 200;
    return adapt(mesh, Sizes(mesh.points.size(), 0.08), options).report.hash;
  };
  const auto hash = hash_on(1);
  EXPECT_EQ(hash_on(2), hash);
  EXPECT_EQ(hash_on(3), hash);
}

}  // namespace
}  // namespace taut
