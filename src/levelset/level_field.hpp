// A field on a mesh and one of its values.
#pragma once

#include <array>
#include <span>

#include "base/vec3.hpp"
#include "levelset/cut_table.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A point of a level set by the points of the mesh between which it lies, the smaller first; twice the same for a
/// point of the mesh whose value is the level.
using Crossing = std::array<Index, 2>;

/// A triangle of a level set.
using CrossingTriangle = std::array<Crossing, 3>;

struct LevelField {
  const Mesh& mesh;
  std::span<const double> values;  ///< at the points of the mesh
  double level;

  [[nodiscard]] int sign(Index v) const { return (values[v] > level) - (values[v] < level); }
  [[nodiscard]] Signs signs(const std::array<Index, 4>& v) const {
    return {sign(v[0]), sign(v[1]), sign(v[2]), sign(v[3])};
  }

  /// The share of the second point. It depends on the edge alone, so that all tetrahedra at the edge agree.
  [[nodiscard]] double weight(const Crossing& c) const {
    const auto [i, j] = c;
    return i == j ? 0 : (level - values[i]) / (values[j] - values[i]);
  }
  [[nodiscard]] Vec3 position(const Crossing& c) const {
    const Vec3 &p = mesh.points[c[0]], &q = mesh.points[c[1]];
    return p + weight(c) * (q - p);
  }
};

}  // namespace taut
