#include "surface/reference_surface.hpp"

#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "geometry/classified.hpp"
#include "sizing/curved_meshes.hpp"
#include "surface/surfaces.hpp"

namespace taut {
namespace {

ReferenceSurface reference_of(Mesh mesh, std::optional<double> angle = {}) {
  mesh.tetrahedra.clear();
  return {surface_of(mesh), angle};
}

/// Calls visit(SurfacePoint, OnPatch) for 15 places on each triangle.
template <class Visit>
void for_each_sample(const ReferenceSurface& surface, Visit visit) {
  constexpr int n = 4;
  for (const TriangleId t : ids<TriangleId>(surface.facets().triangles.size()))
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const std::array<double, 3> w = {1.0 - (i + j) / 4.0, i / 4.0, j / 4.0};
        const SurfacePoint s = evaluate(surface.cubic_of(t), w);
        OnPatch at;
        at.point = s.x, at.triangle = t, at.weights = w;
        visit(s, at);
      }
}

struct Errors {
  double worst = 0, mean = 0;
};

/// `distance` is that from the exact surface.
Errors errors_of(const ReferenceSurface& surface, const std::function<double(const Vec3&)>& distance) {
  Errors errors;
  double count = 0;
  for_each_sample(surface, [&](const SurfacePoint& s, const OnPatch&) {
    errors.worst = std::max(errors.worst, std::abs(distance(s.x)));
    errors.mean += std::abs(distance(s.x));
    ++count;
  });
  errors.mean /= count;
  return errors;
}

double from_unit_sphere(const Vec3& x) {
  return norm(x) - 1;
}

double from_tube(const Vec3& x) {
  return test::from_unit_circle(x) - 0.35;
}

TEST(ReferenceSurface, IsASphere) {
  const ReferenceSurface coarse = reference_of(test::sphere(8, 1)), fine = reference_of(test::sphere(16, 2));
  const Errors a = errors_of(coarse, from_unit_sphere), b = errors_of(fine, from_unit_sphere);
  EXPECT_LT(b.worst, 1e-5);
  EXPECT_LT(b.mean, 1.5e-6);
  EXPECT_GT(std::log2(a.mean / b.mean), 3);
  EXPECT_EQ(fine.patches().size(), 1U);
  EXPECT_TRUE(fine.curves().empty());
  EXPECT_TRUE(fine.corners().empty());
}

TEST(ReferenceSurface, IsATube) {
  const Errors a = errors_of(reference_of(test::tube(36, 14)), from_tube);
  const Errors b = errors_of(reference_of(test::tube(72, 28)), from_tube);
  EXPECT_LT(b.worst, 1.5e-4);
  EXPECT_LT(b.mean, 1.5e-5);
  EXPECT_GT(std::log2(a.mean / b.mean), 3);
}

TEST(ReferenceSurface, HasTheNormalsAndCurvaturesOfASphere) {
  const ReferenceSurface surface = reference_of(test::sphere(12, 3));
  for_each_sample(surface, [&](const SurfacePoint& s, const OnPatch& at) {
    const Vec3 n = cross(s.u, s.v), x = 1 / norm(s.x) * s.x;
    EXPECT_LT(norm(1 / norm(n) * n - x), 5e-3);
    const Sym3 shape = surface.shape_operator(at);
    EXPECT_NEAR(shape[0] + shape[3] + shape[5], 2, 0.05);
    EXPECT_LT(norm(shape * x), 0.2);
  });
}

/// Rims are circles, the side is smooth up to them, and caps are planar.
TEST(ReferenceSurface, IsACylinder) {
  const ReferenceSurface surface = reference_of(test::cylinder(12, 1, 2));
  EXPECT_EQ(surface.patches().size(), 3U);
  ASSERT_EQ(surface.curves().size(), 2U);
  EXPECT_TRUE(surface.corners().empty());
  for (const ReferenceCurve& rim : surface.curves()) {
    EXPECT_EQ(rim.vertices.front(), rim.vertices.back());
    EXPECT_EQ(rim.patches.size(), 2U);
    for (const CubicSegment& b : rim.segments)
      for (int i = 0; i <= 10; ++i) {
        const Vec3 x = evaluate(b, i / 10.0).x;
        EXPECT_NEAR(std::hypot(x[0], x[1]), 1, 1e-7);
        EXPECT_NEAR(x[2], b[0][2], 1e-14);
      }
  }
  for_each_sample(surface, [&](const SurfacePoint& s, const OnPatch& at) {
    const Vec3 normal = area_normal(surface.facets(), at.triangle);
    const bool is_cap = std::abs(normal[2]) > 0.5 * norm(normal);
    const double z = surface.facets().points[surface.facets().triangles[at.triangle][0]][2];
    EXPECT_LT(std::abs(is_cap ? s.x[2] - z : std::hypot(s.x[0], s.x[1]) - 1), is_cap ? 1e-14 : 2e-4);
  });
}

/// Three rows of points that are not quite straight, along which a polynomial of degree 3 has any slope.
TEST(ReferenceSurface, IsACylinderOfTwoRows) {
  for (const Index n : {10U, 14U, 18U, 24U})
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
      const double a = 2 * std::numbers::pi;
      const Mesh mesh = test::sheet({.nu = n, .nv = 2, .is_closed_in_u = true, .jitter = 0.02, .seed = seed},
                                    [&](double u, double v) {
                                      return Vec3{std::cos(a * u), std::sin(a * u), 2 * a / n * v};
                                    });
      const Errors errors = errors_of(reference_of(mesh), [](const Vec3& x) { return std::hypot(x[0], x[1]) - 1; });
      EXPECT_LT(errors.worst, 0.15 * (1 - std::cos(a / 2 / n))) << n << ' ' << seed;
    }
}

