// Hessians by averaging gradients twice.
#pragma once

#include <span>

#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// The gradient of a P1 field is constant in each tetrahedron; at a vertex it is the mean over its tetrahedra, weighted
/// by volume (the L2 projection with a lumped mass matrix, Clement's operator). The same again gives the Hessian, whose
/// symmetric part is taken. On the boundary, where this is of order 0, the means of the neighbours inside are taken.
[[nodiscard]] Tensors hessians_by_double_projection(const Mesh& mesh, std::span<const double> values);

}  // namespace taut
