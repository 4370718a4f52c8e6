// Adaptations of curved boundaries: vertices stay on the surface that the input's triangles stand for.
#include <numbers>

#include "adapt/curved_checks.hpp"
#include "adapt/fields.hpp"
#include "sizing/curved_meshes.hpp"
#include "surface/surfaces.hpp"

namespace taut {
namespace {

constexpr double pi = std::numbers::pi;

// The largest distance of a vertex of the surface from the unit sphere.
double distance_from_sphere(const Mesh& mesh) {
  double most = 0;
  for (const Index p : test::surface_points(mesh)) most = std::max(most, std::abs(norm(mesh.points[p]) - 1));
  return most;
}

Mesh sphere(Index n, unsigned seed = 1) {
  Mesh mesh = test::sphere(n, seed);
  mesh.triangle_refs.assign(mesh.triangles.size(), 1);
  return mesh;
}

constexpr int side = 1, bottom = 2, top = 3;  // of the cylinder and the cone

Mesh cylinder(Index n, double height) {
  Mesh mesh = test::cylinder(n, 1, height);
  for (const auto& t : mesh.triangles) {
    const double z = test::centre_of(mesh, t)[2];
    mesh.triangle_refs.push_back(z == 0 ? bottom : z == height ? top : side);
  }
  return mesh;
}

// The tetrahedra between the triangles of a cone's side and the centre of its base.
Mesh cone(Index rings, double height) {
  Mesh mesh = test::cone(rings, height);
  const auto centre = static_cast<Index>(mesh.points.size());
  mesh.points.push_back({0, 0, 0});
  for (const auto& [a, b, c] : mesh.triangles) mesh.tetrahedra.push_back({centre, a, b, c});
  mesh.triangles.clear();
  test::add_triangles(mesh);
  mesh.triangle_refs.clear();
  for (const auto& t : mesh.triangles) mesh.triangle_refs.push_back(test::centre_of(mesh, t)[2] == 0 ? bottom : side);
  return mesh;
}

constexpr int interface = 7;

// A cube of side 2, region 2, around a ball of radius 1/2, region 1. n is a multiple of 4.
Mesh ball_in_a_cube(Index n) {
  Mesh mesh = test::grid(n);
  const auto largest = [](const Vec3& c) { return std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])}); };
  for (const auto& t : mesh.tetrahedra)
    mesh.tetrahedron_refs.push_back(largest(2.0 * test::centre_of(mesh, t) - Vec3{1, 1, 1}) < 0.5 ? 1 : 2);
  for (Point& p : mesh.points) {
    const Vec3 c = 2.0 * p - Vec3{1, 1, 1};
    const double m = largest(c), out = std::max(0.0, 2 * m - 1);
    Mesh one;
    one.points = {0.5 * (std::min(1.0, 0.5 / std::max(m, 0.5)) * 2.0 * c + Vec3{1, 1, 1})};
    p = (1 - out) * (0.5 * test::ball(one).points[0]) + (out > 0 ? out / m : 0) * c;
  }
  test::add_triangles(mesh);
  return mesh;
}

// A quarter of a ring, radii 1/2 and 1, height 1, with n cells in each direction.
Mesh quarter_ring(Index n) {
  Mesh mesh = test::grid(n);
  test::add_triangles(mesh);
  mesh.triangle_refs.clear();
  for (const auto& t : mesh.triangles) {
    const Vec3 c = test::centre_of(mesh, t);
    mesh.triangle_refs.push_back(c[0] == 0 ? 1 : c[0] == 1 ? 2 : c[1] == 0 ? 3 : c[1] == 1 ? 4 : c[2] == 0 ? 5 : 6);
  }
  for (Point& p : mesh.points) {
    const double r = 0.5 + 0.5 * p[0], angle = 0.5 * pi * p[1];
    p = {r * std::cos(angle), r * std::sin(angle), p[2]};
  }
  return mesh;
}

// Layers of 0.002 on the inner cylinder, 0.1 along it.
Sym3 layers(const Vec3& x) {
  const double r = std::hypot(x[0], x[1]), across = 0.002 + 0.2 * std::abs(r - 0.5);
  const Vec3 e = {x[0] / r, x[1] / r, 0};
  return 100.0 * identity3 + (1 / (across * across) - 100) * outer(e);
}

