// A geometry that is kept from one adaptation to the next, or comes from another mesh.
#include <algorithm>
#include <numbers>
#include <utility>

#include "adapt/checks.hpp"
#include "adapt/fields.hpp"
#include "surface/surfaces.hpp"
#include "taut/geometry.hpp"
#include "taut/quality.hpp"

namespace taut::test {
namespace {

constexpr double rounding = 1e-9;

Mesh round_ball(Index n) {
  return ball(cube(n));
}

/// Of radius 1 around the z axis, from z = 0 to 1; the side has the reference 1, the caps have 5 and 6.
Mesh solid_cylinder(Index n) {
  Mesh mesh = cube(n);
  for (auto& [x, y, z] : mesh.points) {
    const double u = 2 * x - 1, v = 2 * y - 1;
    x = u * std::sqrt(1 - v * v / 2);
    y = v * std::sqrt(1 - u * u / 2);
  }
  for (int& ref : mesh.triangle_refs) ref = ref < 5 ? 1 : ref;
  return mesh;
}

/// The part of the cylinder at x, y > 0 of solid_cylinder: with corners.
Mesh wedge(Index n) {
  Mesh mesh = cube(n);
  for (auto& [x, y, z] : mesh.points) {
    const double a = 0.5 * y * std::numbers::pi;
    const double r = 1 + x;
    x = r * std::cos(a);
    y = r * std::sin(a);
  }
  return mesh;
}

AdaptResult adapted(const Mesh& mesh, double size, const Geometry& geometry) {
  const double m = 1 / (size * size);
  return adapt(mesh, [m](const Point&) { return Tensor{m, 0, 0, m, 0, m}; }, {.geometry = geometry});
}

std::vector<Point> surface_points(const Mesh& mesh) {
  std::vector<std::uint8_t> seen(mesh.points.size(), 0);
  std::vector<Point> points;
  for (const auto& triangle : mesh.triangles)
    for (const Index v : triangle)
      if (std::exchange(seen[v], 1) == 0) points.push_back(mesh.points[v]);
  return points;
}

struct Errors {
  double largest = 0, mean = 0;
};

Errors radial_errors(const std::vector<Point>& points) {
  Errors errors;
  for (const Point& p : points) {
    const double error = std::abs(norm(p) - 1);
    errors.largest = std::max(errors.largest, error);
    errors.mean += error / static_cast<double>(points.size());
  }
  return errors;
}

/// Of a geometry that stands for the unit sphere, itself.
Errors radial_errors(const Geometry& geometry) {
  std::vector<Point> points;
  for (const Point& p : surface_points(round_ball(30))) points.push_back(geometry.closest(p).point);
  return radial_errors(points);
}

double farthest_from(const Geometry& geometry, const Mesh& mesh) {
  double farthest = 0;
  for (const Point& p : surface_points(mesh)) farthest = std::max(farthest, geometry.closest(p).distance);
  return farthest;
}

/// Lengths of the edges that are marked as ridges.
double ridge_length(const Mesh& mesh) {
  double sum = 0;
  for (const Index e : mesh.ridges) sum += norm(mesh.points[mesh.edges[e][0]] - mesh.points[mesh.edges[e][1]]);
  return sum;
}

/// What adaptation to `geometry` refuses about `mesh`.
std::string refusal(const Mesh& mesh, const Geometry& geometry) {
  try {
    (void)adapted(mesh, 0.5, geometry);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(KeptGeometry, ASphereStaysWhereItIs) {
  Mesh mesh = round_ball(6);
  const Geometry geometry(mesh);
  double first_mean = 0, first_volume = 0;
  for (int cycle = 1; cycle <= 10; ++cycle) {
    for (const double size : {0.4, 0.2}) {
      mesh = adapted(mesh, size, geometry).mesh;
      EXPECT_LT(farthest_from(geometry, mesh), rounding) << "cycle " << cycle;
    }
    if (cycle > 1) continue;
    first_mean = radial_errors(surface_points(mesh)).mean;
    first_volume = volume_of(mesh);
  }
  // Where the vertices happen to be on the surface decides about the largest error: it is compared with the surface's.
  const Errors last = radial_errors(surface_points(mesh));
  EXPECT_LT(last.largest, 1.01 * radial_errors(geometry).largest);
  EXPECT_NEAR(last.mean, first_mean, 0.05 * first_mean);
  EXPECT_NEAR(volume_of(mesh), first_volume, 0.005 * first_volume);
}

TEST(KeptGeometry, RimsOfACylinderStay) {
  Mesh mesh = solid_cylinder(6);
  const Geometry geometry(mesh);
  ASSERT_EQ(geometry.ridges(), 2);
  for (int cycle = 0; cycle < 4; ++cycle) {
    for (const double size : {0.2, 0.45}) {
      const AdaptResult result = adapted(mesh, size, geometry);
      mesh = result.mesh;
      EXPECT_EQ(result.report.off_surface, 0);
      EXPECT_LT(farthest_from(geometry, mesh), rounding) << "cycle " << cycle;
      EXPECT_NEAR(ridge_length(mesh), 4 * std::numbers::pi, 0.01 * size / 0.2 * 4 * std::numbers::pi);
      for (const Index e : mesh.ridges)
        for (const Index v : mesh.edges[e]) {
          const auto& [x, y, z] = mesh.points[v];
          EXPECT_TRUE(z == 0 || z == 1) << z;
          EXPECT_NEAR(std::hypot(x, y), 1, 1e-4);
        }
    }
  }
}

TEST(KeptGeometry, CornersStay) {
  const Mesh input = wedge(4);
  const Geometry geometry(input);
  ASSERT_EQ(geometry.corners(), 8);
  Mesh mesh = input;
  for (const double size : {0.15, 0.4, 0.15, 0.4}) mesh = adapted(mesh, size, geometry).mesh;
  for (const Point corner : {Point{1, 0, 0}, Point{2, 0, 0}, Point{1, 0, 1}, Point{2, 0, 1}})
    EXPECT_NE(std::ranges::find(mesh.points, corner), mesh.points.end());
  EXPECT_LT(farthest_from(geometry, mesh), rounding);
}

TEST(KeptGeometry, ACoarseMeshGoesToTheFineSurface) {
  const Geometry fine(round_ball(12));
  const AdaptResult result = adapted(round_ball(4), 0.25, fine);
  EXPECT_EQ(result.report.off_surface, 0);
  EXPECT_LT(farthest_from(fine, result.mesh), rounding);
  const Geometry coarse(round_ball(4));
  EXPECT_LT(radial_errors(surface_points(result.mesh)).largest, 0.2 * radial_errors(coarse).largest);
}

TEST(KeptGeometry, VerticesOffTheSurfaceAreMovedWithoutARound) {
  Mesh mesh = round_ball(5);
  for (Point& p : mesh.points) p = 1.02 * p;
  const Geometry geometry(round_ball(8));
  const AdaptResult result = adapt(mesh, Sizes(mesh.points.size(), 0.4), {.geometry = geometry, .max_rounds = 0});
  EXPECT_EQ(result.report.off_surface, 0);
  EXPECT_LT(farthest_from(geometry, result.mesh), rounding);
  EXPECT_TRUE(defects(result.mesh).empty());
}

TEST(KeptGeometry, RequiredPointsStayAndAreCounted) {
  Mesh mesh = round_ball(5);
  for (Point& p : mesh.points) p = 1.02 * p;
  mesh.required_points = {mesh.triangles[0][0]};
  const Point place = mesh.points[mesh.triangles[0][0]];
  const AdaptResult result = adapted(mesh, 0.4, Geometry(round_ball(8)));
  EXPECT_EQ(result.report.off_surface, 1);
  EXPECT_NE(std::ranges::find(result.mesh.points, place), result.mesh.points.end());
}

TEST(KeptGeometry, ItMayBeOnlyPartOfTheBoundary) {
  const Mesh input = solid_cylinder(6);
  Mesh side;
  side.points = input.points;
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
    if (input.triangle_refs[t] == 1) side.triangles.push_back(input.triangles[t]);
  side.triangle_refs.assign(side.triangles.size(), 1);
  const AdaptResult result = adapted(input, 0.2, Geometry(side));
  EXPECT_LT(result.mesh.triangles.size(), 4 * input.triangles.size());
  EXPECT_EQ(result.report.off_surface, 0);
  EXPECT_LT(farthest_from(Geometry(input), result.mesh), 1e-4);
}

TEST(KeptGeometry, WithoutReferencesThePlaceDecides) {
  Mesh mesh = solid_cylinder(6), other = solid_cylinder(9);
  for (Mesh* each : {&mesh, &other}) each->triangle_refs.assign(each->triangles.size(), 0);
  const Geometry geometry(other);
  ASSERT_EQ(geometry.ridges(), 2);
  const AdaptResult result = adapted(mesh, 0.25, geometry);
  EXPECT_EQ(result.report.off_surface, 0);
  EXPECT_NEAR(ridge_length(result.mesh), 4 * std::numbers::pi, 0.2);
}

/// A curved sheet between two regions: the cube with its middle plane bent.
Mesh bent_regions(Index n) {
  Mesh mesh = two_regions(n);
  for (auto& [x, y, z] : mesh.points) x += 0.4 * x * (1 - x) * std::sin(3 * y) * std::cos(2 * z);
  return mesh;
}

TEST(KeptGeometry, InterfacesLieOnIt) {
  Mesh sheet = bent_regions(16);
  sheet.tetrahedra.clear();
  sheet.tetrahedron_refs.clear();
  const Geometry geometry(sheet);
  Mesh mesh = bent_regions(6);
  for (const double size : {0.1, 0.25, 0.1}) {
    const AdaptResult result = adapted(mesh, size, geometry);
    mesh = result.mesh;
    EXPECT_EQ(result.report.off_surface, 0);
    EXPECT_LT(farthest_from(geometry, mesh), rounding);
  }
  EXPECT_NEAR(volume_of(mesh), 1, 1e-9);
}

TEST(KeptGeometry, AnApexIsNotTakenForACornerNearby) {
  Mesh in = cone(5, 1);
  const auto centre = static_cast<Index>(in.points.size());
  in.points.insert(in.points.end(), {{0, 0, 0}, {0, 0, 1.2}, {3, 0, 4}, {-1.5, 2.6, 4}, {-1.5, -2.6, 4}});
  for (const auto& [a, b, c] : in.triangles) in.tetrahedra.push_back({centre, a, b, c});
  in.tetrahedra.push_back({centre + 1, centre + 2, centre + 3, centre + 4});
  in.triangles.clear();
  add_triangles(in);
  in.triangle_refs.clear();
  const AdaptResult result = adapt(in, uniform(0.3), {.geometry = Geometry(in), .max_rounds = 4});
  expect_valid(result, in);
  for (const Index p : {Index{0}, centre + 1}) EXPECT_EQ(std::ranges::count(result.mesh.points, in.points[p]), 1);
  EXPECT_EQ(result.report.off_surface, 0);
}

TEST(KeptGeometry, AMeshThatDoesNotMatch) {
  const Geometry sphere(round_ball(6));
  Mesh large = round_ball(6);
  for (Point& p : large.points) p = 1.5 * p;
  EXPECT_NE(refusal(large, sphere).find("geometry: triangle"), std::string::npos) << refusal(large, sphere);

  Mesh renamed = round_ball(6);
  renamed.triangle_refs.assign(renamed.triangles.size(), 3);
  EXPECT_NE(refusal(renamed, sphere).find("no patch of reference 3"), std::string::npos) << refusal(renamed, sphere);

  const Mesh other = wedge(8);
  Mesh shifted = wedge(4);
  for (Point& p : shifted.points) p[2] += 0.2;
  EXPECT_NE(refusal(shifted, Geometry(other)).find("geometry: "), std::string::npos);
}

TEST(KeptGeometry, AVertexFarAway) {
  Mesh mesh = round_ball(6);
  const Geometry geometry(round_ball(12));
  const Index v = mesh.triangles[0][0];
  mesh.points[v] = 1.25 * mesh.points[v];
  EXPECT_NE(refusal(mesh, geometry).find("geometry: "), std::string::npos);
}

TEST(KeptGeometry, NeedsASurfaceThatIsAdapted) {
  const Mesh mesh = round_ball(4);
  for (const Surface surface : {Surface::planar, Surface::fixed})
    EXPECT_THROW(
        (void)adapt(mesh, Sizes(mesh.points.size(), 1), {.surface = surface, .geometry = Geometry(round_ball(4))}),
        InputError);
}

TEST(KeptGeometry, TheResultDoesNotDependOnThreads) {
  const Mesh mesh = solid_cylinder(5);
  const Geometry geometry(solid_cylinder(8));
  const auto hash = [&](int threads) {
    return adapt(mesh, Sizes(mesh.points.size(), 0.25), {.geometry = geometry, .threads = threads, .block_size = 300})
        .report.hash;
  };
  EXPECT_EQ(hash(1), hash(2));
}

TEST(KeptGeometry, ADeviationKnowsTheCurvaturesOfTheGeometry) {
  const auto stretched = [](Mesh mesh) {
    for (Point& p : mesh.points) p[0] *= 2;
    return mesh;
  };
  const AdaptOptions options{.deviation = 0.01, .geometry = Geometry(stretched(round_ball(16)))};
  const auto adapted = [&](const Mesh& mesh) { return adapt(mesh, Sizes(mesh.points.size(), 1), options).mesh; };
  const Mesh once = adapted(stretched(round_ball(2))), twice = adapted(once);
  EXPECT_NEAR(static_cast<double>(twice.triangles.size()) / static_cast<double>(once.triangles.size()), 1, 0.05);
}

}  // namespace
}  // namespace taut::test
