// Where a point lies in a mesh.
#pragma once

#include <array>

#include "taut/mesh.hpp"

namespace taut {

/// Where a point of one mesh lies in another: what interpolates any field from the other to the point.
struct Host {
  Index tetrahedron = 0;            ///< of the other mesh
  std::array<double, 4> weights{};  ///< of its four points in their order: none negative, of sum 1
};

}  // namespace taut
