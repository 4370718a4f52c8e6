// What is prescribed at a vertex.
#pragma once

#include "elasticity/algebra.hpp"

namespace taut {

/// The unknown is prescribed to be that of `value`, except in the directions in which it is free.
template <class Value>
struct Constraint {
  typename Algebra<Value>::Projector free = Algebra<Value>::all;
  Value value{};

  [[nodiscard]] Value prescribed() const { return value - free * value; }
};

template <class Value>
[[nodiscard]] Constraint<Value> prescribed(const Value& value) {
  return {{}, value};
}

/// No displacement along a direction of any length but zero: the vertex slides on a wall.
[[nodiscard]] inline Constraint<Vec3> sliding(const Vec3& normal) {
  return {identity3 + (-1 / dot(normal, normal)) * outer(normal), {}};
}

/// No displacement along two directions, which are not parallel: the vertex slides along the edge of two walls.
[[nodiscard]] inline Constraint<Vec3> sliding(const Vec3& one, const Vec3& other) {
  const Vec3 edge = cross(one, other);
  return {(1 / dot(edge, edge)) * outer(edge), {}};
}

}  // namespace taut