TEST(ReferenceSurface, IsExactOnPlanesAndStraightLines) {
  for (const Mesh& plain : {test::cube(4), test::l_shape(6), test::roof(6, 20)}) {
    const Mesh mesh = test::askew(plain);
    const ReferenceSurface surface = reference_of(mesh);
    for_each_sample(surface, [&](const SurfacePoint& s, const OnPatch& at) {
      const auto [a, b, c] = places_of(surface.facets(), at.triangle);
      EXPECT_LT(norm(s.x - (at.weights[0] * a + at.weights[1] * b + at.weights[2] * c)), 1e-13);
    });
    EXPECT_GE(surface.curves().size(), 5U);
    for (const ReferenceCurve& curve : surface.curves()) {
      const Vec3 &a = curve.segments.front()[0], &b = curve.segments.back()[3];
      for (const CubicSegment& segment : curve.segments)
        for (int i = 0; i <= 10; ++i)
          EXPECT_LT(norm(cross(evaluate(segment, i / 10.0).x - a, b - a)) / norm(b - a), 1e-13);
    }
  }
}

TEST(ReferenceSurface, HasTheCornersOfACube) {
  Mesh mesh = test::cube(3);
  mesh.triangle_refs.clear();
  const ReferenceSurface surface = reference_of(mesh);
  EXPECT_EQ(surface.patches().size(), 6U);
  EXPECT_EQ(surface.curves().size(), 12U);
  ASSERT_EQ(surface.corners().size(), 8U);
  for (const ReferenceCorner& corner : surface.corners()) {
    EXPECT_EQ(corner.curves.size(), 3U);
    EXPECT_EQ(corner.patches.size(), 3U);
  }
  for (const VertexId v : ids<VertexId>(mesh.points.size())) {
    int sides = 0;
    for (const double x : mesh.points[v]) sides += x == 0 || x == 1 ? 1 : 0;
    EXPECT_EQ(surface.tag_of(v).dimension(), 3 - sides);
  }
}

/// Both triangles at an edge, whether it is smooth or a ridge, have the same curve.
TEST(ReferenceSurface, HasNoCracks) {
  for (const Mesh& mesh : {test::cylinder(6, 1, 2), test::sphere(5, 1), test::lens(10, 20)}) {
    const ReferenceSurface surface = reference_of(mesh);
    std::map<std::array<VertexId, 2>, std::array<Vec3, 2>> handles;
    for (const TriangleId t : ids<TriangleId>(surface.facets().triangles.size()))
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<VertexId, 2> edge = {surface.facets().triangles[t][k], surface.facets().triangles[t][(k + 1) % 3]};
        std::array<Vec3, 2> found = surface.cubic_of(t).handle[k];
        if (edge[0] > edge[1]) std::swap(edge[0], edge[1]), std::swap(found[0], found[1]);
        EXPECT_EQ(handles.try_emplace(edge, found).first->second, found);
      }
  }
}

/// Near the apex there are five triangles, which a fit cannot make round.
TEST(ReferenceSurface, IsACone) {
  const ReferenceSurface surface = reference_of(test::cone(12, 1.5));
  EXPECT_EQ(surface.patches().size(), 1U);
  EXPECT_EQ(surface.curves().size(), 1U);
  ASSERT_EQ(surface.corners().size(), 1U);
  EXPECT_EQ(surface.corners()[0].vertex, VertexId{0});
  EXPECT_EQ(surface.corners()[0].patches.size(), 1U);
  const Errors errors = errors_of(
      surface, [](const Vec3& x) { return (1.5 * std::hypot(x[0], x[1]) + x[2] - 1.5) / std::hypot(1, 1.5); });
  EXPECT_LT(errors.worst, 0.02);
  EXPECT_LT(errors.mean, 2e-4);
}

