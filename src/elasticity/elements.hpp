// Linear elements on the tetrahedra of a mesh where its vertices are now.
#pragma once

#include <array>
#include <span>

#include "base/raw_array.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Makes small elements stiff, so that large ones take up the deformation.
struct Stiffening {
  double exponent = 0;                      ///< chi: coefficients are divided by (volume / largest volume)^chi
  std::span<const double> factor_of_tet{};  ///< multiplies the coefficients too; empty for 1 everywhere
};

struct Element {
  std::array<Vec3, 4> gradient;  ///< of each vertex' weight; they add up to zero
  double weight;                 ///< volume times the factor of the coefficients
};

/// By tetrahedron. The one of a dead tetrahedron is not set. Where a volume is rounding, as it may be of a sliver that
/// is exactly positive, the element is that of a flat tetrahedron a little thicker.
[[nodiscard]] RawArray<Element> elements_of(const TetMesh& mesh, const Stiffening& stiffening);

}  // namespace taut
