// The surface that the triangles of a mesh stand for, and what it says of them and of their edges.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/match_curves.hpp"
#include "geometry/match_patches.hpp"
#include "geometry/model.hpp"
#include "mesh/build.hpp"
#include "surface/reference_surface.hpp"
#include "surface/surface_edges.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// Of a freshly built mesh, with its ids.
class Reference {
public:
  /// Made from the mesh, with ridges by `angle` in degrees or, without it, by the shape of the surface
  /// (surface/ridges.hpp).
  Reference(const Mesh& input, const Built& built, std::optional<double> angle);

  /// Made from another mesh. `built` has patches by angle, which are those in `patches`; `uses` are of its edges.
  /// Throws InputError where the mesh does not match the surface.
  Reference(std::shared_ptr<const ReferenceSurface> given, const Mesh& input, const Built& built,
            const std::vector<Patch>& patches, const std::vector<EdgeUse>& uses);

  [[nodiscard]] const std::shared_ptr<const ReferenceSurface>& surface() const { return surface_; }

  /// The patch on which a triangle of the mesh lies; `none` for one on a plane that the surface does not hold.
  [[nodiscard]] PatchId patch_of(TriangleId t) const { return matches_[t].patch; }
  /// 1 if the triangle of the mesh has the sense of its patch, or -1.
  [[nodiscard]] double sense_of(TriangleId t) const { return matches_[t].sense; }
  /// The curve of the edge, whose vertices are ascending; `none` if the surface is smooth there.
  [[nodiscard]] LineId curve_of(const std::array<VertexId, 2>& edge) const;
  [[nodiscard]] std::span<const CornerMatch> corners() const { return corners_; }

  /// Whether the triangle lies on no patch, or on one that is planar.
  [[nodiscard]] bool is_planar(TriangleId t) const { return patch_of(t) == none || planes_[patch_of(t)].has_value(); }
  /// Whether the mesh may take its own plane for the patch of this triangle.
  [[nodiscard]] bool is_in_plane(TriangleId t) const { return in_plane_[t] != 0; }
  [[nodiscard]] bool is_straight(LineId curve) const { return straight_[curve] != 0; }

private:
  void find_planes();
  void find_straight_curves();

  std::shared_ptr<const ReferenceSurface> surface_;
  std::vector<PatchMatch> matches_;  // by triangle of the mesh
  std::vector<CurveMatch> ridges_;   // ascending
  std::vector<CornerMatch> corners_;
  std::vector<std::optional<Plane>> planes_;  // by patch of the surface
  std::vector<std::uint8_t> in_plane_;        // by triangle of the mesh
  std::vector<std::uint8_t> straight_;        // by curve
};

}  // namespace taut
