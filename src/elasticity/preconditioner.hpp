// Preconditioners of a system with constraints.
#pragma once

#include <functional>
#include <span>

#include "elasticity/vertex_system.hpp"

namespace taut {

/// Sets z = M^-1 r where unknowns are free, zero elsewhere, and returns r.z. r is zero where unknowns are not free.
template <class Value>
using Precondition = std::function<double(std::span<const Value> r, std::span<Value> z)>;

template <class Value>
[[nodiscard]] Precondition<Value> block_jacobi(const VertexSystem<Value>& system,
                                               std::span<const Constraint<Value>> constraints);

/// These blocks, and an exact solution for groups of vertices that move as one. Empty if there is none.
template <class Value>
[[nodiscard]] Precondition<Value> two_level(const VertexSystem<Value>& system,
                                            std::span<const Constraint<Value>> constraints);

/// Of all rows in the order of the vertices, by Eigen. Empty if there is none.
template <class Value>
[[nodiscard]] Precondition<Value> incomplete_cholesky(const VertexSystem<Value>& system,
                                                      std::span<const Constraint<Value>> constraints);

}  // namespace taut
