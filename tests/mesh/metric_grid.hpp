// A working mesh with a metric, for tests that need no surface.
#pragma once

#include "mesh/build.hpp"
#include "mesh/grid.hpp"
#include "metric/random_metrics.hpp"

namespace taut::test {

/// The unit cube of n^3 boxes, stretched to the extent and perturbed, also on its surface, so that hardly any
/// coordinates are equal. The metric is constant.
inline TetMesh metric_grid(Index n, const Sym3& metric, const Vec3& extent = {1, 1, 1}) {
  Mesh input = grid(n);
  Random random(1);
  for (Point& p : input.points) {
    p = p + 0.15 / n * random.point();
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] *= extent[axis];
  }
  TetMesh mesh = build(input).mesh;
  for (Vertex& vertex : mesh.vertices) vertex.m = metric;
  return mesh;
}

/// The same with as many unit edges along each side as boxes.
inline TetMesh metric_grid(Index n) {
  return metric_grid(n, static_cast<double>(n * n) * identity3);
}

}  // namespace taut::test
