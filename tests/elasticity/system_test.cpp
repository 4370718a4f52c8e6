// The matrix of a mesh that moves or has dead entities, starts of the search, and the share of motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "elasticity/problems.hpp"

namespace taut {
namespace {

using test::built_grid;
using test::constraints_of;
using test::error_of;

Constraint<Vec3> tilted(const Vec3& p) {
  return test::is_on_cube(p) ? prescribed(Vec3{p[1] * p[1], 0.3 * p[0], p[0] * p[2]}) : Constraint<Vec3>{};
}

Constraint<double> share_at(const Vec3& p) {
  return p[0] == 0 || p[0] == 1 ? prescribed(p[0]) : Constraint<double>{};
}

TEST(VertexGraph, HasTheEdgesOfTheMesh) {
  const TetMesh mesh = built_grid(3);
  const VertexGraph graph(mesh);
  EXPECT_EQ(graph.size(), mesh.vertices.size());
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const auto columns = graph.columns(i);
    EXPECT_EQ(columns[0], i);
    EXPECT_EQ(std::set(columns.begin(), columns.end()).size(), columns.size());
    for (const std::uint32_t j : columns) {
      const auto back = graph.columns(j);
      EXPECT_NE(std::find(back.begin(), back.end(), i), back.end());
    }
    for (const auto& use : graph.uses(i))
      for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(columns[use.place[k]], mesh.tets[use.tet].v[k]);
  }
  // 3 n (n + 1)^2 along the axes, 3 n^2 (n + 1) across squares, n^3 across boxes.
  EXPECT_EQ(graph.entry_count(), 64 + 2 * (144 + 108 + 27));
}

TEST(VertexSystem, IsSymmetricToTheBit) {
  const TetMesh mesh = built_grid(4);
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, {1.5}));
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    for (std::size_t e = 0; e < system.row(i).size(); ++e) {
      const std::uint32_t j = graph.columns(i)[e];
      const auto back = graph.columns(j);
      const auto& transposed = system.row(j)[std::find(back.begin(), back.end(), i) - back.begin()];
      for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(system.row(i)[e][k], transposed[3 * (k % 3) + k / 3]);
    }
}

TEST(VertexSystem, KeepsItsPatternWhileVerticesMove) {
  TetMesh mesh = built_grid(5, 0);
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, {1}));
  const auto constraints = constraints_of<Vec3>(mesh, tilted);
  for (Vertex& v : mesh.vertices) v.x = v.x + Vec3{0.1 * v.x[1] * v.x[1], 0.05 * std::sin(9 * v.x[0]), 0};
  system.assemble(elements_of(mesh, {1}));
  const auto kept = system.solve(constraints);
  const VertexGraph new_graph(mesh);
  ElasticSystem new_system(new_graph);
  new_system.assemble(elements_of(mesh, {1}));
  EXPECT_EQ(kept.values, new_system.solve(constraints).values);
}

// Half of the mesh dies, and more ids than that are dead.
TEST(VertexSystem, IgnoresDeadEntities) {
  TetMesh mesh = built_grid(4);
  const auto is_left = [&](const Tet& t) {
    return std::ranges::all_of(t.v, [&](auto v) { return mesh.x(v)[0] < 0.7; });
  };
  std::fill(mesh.tet_of_vertex.begin(), mesh.tet_of_vertex.end(), TetId{none});
  for (const TetId t : mesh.tet_ids()) {
    if (!is_left(mesh.tets[t])) {
      mesh.tets[t] = Tet{};
      continue;
    }
    for (const VertexId v : mesh.tets[t].v) mesh.tet_of_vertex[v] = t;
  }
  mesh.resize_vertices(mesh.vertices.size() + 3);
  mesh.resize_tets(mesh.tets.size() + 5);
  const auto affine = [](const Vec3& p) { return Vec3{p[1], 0.2 * p[0] - p[2], 0.5 * p[0]}; };
  std::size_t dead = 0;
  auto constraints = constraints_of<Vec3>(mesh, [&](const Vec3& p) {
    return p[0] >= 0.5 || test::is_on_cube(p) ? prescribed(affine(p)) : Constraint<Vec3>{};
  });
  std::vector<Vec3> start(mesh.vertices.size(), {1, 2, 3});
  for (const VertexId v : mesh.vertex_ids())
    if (!mesh.is_vertex_alive(v)) {
      mesh.vertices[v].x = start[v] = Vec3{std::nan(""), 0, 0};
      if (++dead % 2 == 0) constraints[v] = prescribed(start[v]);
    }
  EXPECT_GT(dead, 25U);
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, {}));
  for (const auto kind :
       {Preconditioner::two_level, Preconditioner::block_jacobi, Preconditioner::incomplete_cholesky}) {
    const auto u = system.solve(constraints, start, {{.residual = 1e-13}, kind});
    EXPECT_TRUE(u.converged);
    EXPECT_LT(error_of<Vec3>(mesh, u.values, affine), 1e-11);
    for (const VertexId v : mesh.vertex_ids()) EXPECT_TRUE(mesh.is_vertex_alive(v) || u.values[v] == Vec3{});
  }
}

