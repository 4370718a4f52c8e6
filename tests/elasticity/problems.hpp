// Meshes, constraints and fields for tests of elasticity.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "elasticity/vertex_system.hpp"
#include "mesh/build.hpp"
#include "mesh/shapes.hpp"

namespace taut::test {

inline TetMesh built_grid(Index n, double shake = 0.2) {
  Mesh mesh = grid(n);
  jitter(mesh, shake / n, 1);
  return build(mesh).mesh;
}

inline bool is_on_cube(const Vec3& p) {
  return std::ranges::any_of(p, [](double c) { return c == 0 || c == 1; });
}

/// What constraint_at says of each vertex.
template <class Value>
std::vector<Constraint<Value>> constraints_of(const TetMesh& mesh,
                                              const std::function<Constraint<Value>(const Vec3&)>& constraint_at) {
  std::vector<Constraint<Value>> constraints(mesh.vertices.size());
  for (const VertexId v : mesh.vertex_ids())
    if (mesh.is_vertex_alive(v)) constraints[v] = constraint_at(mesh.x(v));
  return constraints;
}

/// The largest distance to an expected field.
template <class Value>
double error_of(const TetMesh& mesh, const std::vector<Value>& values,
                const std::function<Value(const Vec3&)>& expected) {
  double worst = 0;
  for (const VertexId v : mesh.vertex_ids()) {
    if (!mesh.is_vertex_alive(v)) continue;
    const Value d = values[v] - expected(mesh.x(v));
    worst = std::max(worst, std::sqrt(dot(d, d)));
  }
  return worst;
}

struct Setting {
  Stiffening stiffening{};
  LinearElastic law{};
  SolveOptions options{.stop = {.residual = 1e-13}};
};

inline Solution<Vec3> displacement(const TetMesh& mesh, const std::vector<Constraint<Vec3>>& constraints,
                                   const Setting& setting = {}, const std::vector<Vec3>& loads = {}) {
  const VertexGraph graph(mesh);
  ElasticSystem system(graph);
  system.assemble(elements_of(mesh, setting.stiffening), setting.law);
  return system.solve(constraints, {}, setting.options, loads);
}

}  // namespace taut::test
