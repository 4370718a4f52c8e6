// Integrals and ranges of fields on a mesh.
#pragma once

#include <vector>

#include "taut/field.hpp"
#include "taut/mesh.hpp"
#include "transfer/values.hpp"

namespace taut {

/// Of one component on one mesh.
struct Measures {
  double mass = 0, least = 0, greatest = 0;
};

/// The volume, and by component the integral of the piecewise linear field and its range over the tetrahedra.
struct MeshMeasures {
  double volume = 0;
  std::vector<Measures> components;
};

/// `values` at the points of `mesh`.
[[nodiscard]] MeshMeasures measured(const Mesh& mesh, const Values& values);

}  // namespace taut
