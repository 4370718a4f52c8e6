// The surface that a boundary stands for: curved patches between curved ridges, made once from triangles.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/sym3.hpp"
#include "surface/reference_parts.hpp"
#include "surface/surface_input.hpp"

namespace taut {

/// A place on a patch.
struct OnPatch {
  Vec3 point{};
  Vec3 normal{};  ///< of unit length, in the sense of the triangles; that of this patch at a ridge
  TriangleId triangle = none;
  std::array<double, 3> weights{};  ///< of the triangle's corners
  double distance = 0;              ///< from the point that was asked for
  int visited = 0;                  ///< triangles that the search tried
  int iterations = 0;               ///< steps of Newton's method on the triangle that took the most
};

/// A place on a ridge curve.
struct OnCurve {
  Vec3 point{};
  Vec3 tangent{};        ///< of unit length, in the sense of the chain
  Index segment = 0;     ///< of the curve
  double parameter = 0;  ///< on the segment, from 0 to 1
  double distance = 0;   ///< from the point that was asked for
};

/// Immutable, so that all threads may ask at once. Vertices and triangles are those of the input, whose points lie on
/// the surface. It does not know where in space it is now: who moves it asks in its frame.
class ReferenceSurface {
public:
  /// Ridges and corners by `angle` in degrees, or by the shape of the surface (surface/ridges.hpp).
  ReferenceSurface(SurfaceInput input, std::optional<double> angle);

  [[nodiscard]] const std::vector<ReferencePatch>& patches() const { return patches_; }
  [[nodiscard]] const std::vector<ReferenceCurve>& curves() const { return curves_; }
  [[nodiscard]] const std::vector<ReferenceCorner>& corners() const { return corners_; }

  /// Where a vertex of the input lives: on a patch, on a curve, at a corner; in the volume if it is on no triangle.
  [[nodiscard]] Tag tag_of(VertexId v) const { return tags_[v]; }
  [[nodiscard]] PatchId patch_of(TriangleId t) const { return patch_of_[t]; }
  [[nodiscard]] const Facets& facets() const { return facets_; }
  [[nodiscard]] const CubicTriangle& cubic_of(TriangleId t) const { return cubics_[t]; }

  /// The point of the patch that is closest to x. A good guess, such as the triangle found for a point nearby, makes
  /// the search faster and does not change the answer.
  [[nodiscard]] OnPatch closest_on(PatchId patch, const Vec3& x, TriangleId guess = none) const;
  /// The same of all patches together.
  [[nodiscard]] OnPatch closest(const Vec3& x) const;
  /// The point of the curve that is closest to x. The guess is a segment of it.
  [[nodiscard]] OnCurve closest_on(LineId curve, const Vec3& x, Index guess = none) const;

  /// How far a flat facet is from the patch: the largest distance of its centre and of the middles of its edges.
  [[nodiscard]] double sag(PatchId patch, const std::array<Vec3, 3>& facet, TriangleId guess = none) const;
  /// How far a straight edge is from the curve: the distance of its middle.
  [[nodiscard]] double sag(LineId curve, const std::array<Vec3, 2>& edge, Index guess = none) const;

  /// The shape operator at a place: its eigenvalues are the principal curvatures, positive where the surface bends away
  /// from the normal as a sphere does, and about 0 for the normal. It is linear between those of jets at the corners of
  /// the triangle, which are one-sided at ridges.
  [[nodiscard]] Sym3 shape_operator(const OnPatch& at) const;

private:
  void set_tags();
  void search(PatchId patch, const Vec3& x, TriangleId guess, OnPatch& best) const;

  Facets facets_;
  std::vector<PatchId> patch_of_;                         ///< by triangle
  std::vector<CubicTriangle> cubics_;                     ///< by triangle
  std::vector<Sym3> shapes_;                              ///< by sector
  std::vector<std::array<std::uint32_t, 3>> sectors_of_;  ///< by triangle
  std::vector<ReferencePatch> patches_;
  std::vector<ReferenceCurve> curves_;
  std::vector<ReferenceCorner> corners_;
  std::vector<Tag> tags_;  ///< by vertex
};

}  // namespace taut