TEST(VertexSystem, GoesOnFromAStart) {
  const TetMesh mesh = built_grid(8);
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, {}));
  const auto constraints = constraints_of<Vec3>(mesh, tilted);
  const auto cold = system.solve(constraints);
  EXPECT_GT(cold.convergence.iterations, 10);
  EXPECT_EQ(system.solve(constraints, cold.values).convergence.iterations, 0);
  auto near = cold.values;
  for (Vec3& u : near) u = 1.001 * u;
  const auto warm = system.solve(constraints, near);
  EXPECT_LT(warm.convergence.iterations, cold.convergence.iterations);
  for (std::size_t i = 0; i < near.size(); ++i) EXPECT_LT(norm(warm.values[i] - cold.values[i]), 1e-7);
}

TEST(VertexSystem, WithoutDisplacementsNothingMoves) {
  const TetMesh mesh = built_grid(4);
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, {}));
  const std::vector<Vec3> start(graph.size(), {1, 2, 3});
  const auto u = system.solve(
      constraints_of<Vec3>(mesh,
                           [](const Vec3& p) { return test::is_on_cube(p) ? prescribed(Vec3{}) : Constraint<Vec3>{}; }),
      start);
  EXPECT_TRUE(u.converged);
  EXPECT_EQ(u.values, std::vector<Vec3>(graph.size()));
}

TEST(ShareOfMotion, IsLinearInASlab) {
  const TetMesh mesh = built_grid(6);
  const VertexGraph graph(mesh);
  ShareSystem system(graph);
  system.assemble(elements_of(mesh, {}));
  for (const auto kind :
       {Preconditioner::two_level, Preconditioner::block_jacobi, Preconditioner::incomplete_cholesky}) {
    const auto share = system.solve(constraints_of<double>(mesh, share_at), {}, {{.residual = 1e-13}, kind});
    EXPECT_TRUE(share.converged);
    EXPECT_LT(error_of<double>(mesh, share.values, [](const Vec3& p) { return p[0]; }), 1e-11);
  }
}

// In a slab, weights times slopes are uniform.
TEST(ShareOfMotion, StiffeningMovesSmallElementsTogether) {
  TetMesh mesh = built_grid(6, 0);
  for (Vertex& v : mesh.vertices) v.x[0] = v.x[0] <= 0.5 ? 0.5 * v.x[0] : 0.25 + 1.5 * (v.x[0] - 0.5);
  const VertexGraph graph(mesh);
  ShareSystem system(graph);
  system.assemble(elements_of(mesh, {1}));
  const auto share = system.solve(constraints_of<double>(mesh, share_at), {}, {{.residual = 1e-13}});
  const auto expected = [](const Vec3& p) { return p[0] <= 0.25 ? 0.4 * p[0] : 0.1 + 1.2 * (p[0] - 0.25); };
  EXPECT_LT(error_of<double>(mesh, share.values, expected), 1e-11);
}

}  // namespace
}  // namespace taut
