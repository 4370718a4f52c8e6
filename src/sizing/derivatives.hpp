// Derivatives of a field at the points of a mesh.
#pragma once

#include <span>
#include <vector>

#include "sizing/quadratic_fit.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Those of the quadratic functions that fit the values within two edges of each point best, or more if these do not
/// determine one; zero at points that belong to no tetrahedron. Throws InputError if the mesh is too small.
[[nodiscard]] std::vector<Derivatives> derivatives_of(const Mesh& mesh, std::span<const double> values);

}  // namespace taut
