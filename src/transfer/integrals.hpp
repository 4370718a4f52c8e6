// What each target tetrahedron receives from the source mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "locate/places.hpp"
#include "transfer/values.hpp"

namespace taut {

/// By target tetrahedron: integrals over the part of it that the source covers, and what the source's values there are.
struct Integrals {
  /// One target tetrahedron. `n` numbers in a row each, one for each component.
  struct View {
    const double* mass;      ///< 10: the integrals of weight i times weight k, by `pair_of`
    const double* volumes;   ///< 4: the integrals of the weights
    const double* moments;   ///< 4 n: the integrals of weight i times the field
    const double* least;     ///< n: least value at the vertices of the source tetrahedra that it overlaps
    const double* greatest;  ///< n
  };

  /// Where weights i and k are among the 10 products.
  static constexpr std::array<std::array<std::size_t, 4>, 4> pair_of = {
      {{0, 1, 2, 3}, {1, 4, 5, 6}, {2, 5, 7, 8}, {3, 6, 8, 9}}};

  std::size_t components = 0;
  std::size_t overlaps = 0;  ///< pairs of tetrahedra
  double volume = 0;         ///< of all overlaps
  std::vector<double> all;   ///< by tetrahedron, in the order of a View

  [[nodiscard]] std::size_t stride() const { return 14 + 6 * components; }
  [[nodiscard]] View operator[](std::size_t tet) const {
    const double* at = &all[tet * stride()];
    return {at, at + 10, at + 14, at + 14 + 4 * components, at + 14 + 5 * components};
  }
};

/// `places` of the target's vertices in the source are where the searches begin. All overlaps are found: a target
/// tetrahedron that the source does not seem to cover is compared with every source tetrahedron near it.
[[nodiscard]] Integrals integrate(const Background& source, const Values& values, const Background& target,
                                  const std::vector<Place>& places);

}  // namespace taut
