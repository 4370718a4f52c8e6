// The surface that the triangles of a mesh stand for, and what it says of their edges.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/build.hpp"
#include "surface/reference_surface.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Of a freshly built mesh, with its ids.
class Reference {
public:
  /// With ridges by `angle` in degrees or, without it, by the shape of the surface (surface/ridges.hpp).
  Reference(const Mesh& input, const Built& built, std::optional<double> angle);

  [[nodiscard]] const std::shared_ptr<const ReferenceSurface>& surface() const { return surface_; }

  /// The curve of the edge, whose vertices are ascending; `none` if the surface is smooth there.
  [[nodiscard]] LineId curve_of(const std::array<VertexId, 2>& edge) const;
  [[nodiscard]] bool is_planar(TriangleId t) const { return planar_[surface_->patch_of(t)] != 0; }
  [[nodiscard]] bool is_straight(LineId curve) const { return straight_[curve] != 0; }
  /// Whether the triangle of the mesh has the sense of the reference's.
  [[nodiscard]] bool has_sense_of(const TetMesh& mesh, TriangleId t) const;

private:
  std::shared_ptr<const ReferenceSurface> surface_;
  std::vector<std::pair<std::array<VertexId, 2>, LineId>> ridges_;  // ascending
  std::vector<std::uint8_t> planar_, straight_;
};

}  // namespace taut
