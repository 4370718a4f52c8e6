// The integrals over the intersection of two tetrahedra.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "transfer/polyhedron.hpp"
#include "transfer/tet_frame.hpp"

namespace taut {

using Matrix4 = std::array<Weights4, 4>;

/// Integrals of products of weights over the intersection of a target and a source tetrahedron. They are exact but for
/// rounding, and no term is negative.
struct Overlap {
  Matrix4 target_source{};  ///< by a weight in the target and one in the source
  Matrix4 target_target{};  ///< by two weights in the target
  double volume = 0;
  std::array<bool, 4> reaches{};  ///< the faces of the source that a face of the intersection lies on
};

/// None if the intersection is empty or thinner than rounding can tell.
[[nodiscard]] std::optional<Overlap> overlap(const TetFrame& target, const std::array<Vec3, 4>& source);

}  // namespace taut
