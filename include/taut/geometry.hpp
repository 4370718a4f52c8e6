// The curved surface that the triangles of a mesh stand for.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "taut/export.hpp"
#include "taut/mesh.hpp"

namespace taut {

class ReferenceSurface;

/// How a surface is parted into smooth patches.
struct GeometryOptions {
  /// Degrees, between 0 and 180: an edge is a ridge if the normals of its two triangles differ by this or more, and a
  /// ridge has a corner where it turns by this or more. Without it the shape of the surface decides: see Geometry.
  std::optional<double> ridge_angle{};
};

/// Where a surface is closest to a point.
struct ClosestPoint {
  Point point{};                    ///< on the surface
  Point normal{};                   ///< of unit length, in the sense of the triangles; at a ridge that of one side
  double distance = 0;              ///< from the point that was asked for to `point`
  Index triangle = 0;               ///< of the mesh that the surface was made from; missing triangles come after these
  std::array<double, 3> weights{};  ///< of the corners of the triangle, as parameters of the curved patch over it
  int reference = 0;                ///< of the triangle
  /// Ascending, 1 over length: the principal curvatures, positive where the surface bends away from the normal as a
  /// sphere does.
  std::array<double, 2> curvatures{};
  std::array<Point, 2> directions{};  ///< of these, of unit length
};

/// A smooth surface through the points of a mesh, made once and never changed: what a boundary is adapted to, however
/// often its triangles are replaced. Copies are cheap and share it; any number of threads may ask at a time.
///
/// The surface is parted into patches at ridges. These are: edges where triangles of different reference meet, or other
/// than two; edges of the mesh that are marked as ridges; edges by angle. Without an angle, an edge is a
/// ridge if the normals of its triangles differ by more than 15 degrees, and those of quadrics that are fitted to the
/// surface on either side alone do too, by more than 0.6 of that. So coarse meshes of spheres, up to 35 degrees an
/// edge, have no ridges, and roofs of 20 degrees have one. For edges of the mesh that are not marked, 5 degrees
/// suffice; the seams that meshers write into smooth surfaces are none. Corners are where ridges end, meet, change
/// their reference or turn sharply, the mesh's corners and required points on ridges, and the apexes of cones.
///
/// Normals are those of polynomials of degree 2 to 4, fitted to the points around on the same side of all ridges
/// (Cazals and Pouget 2005), in the frame of Max's normals (Max 1999). Over each triangle there is a cubic patch
/// (Vlachos et al. 2001, with handles that are exact on circles), over each edge of a ridge a cubic curve that both
/// sides share. The surface is continuous; straight ridges and planar patches are straight and planar. On a mesh of n
/// edges a radian its distance from the true surface falls with the third to fourth power of n.
class TAUT_EXPORT Geometry {
public:
  /// From the triangles of `mesh`, and those that are missing on the boundary of its tetrahedra and between its
  /// regions; it need not have tetrahedra. Throws InputError for a mesh that cannot be used or has no triangles, for a
  /// triangle two corners of which lie at one place, and for an angle out of range.
  explicit Geometry(const Mesh& mesh, const GeometryOptions& options = {});

  /// The point of the surface that is closest to x. Throws InputError for coordinates that are not finite.
  [[nodiscard]] ClosestPoint closest(const Point& x) const;

  [[nodiscard]] std::size_t patches() const;  ///< number of smooth parts
  [[nodiscard]] std::size_t ridges() const;   ///< number of smooth curves between corners, and closed ones
  [[nodiscard]] std::size_t corners() const;  ///< number of corners

  /// What the library itself works with.
  [[nodiscard]] const ReferenceSurface& surface() const { return *surface_; }
  /// The same, to keep.
  [[nodiscard]] const std::shared_ptr<const ReferenceSurface>& shared_surface() const { return surface_; }

private:
  std::shared_ptr<const ReferenceSurface> surface_;
};

}  // namespace taut
