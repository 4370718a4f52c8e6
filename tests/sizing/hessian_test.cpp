#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "sizing/smooth_fields.hpp"
#include "taut/sizing.hpp"

namespace taut {
namespace {

using test::irregular_cube;
using test::Quadratic;
using test::refusal;
using test::sampled;
using test::Wave;

double difference(const Tensor& a, const Tensor& b) {
  double most = 0;
  for (std::size_t i = 0; i < 6; ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

bool is_on_boundary(const Point& p) {
  return std::ranges::any_of(p, [](double x) { return x == 0 || x == 1; });
}

TEST(Hessian, IsExactForQuadraticsAlsoOnTheBoundary) {
  const Mesh mesh = irregular_cube(5, 1);
  for (const Tensor& h : recover_hessian(mesh, sampled(mesh, Quadratic::value)))
    EXPECT_LT(difference(h, Quadratic::hessian), 1e-10);
}

TEST(Hessian, IsExactForQuadraticsOnStretchedMeshes) {
  Mesh mesh = irregular_cube(5, 2);
  for (Point& p : mesh.points) p = {p[0] + 0.3 * p[1], p[1], 1e-3 * p[2] + 0.1 * p[0]};
  for (const Tensor& h : recover_hessian(mesh, sampled(mesh, Quadratic::value)))
    EXPECT_LT(difference(h, Quadratic::hessian), 1e-5);  // rounding over the square of the smallest size
}

TEST(Hessian, OfALinearFieldIsRounding) {
  const Mesh mesh = irregular_cube(6, 3);
  const auto linear = [](const Point& p) { return 1e3 + 5 * p[0] - 2 * p[1] + p[2]; };
  for (const Recovery recovery : {Recovery::least_squares, Recovery::double_projection})
    for (const Tensor& h : recover_hessian(mesh, sampled(mesh, linear), recovery))
      EXPECT_LT(difference(h, Tensor{}), 1e-13 * 1e3 * 36);
}

TEST(Hessian, DoesNotSeeAConstantThatIsAdded) {
  const Mesh mesh = irregular_cube(4, 4);
  const auto plain = recover_hessian(mesh, sampled(mesh, Quadratic::value));
  const auto shifted = recover_hessian(mesh, sampled(mesh, [](const Point& p) { return Quadratic::value(p) + 1024; }));
  for (std::size_t v = 0; v < plain.size(); ++v) EXPECT_LT(difference(plain[v], shifted[v]), 1e-9);
}

/// Sums of the errors inside and on the boundary over those of the Hessian.
std::array<double, 2> relative_errors(Index n) {
  const Mesh mesh = irregular_cube(n, n);
  const auto hessians = recover_hessian(mesh, sampled(mesh, Wave::value));
  std::array<double, 2> error{}, size{};
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Tensor exact = Wave::hessian(mesh.points[v]);
    const std::size_t where = is_on_boundary(mesh.points[v]) ? 1 : 0;
    error[where] += difference(hessians[v], exact);
    size[where] += difference(exact, Tensor{});
  }
  return {error[0] / size[0], error[1] / size[1]};
}

TEST(Hessian, ConvergesOnIrregularMeshes) {
  const auto coarse = relative_errors(12), fine = relative_errors(24);
  EXPECT_GT(std::log2(coarse[0] / fine[0]), 1.3);
  EXPECT_GT(std::log2(coarse[1] / fine[1]), 0.9);  // one-sided
  EXPECT_LT(fine[0], 0.04);
}

TEST(Hessian, ByProjectionIsNearOneThatIsConstant) {
  const Mesh mesh = irregular_cube(10, 5);
  const auto hessians = recover_hessian(mesh, sampled(mesh, Quadratic::value), Recovery::double_projection);
  double sum = 0;
  for (const Tensor& h : hessians) sum += difference(h, Quadratic::hessian);
  EXPECT_LT(sum / static_cast<double>(hessians.size()), 1);
}

/// One layer of boxes: two planes of points, between which a quadratic function of z is not determined.
TEST(Hessian, IsFoundInThinPlates) {
  Mesh mesh = test::restricted(irregular_cube(8, 6), [](const Vec3& c) { return c[2] < 0.125; });
  for (Point& p : mesh.points) p[2] = p[2] == 0 ? 0 : 0.1;
  const std::vector<double> values = sampled(mesh, [](const Point& p) { return p[0] * p[0]; });
  EXPECT_NE(refusal(1, [&] { return recover_hessian(mesh, values); }).find("vertex 1: too few"), std::string::npos);
  EXPECT_EQ(recover_hessian(mesh, values, Recovery::double_projection).size(), mesh.points.size());
}

TEST(Hessian, TakesTheMeanWhereAPartIsTooSmall) {
  Mesh mesh = irregular_cube(5, 7);  // with a spike of one tetrahedron, whose tip sees few points
  const Index tip = static_cast<Index>(mesh.points.size());
  const auto& base = mesh.triangles.front();
  const Vec3 c = test::centre_of(mesh, base), n = test::area_normal(mesh, base);
  mesh.points.push_back(c + 5.0 * n);
  mesh.tetrahedra.push_back({base[0], base[1], base[2], tip});
  const auto hessians = recover_hessian(mesh, sampled(mesh, Quadratic::value));
  EXPECT_LT(difference(hessians[tip], Quadratic::hessian), 1e-8);
}

TEST(Hessian, IsZeroAtAPointWithoutTetrahedron) {
  Mesh mesh = irregular_cube(4, 8);
  mesh.points.push_back({9, 9, 9});
  for (const Recovery recovery : {Recovery::least_squares, Recovery::double_projection})
    EXPECT_EQ(recover_hessian(mesh, sampled(mesh, Quadratic::value), recovery).back(), Tensor{});
}

TEST(Hessian, HasTheSameBitsOnAnyNumberOfThreads) {
  const Mesh mesh = irregular_cube(20, 9);
  const auto values = sampled(mesh, Wave::value);
  for (const Recovery recovery : {Recovery::least_squares, Recovery::double_projection}) {
    const auto on = [&](int threads) {
      return test::with_threads(threads, [&] { return recover_hessian(mesh, values, recovery); });
    };
    EXPECT_EQ(on(1), on(3));
  }
}

TEST(Hessian, RefusesValuesThatDoNotFit) {
  const Mesh mesh = irregular_cube(3, 10);
  std::vector<double> values = sampled(mesh, Wave::value);
  values[4] = std::nan("");
  EXPECT_EQ(refusal(2, [&] { return recover_hessian(mesh, values); }), "field: vertex 5: value nan is not finite");
  values.pop_back();
  EXPECT_EQ(refusal(2, [&] { return recover_hessian(mesh, values); }),
            "field: 63 values for 64 vertices, expected one per vertex");
}

}  // namespace
}  // namespace taut
