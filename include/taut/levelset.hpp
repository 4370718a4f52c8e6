// Level sets of fields on a mesh.
#pragma once

#include <span>
#include <vector>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/surface_mesh.hpp"

namespace taut {

/// A place on an edge of a mesh, or at one of its points.
struct EdgePoint {
  Index first = 0;    ///< index of a point of the mesh
  Index second = 0;   ///< the same as `first` if the place is that point, larger otherwise
  double weight = 0;  ///< of `second`; that of `first` is 1 - weight
};

/// Where a field takes a value.
struct Isosurface {
  SurfaceMesh surface;              ///< normals point to larger values
  std::vector<EdgePoint> on_edges;  ///< where in the mesh each point lies: what interpolates any other field
};

/// The surface on which the field takes the value `level`. The field is given at the points of `mesh` and linear on
/// each tetrahedron; then so is the surface: this is where the field takes the value, exact but for rounding.
///
/// The surface is the boundary of the part of the mesh where values are below the level, without what lies on the
/// boundary of the mesh. It is conforming: each of its edges inside the mesh belongs to two triangles, or to a larger
/// even number where parts of the surface touch along an edge of the mesh. So it is closed if it does not reach the
/// boundary of the mesh. No triangle repeats a point and none occurs twice. Triangles can be as thin as the values at
/// points next to the surface are close to the level.
///
/// Points of the mesh whose value is the level are points of the surface. A face whose three values are the level is a
/// triangle of the surface if values are below the level on exactly one of its sides. The other side may be a
/// tetrahedron on which the field is the level everywhere: the surface is the lower end of such a plateau.
///
/// Throws InputError if the mesh cannot be used, a value or the level is not finite, there is not one value for each
/// point, or a tetrahedron at the surface is flat. Inverted tetrahedra are no error.
[[nodiscard]] TAUT_EXPORT Isosurface isosurface(const Mesh& mesh, std::span<const double> values, double level = 0);

}  // namespace taut
