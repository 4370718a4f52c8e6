// Displacements by linear elasticity.
#include <gtest/gtest.h>

#include <array>

#include "base/with_threads.hpp"
#include "elasticity/problems.hpp"

namespace taut {
namespace {

using test::built_grid;
using test::constraints_of;
using test::displacement;
using test::error_of;
using test::Setting;
using Field = std::function<Vec3(const Vec3&)>;
using Constraints = std::vector<Constraint<Vec3>>;

Vec3 affine(const Vec3& p) {
  return {0.1 + 0.3 * p[0] - 0.2 * p[1], 0.4 * p[2] - 0.1 * p[0], 0.2 * p[1] + 0.1 * p[2] - 0.3};
}

Constraints fixed_to(const TetMesh& mesh, const Field& field) {
  return constraints_of<Vec3>(
      mesh, [&](const Vec3& p) { return test::is_on_cube(p) ? prescribed(field(p)) : Constraint<Vec3>{}; });
}

// A ball in the middle is lifted and the sides stand still.
Constraints lifted_ball(const TetMesh& mesh) {
  return constraints_of<Vec3>(mesh, [&](const Vec3& p) {
    if (test::is_on_cube(p)) return prescribed(Vec3{});
    return norm(p - Vec3{0.5, 0.5, 0.5}) < 0.25 ? prescribed(Vec3{0, 0, 0.1}) : Constraint<Vec3>{};
  });
}

// Without stiffening, an affine displacement is in equilibrium. With it, stresses are not uniform.
TEST(Elasticity, ReproducesAnAffineDisplacement) {
  const TetMesh mesh = built_grid(6);
  for (const double ratio : {0.0, 0.3, 0.45}) {
    const auto u = displacement(mesh, fixed_to(mesh, affine), {.law = {ratio}});
    EXPECT_TRUE(u.converged);
    EXPECT_LT(error_of<Vec3>(mesh, u.values, affine), 1e-11) << ratio;
  }
}

TEST(Elasticity, ReproducesAnAffineDisplacementOnEqualVolumesWithStiffening) {
  const TetMesh mesh = built_grid(6, 0);
  for (const double exponent : {0.5, 1.0, 2.0}) {
    const auto u = displacement(mesh, fixed_to(mesh, affine), {.stiffening = {exponent}});
    EXPECT_LT(error_of<Vec3>(mesh, u.values, affine), 1e-11) << exponent;
  }
}

TEST(Elasticity, MovesARigidlyHeldMeshAsAWhole) {
  const TetMesh mesh = built_grid(6);
  const Vec3 shift = {0.3, -0.2, 0.7};
  for (const double exponent : {0.0, 1.0, 2.0}) {
    const auto u = displacement(mesh, fixed_to(mesh, [&](const Vec3&) { return shift; }), {.stiffening = {exponent}});
    EXPECT_LT(error_of<Vec3>(mesh, u.values, [&](const Vec3&) { return shift; }), 1e-12) << exponent;
  }
}

// u = s e_x with s = sin(pi x) sin(pi y) sin(pi z) needs the force -mu laplace(u) - (lambda + mu) grad div u.
TEST(Elasticity, ConvergesWithTheSecondOrder) {
  constexpr double pi = 3.14159265358979323846;
  const LinearElastic law{0.3};
  const Field exact = [](const Vec3& p) {
    return Vec3{std::sin(pi * p[0]) * std::sin(pi * p[1]) * std::sin(pi * p[2]), 0, 0};
  };
  const Field force = [&](const Vec3& p) {
    const double sx = std::sin(pi * p[0]), sy = std::sin(pi * p[1]), sz = std::sin(pi * p[2]);
    const double cx = std::cos(pi * p[0]), cy = std::cos(pi * p[1]), cz = std::cos(pi * p[2]);
    const double both = law.lambda() + law.mu();
    return pi * pi * Vec3{(3 * law.mu() + both) * sx * sy * sz, -both * cx * cy * sz, -both * cx * sy * cz};
  };
  std::vector<double> errors;
  for (const Index n : {4U, 8U, 16U}) {
    const TetMesh mesh = built_grid(n, 0.1);
    std::vector<Vec3> loads(mesh.vertices.size());
    std::vector<double> volumes(mesh.vertices.size());
    for (const Tet& t : mesh.tets) {
      const double volume = six_volumes(mesh.x(t.v[0]), mesh.x(t.v[1]), mesh.x(t.v[2]), mesh.x(t.v[3])) / 6;
      for (const VertexId i : t.v) {
        volumes[i] += volume / 4;
        for (const VertexId j : t.v) loads[i] = loads[i] + (volume / (i == j ? 10 : 20)) * force(mesh.x(j));
      }
    }
    const auto u = displacement(mesh, fixed_to(mesh, exact), {.law = law}, loads);
    double square = 0;
    for (const VertexId v : mesh.vertex_ids()) {
      const Vec3 d = u.values[v] - exact(mesh.x(v));
      square += volumes[v] * dot(d, d);
    }
    errors.push_back(std::sqrt(square));
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.8);
}

// A bar between frictionless walls is pulled: uniaxial strain, whichever way the whole is turned.
class Walls : public testing::TestWithParam<std::array<Vec3, 3>> {};

TEST_P(Walls, LetVerticesSlide) {
  const auto& axes = GetParam();
  const auto turned = [&](const Vec3& p) { return p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2]; };
  TetMesh mesh = built_grid(5);
  const TetMesh straight = mesh;
  for (Vertex& v : mesh.vertices) v.x = turned(v.x);
  Constraints constraints(mesh.vertices.size());
  for (const VertexId v : mesh.vertex_ids()) {
    const Vec3& p = straight.x(v);
    const bool on_y = p[1] == 0 || p[1] == 1, on_z = p[2] == 0 || p[2] == 1;
    if (p[0] == 0 || p[0] == 1) {
      constraints[v] = prescribed(0.2 * p[0] * axes[0]);
      if (!on_y && !on_z) constraints[v].free = sliding(axes[0]).free;  // the ends move, and vertices slide on them
    } else if (on_y && on_z) {
      constraints[v] = sliding(axes[1], axes[1] + axes[2]);
    } else if (on_y || on_z) {
      constraints[v] = sliding(2.0 * axes[on_y ? 1 : 2]);
    }
  }
  for (const auto kind :
       {Preconditioner::two_level, Preconditioner::block_jacobi, Preconditioner::incomplete_cholesky}) {
    const Setting setting{.options = {{.residual = 1e-13}, kind}};
    const auto u = displacement(mesh, constraints, setting);
    EXPECT_TRUE(u.converged);
    double worst = 0, off_wall = 0;
    for (const VertexId v : mesh.vertex_ids()) {
      worst = std::max(worst, norm(u.values[v] - 0.2 * straight.x(v)[0] * axes[0]));
      if (straight.x(v)[1] == 0) off_wall = std::max(off_wall, std::abs(dot(u.values[v], axes[1])));
    }
    EXPECT_LT(worst, 1e-11);
    EXPECT_LT(off_wall, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Elasticity, Walls,
                         testing::Values(std::array<Vec3, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                         std::array<Vec3, 3>{{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}},
                                         std::array<Vec3, 3>{{{1. / 3, 2. / 3, 2. / 3},
                                                              {-2. / 3, -1. / 3, 2. / 3},
                                                              {2. / 3, -2. / 3, 1. / 3}}}));

// The half x < 0.5 of a bar has elements of half the length.
TEST(Elasticity, StiffeningDeformsSmallElementsLess) {
  TetMesh mesh = built_grid(6, 0);
  for (Vertex& v : mesh.vertices) v.x[0] = v.x[0] <= 0.5 ? v.x[0] : 0.5 + 4 * (v.x[0] - 0.5);
  const auto constraints = constraints_of<Vec3>(mesh, [](const Vec3& p) {
    return p[0] == 0 || p[0] == 2.5 ? prescribed(Vec3{0.1 * p[0], 0, 0}) : sliding({0, 1, 0}, {0, 0, 1});
  });
  // In a bar the stress is uniform, so strains are in the inverse ratio of the coefficients, 4^chi.
  for (const double exponent : {0.0, 1.0, 2.0}) {
    const auto u = displacement(mesh, constraints, {.stiffening = {exponent}, .law = {0}});
    const double ratio = std::pow(4, exponent), strain = 0.25 / (0.5 + 2 * ratio);
    const Field expected = [&](const Vec3& p) {
      return Vec3{p[0] <= 0.5 ? strain * p[0] : 0.25 - ratio * strain * (2.5 - p[0]), 0, 0};
    };
    EXPECT_LT(error_of<Vec3>(mesh, u.values, expected), 1e-11) << exponent;
  }
}

TEST(Elasticity, AStiffTetrahedronStaysRigid) {
  const TetMesh mesh = built_grid(6);
  const auto inside = std::ranges::find_if(mesh.tets, [&](const Tet& t) {
    return std::ranges::none_of(t.v, [&](VertexId v) { return test::is_on_cube(mesh.x(v)); });
  });
  std::vector<double> factor(mesh.tets.size(), 1);
  factor[static_cast<std::size_t>(inside - mesh.tets.begin())] = 1e6;
  const auto strain = [&](const std::vector<Vec3>& u) {
    const auto& v = inside->v;
    const Vec3 edge = mesh.x(v[1]) - mesh.x(v[0]);
    return std::abs(dot(u[v[1]] - u[v[0]], edge)) / dot(edge, edge);
  };
  const auto soft = displacement(mesh, fixed_to(mesh, affine));
  const auto stiff = displacement(mesh, fixed_to(mesh, affine), {.stiffening = {.factor_of_tet = factor}});
  EXPECT_LT(strain(stiff.values), 1e-4 * strain(soft.values));
}

TEST(Elasticity, PreconditionersAgree) {
  const TetMesh mesh = built_grid(16);
  Setting setting{.stiffening = {1.5}};
  setting.options.preconditioner = Preconditioner::block_jacobi;
  const auto plain = displacement(mesh, lifted_ball(mesh), setting);
  EXPECT_TRUE(plain.converged);
  for (const auto kind : {Preconditioner::two_level, Preconditioner::incomplete_cholesky}) {
    setting.options.preconditioner = kind;
    const auto better = displacement(mesh, lifted_ball(mesh), setting);
    EXPECT_TRUE(better.converged);
    EXPECT_LT(better.convergence.iterations, 0.75 * plain.convergence.iterations);
    for (std::size_t i = 0; i < plain.values.size(); ++i) EXPECT_LT(norm(plain.values[i] - better.values[i]), 1e-12);
  }
}

TEST(Elasticity, ReportsThatItDidNotConverge) {
  const TetMesh mesh = built_grid(6);
  const Setting few{.options = {.stop = {.residual = 1e-13, .iterations = 3}}};
  const auto u = displacement(mesh, lifted_ball(mesh), few);
  EXPECT_FALSE(u.converged);
  EXPECT_EQ(u.convergence.iterations, 3);
  EXPECT_GT(u.convergence.residual, 1e-13);
  auto constraints = lifted_ball(mesh);
  constraints[0] = prescribed(Vec3{std::nan(""), 0, 0});
  EXPECT_FALSE(displacement(mesh, constraints).converged);
}

TEST(Elasticity, ResultDoesNotDependOnTheThreads) {
  const TetMesh mesh = built_grid(14);
  const auto constraints = lifted_ball(mesh);
  const auto on = [&](int threads) {
    return test::with_threads(threads, [&] { return displacement(mesh, constraints, {.stiffening = {1}}).values; });
  };
  const auto one = on(1);
  EXPECT_EQ(one, on(2));
  EXPECT_EQ(one, on(3));
}

}  // namespace
}  // namespace taut