TEST(Curved, LayersThinnerThanTheSagHaveRoom) {
  const Mesh in = quarter_ring(6);  // edges of 0.13, whose middles are 0.004 below the cylinder
  const auto metric = [](const Point& x) { return layers(x); };
  const AdaptResult result = adapt(in, metric, {.limits = {}, .max_rounds = 20});
  test::expect_near_curved(result, in);
  EXPECT_LT(result.report.quality.length_max, 4) << "vertices between an edge and its middle on the surface kept it";
  EXPECT_GT(result.report.quality.mean_ratio_min, 0.1);
}

TEST(Curved, ASphereBecomesFiner) {
  const Mesh in = sphere(8);
  const AdaptResult result = adapt(in, test::uniform(0.14), {.max_rounds = 12});
  test::expect_near_curved(result, in);
  EXPECT_LT(distance_from_sphere(result.mesh), 6e-5) << "of flat triangles it is 0.017";
  EXPECT_GT(test::volume_of(result.mesh), test::volume_of(in));
  EXPECT_LT(test::volume_of(result.mesh), 4 * pi / 3);
  EXPECT_EQ(test::inward_triangles(result.mesh), 0);
  EXPECT_GT(2 * result.mesh.triangles.size(), 3 * in.triangles.size());
  EXPECT_EQ(result.report.triangles_frozen, 0);
  EXPECT_LT(result.report.quality.Q_max, 5);
}

TEST(Curved, ASphereBecomesCoarser) {
  const Mesh in = sphere(12);
  const AdaptResult result = adapt(in, test::uniform(0.4), {.max_rounds = 12});
  test::expect_near_curved(result, in);
  EXPECT_LT(distance_from_sphere(result.mesh), 1e-5);
  EXPECT_LT(test::volume_of(result.mesh), 4 * pi / 3);
  EXPECT_EQ(test::inward_triangles(result.mesh), 0);
  EXPECT_LT(result.mesh.triangles.size(), in.triangles.size() / 2);
}

TEST(Curved, TopologyOutlivesSizesFarBeyondTheCurvature) {
  for (const double size : {2.0, 10.0}) {
    const Mesh in = sphere(8);
    const AdaptResult result = adapt(in, test::uniform(size), {.max_rounds = 12});
    test::expect_valid(result, in);
    test::expect_on_surface_of(result.mesh, in);
    EXPECT_EQ(test::euler_characteristic(result.mesh), 2);
    EXPECT_EQ(test::inward_triangles(result.mesh), 0);
    EXPECT_GT(test::volume_of(result.mesh), 0.5) << "that of the regular tetrahedron in the sphere";
    EXPECT_LT(result.mesh.triangles.size(), in.triangles.size() / 4);
  }
}

void expect_cylinder(const Mesh& mesh, double height) {
  std::map<Index, std::set<int>> refs;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index p : mesh.triangles[t]) refs[p].insert(mesh.triangle_refs[t]);
  std::size_t on_rims = 0;
  for (const auto& [p, of] : refs) {
    const Point& x = mesh.points[p];
    if (of.contains(bottom)) {
      EXPECT_LT(std::abs(x[2]), 1e-14);
    }
    if (of.contains(top)) {
      EXPECT_LT(std::abs(x[2] - height), 1e-14);
    }
    if (of.contains(side)) {
      EXPECT_NEAR(std::hypot(x[0], x[1]), 1, 8e-4);
    }
    on_rims += of.size() == 2 ? 1 : 0;
  }
  EXPECT_GE(on_rims, 6);
  EXPECT_EQ(test::inward_triangles(mesh), 0);
}

TEST(Curved, ACylinderKeepsItsRims) {
  const Mesh in = cylinder(8, 1.5);
  for (const double size : {0.15, 0.6}) {
    const AdaptResult result = adapt(in, test::uniform(size), {.max_rounds = 12});
    test::expect_near_curved(result, in);
    expect_cylinder(result.mesh, 1.5);
    EXPECT_LT(test::volume_of(result.mesh), 1.5 * pi);
  }
}

