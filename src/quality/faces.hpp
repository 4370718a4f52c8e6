// The faces of tetrahedra, in an order that brings equal ones together.
#pragma once

#include <array>
#include <span>

#include "base/buckets.hpp"
#include "base/ids.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// A face by its vertices in ascending order, and the tetrahedron or triangle it comes from.
struct Face {
  std::array<VertexId, 3> vertices;
  Index source;
  auto operator<=>(const Face&) const = default;
};

/// All four faces of each tetrahedron by their smallest vertex, those of one vertex sorted; a face of two tetrahedra
/// occurs twice. Indices below `vertices`.
[[nodiscard]] Buckets<Face> faces_of(std::span<const std::array<Index, 4>> tets, std::size_t vertices);

/// The triangles as faces, likewise.
[[nodiscard]] Buckets<Face> faces_of(std::span<const std::array<Index, 3>> triangles, std::size_t vertices);

}  // namespace taut
