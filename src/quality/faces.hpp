// The faces of tetrahedra, in an order that brings equal ones together.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A face by its vertices in ascending order, and the tetrahedron or triangle it comes from.
struct Face {
  std::array<VertexId, 3> vertices;
  Index source;
  auto operator<=>(const Face&) const = default;
};

/// All four faces of each tetrahedron, sorted; a face of two tetrahedra occurs twice. Indices below `vertices`.
[[nodiscard]] std::vector<Face> faces_of(std::span<const std::array<Index, 4>> tets, std::size_t vertices);

/// The triangles as faces, sorted.
[[nodiscard]] std::vector<Face> faces_of(std::span<const std::array<Index, 3>> triangles);

}  // namespace taut