// Meshers write where a periodic surface begins. Nothing is to be seen there, so nothing need stay.
TEST(Curved, AGivenEdgeThatIsNotMarkedAndPartsNothingOfACurvedPatchIsNoFeature) {
  Mesh in = cylinder(8, 1.5);
  std::map<double, Index> seam;
  for (const Index p : test::surface_points(in))
    if (const Point& x = in.points[p]; std::abs(x[0] - x[1]) < 1e-14 && x[0] > 0.7) seam.emplace(x[2], p);
  ASSERT_EQ(seam.size(), 9);
  for (auto next = seam.begin(), at = next++; next != seam.end(); at = next++)
    in.edges.push_back({at->second, next->second});
  in.edge_refs.assign(in.edges.size(), 4);
  const AdaptResult result = adapt(in, test::uniform(0.6), {.max_rounds = 12});
  test::expect_near_curved(result, in);
  EXPECT_EQ(std::ranges::count(result.mesh.edge_refs, 4), 0);
  in.required_edges = test::all_of(in.edges.size());
  test::expect_valid(adapt(in, test::uniform(0.6), {.max_rounds = 12}), in);
}

TEST(Curved, AConeKeepsItsApex) {
  const Mesh in = cone(6, 1.2);
  for (const double size : {0.12, 0.5}) {
    const AdaptResult result = adapt(in, test::uniform(size), {.max_rounds = 12});
    test::expect_near_curved(result, in);
    EXPECT_EQ(std::ranges::count(result.mesh.points, in.points[0]), 1);
    EXPECT_EQ(test::inward_triangles(result.mesh), 0);
  }
}

TEST(Curved, AnInterfaceIsAdaptedFromBothSides) {
  const Mesh in = ball_in_a_cube(8);
  for (const auto& t : in.tetrahedra)
    ASSERT_GT(six_volumes(in.points[t[0]], in.points[t[1]], in.points[t[2]], in.points[t[3]]), 0);
  for (const double size : {0.12, 0.3}) {
    const AdaptResult result = adapt(in, test::uniform(size), {.max_rounds = 12});
    test::expect_near_curved(result, in);
    EXPECT_NEAR(test::volume_of(result.mesh), 8, 1e-11) << "the cube is planar";
    EXPECT_NE(test::placed_triangles(result.mesh), test::placed_triangles(in));
    for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t)
      for (const Index p : result.mesh.triangles[t])
        if (result.mesh.triangle_refs[t] == interface) {
          EXPECT_NEAR(norm(result.mesh.points[p]), 0.5, 7e-4);
        }
  }
}

TEST(Curved, WhatIsRequiredStaysToTheBit) {
  for (const double size : {0.15, 0.8}) {
    Mesh in = sphere(8);
    in.required_triangles = {3, 100, 101};
    in.edges = {{in.triangles[40][0], in.triangles[40][1]}, {in.triangles[200][1], in.triangles[200][2]}};
    in.required_edges = {0, 1};
    in.required_points = {in.triangles[300][0], in.triangles[60][2]};
    const AdaptResult result = adapt(in, test::uniform(size), {.max_rounds = 12});
    test::expect_valid(result, in);
    EXPECT_LT(distance_from_sphere(result.mesh), 7e-4) << "required edges do not part the surface";
    EXPECT_EQ(test::inward_triangles(result.mesh), 0);
    EXPECT_EQ(result.report.triangles_frozen, 3);
  }
}

TEST(Curved, PatchesAreKeptIfOnlyPlanarOnesMayChange) {
  const Mesh in = cylinder(6, 1.5);
  const AdaptResult result = adapt(in, test::uniform(0.2), {.surface = Surface::planar, .max_rounds = 6});
  test::expect_faithful(result, in);
  const auto kept = test::placed_triangles(result.mesh);
  for (const auto& triangle : test::placed_triangles(in))
    if (triangle.second == side) {
      EXPECT_TRUE(kept.contains(triangle));
    }
}

TEST(Curved, TheSameBitsOnAnyNumberOfThreads) {
  const Mesh in = ball_in_a_cube(8);
  std::set<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    const AdaptResult result =
        adapt(in, test::front(0.3, 0.5), {.max_rounds = 6, .threads = threads, .block_size = 100});
    EXPECT_GT(result.report.blocks, 3);
    hashes.insert(result.report.hash);
  }
  EXPECT_EQ(hashes.size(), 1);
}

}  // namespace
}  // namespace taut