/// Where the curvature grows with 1 over the distance from the apex, polynomials would not find it.
TEST(ReferenceSurface, IsCurvedAsAConeNextToItsApex) {
  for (const Index sides : {3U, 5U}) {
    const ReferenceSurface surface = reference_of(test::cone(12, 1.5, 3, sides));
    int found = 0;
    for (const TriangleId t : ids<TriangleId>(surface.facets().triangles.size())) {
      const Corners& v = surface.facets().triangles[t];
      if (std::ranges::find(v, VertexId{0}) == v.end()) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        if (v[k] == VertexId{0}) continue;
        OnPatch at;
        at.triangle = t, at.weights = {0, 0, 0}, at.weights[k] = 1;
        const Vec3& x = surface.facets().points[v[k]];
        const double r = std::hypot(x[0], x[1]), expected = 1.5 / std::hypot(1, 1.5) / r;
        const Vec3 around = {-x[1] / r, x[0] / r, 0};
        const Sym3 shape = surface.shape_operator(at);
        EXPECT_NEAR(quadratic_form(shape, around), expected, 1e-9 * expected);
        EXPECT_NEAR(norm(shape * x) - expected * std::abs(dot(around, x)), 0, 1e-9);
        ++found;
      }
    }
    EXPECT_EQ(found, static_cast<int>(2 * sides));
  }
}

TEST(ReferenceSurface, HasCornersOnRidgesWhereTheInputSaysSo) {
  Mesh mesh = test::cylinder(6, 1, 2);
  for (Index p = 0; p < mesh.points.size(); ++p)
    if (mesh.points[p][2] == 2 && std::hypot(mesh.points[p][0], mesh.points[p][1]) > 1 - 1e-9) mesh.corners = {p};
  mesh.corners.push_back(mesh.triangles[0][0]);
  ASSERT_LT(std::hypot(mesh.points[mesh.corners[1]][0], mesh.points[mesh.corners[1]][1]), 2);
  const ReferenceSurface surface = reference_of(mesh);
  EXPECT_EQ(surface.curves().size(), 2U);
  EXPECT_LE(surface.corners().size(), 2U);
  EXPECT_TRUE(surface.tag_of(VertexId{mesh.corners[0]}).is_at_corner());
}

TEST(ReferenceSurface, ChainsTurnSharplyAtCorners) {
  const auto corners_of_polygon = [](int sides, Index edges) {
    const auto corner = [&](double k) {
      const double a = 2 * std::numbers::pi * k / sides;
      return Vec3{std::cos(a), std::sin(a), 0};
    };
    const Mesh mesh =
        test::sheet({.nu = sides * edges, .nv = 2, .is_closed_in_u = true, .jitter = 0}, [&](double u, double v) {
          const double k = std::floor(u * sides + 1e-9), s = u * sides - k;
          return (0.5 + v) * ((1 - s) * corner(k) + s * corner(k + 1));
        });
    return reference_of(mesh).corners().size();
  };
  EXPECT_EQ(corners_of_polygon(12, 3), 24U);  // of 30 degrees
  EXPECT_EQ(corners_of_polygon(6, 1), 12U);   // of 60 degrees: no circle is that coarse
  EXPECT_EQ(corners_of_polygon(16, 1), 0U);   // of 22.5 degrees: a circle
}

TEST(ReferenceSurface, IsTheSameOnAnyNumberOfThreads) {
  const Mesh mesh = test::cylinder(16, 2, 2);
  const auto points = [&](int threads) {
    return test::with_threads(threads, [&] {
      std::vector<Vec3> found;
      for_each_sample(reference_of(mesh), [&](const SurfacePoint& s, const OnPatch&) { found.push_back(s.x); });
      return found;
    });
  };
  EXPECT_EQ(points(1), points(3));
}

TEST(ReferenceSurface, SagsAreThoseOfCircles) {
  const ReferenceSurface surface = reference_of(test::sphere(16, 5));
  const auto on_sphere = [](const Vec3& x) { return 1 / norm(x) * x; };
  const std::array<Vec3, 3> facet = {on_sphere({1, 0, 0.1}), on_sphere({1, 0.3, 0}), on_sphere({1, 0, -0.3})};
  double expected = 0;
  for (const Vec3& x : {(1.0 / 3) * (facet[0] + facet[1] + facet[2]), 0.5 * (facet[0] + facet[1]),
                        0.5 * (facet[1] + facet[2]), 0.5 * (facet[2] + facet[0])})
    expected = std::max(expected, 1 - norm(x));
  EXPECT_NEAR(surface.sag(PatchId{0}, facet), expected, 1e-5);

  const ReferenceSurface rims = reference_of(test::cylinder(16, 1, 2));
  const double z = rims.facets().points[rims.curves()[0].vertices[0]][2];
  EXPECT_NEAR(rims.sag(LineId{0}, {Vec3{1, 0, z}, Vec3{std::cos(0.4), std::sin(0.4), z}}), 1 - std::cos(0.2), 1e-6);
}

}  // namespace
}  // namespace taut
