// Sizes that are wanted at parts of a mesh, which are named by their references.
#pragma once

#include <limits>
#include <map>

#include "taut/export.hpp"
#include "taut/mesh.hpp"
#include "taut/metric.hpp"

namespace taut {

/// What is wanted at the points of all entities of one reference. All lengths are in the unit of the mesh.
struct LocalSize {
  double size = std::numeric_limits<double>::infinity();  ///< above 0: sizes are at most this
  double min = 0;                                         ///< 0 or more: smaller sizes become this
  double max = std::numeric_limits<double>::infinity();   ///< above 0: larger sizes become this
  /// Of triangles only, 0 or more: wanted distance between the triangles and the curved surface there; 0: whatever the
  /// metric asks for. Sizes are those of curvature_metric() for half of it, as with AdaptOptions::deviation, which also
  /// refuses operations that would exceed it.
  double deviation = 0;
};

/// What is wanted where, by the references of the entities. Missing triangles of the boundary and between regions have
/// the reference 0, as all entities have whose array of references is empty.
struct LocalSizes {
  std::map<int, LocalSize> points{};      ///< by Mesh::point_refs
  std::map<int, LocalSize> edges{};       ///< by Mesh::edge_refs
  std::map<int, LocalSize> triangles{};   ///< by Mesh::triangle_refs
  std::map<int, LocalSize> tetrahedra{};  ///< by Mesh::tetrahedron_refs
  double ridge_angle = 45;                ///< degrees, as in CurvatureOptions, for deviations

  /// Whether nothing is wanted anywhere.
  [[nodiscard]] bool empty() const {
    return points.empty() && edges.empty() && triangles.empty() && tetrahedra.empty();
  }
};

/// The metric, one tensor for each point of `mesh`, with what is wanted locally: at the points of the entities that are
/// named it is intersected with all sizes and deviations, then `min` applies, then `max`. So `size` gives way to a
/// `min` of another entity, and `max` does not. Of several bounds at one point the largest `min` and the smallest `max`
/// count. Elsewhere tensors keep their bits; limited() with a gradation, or that of AdaptOptions, makes sizes grow from
/// there. Throws InputError that begins with "local sizes: " and names kind and reference, as in `triangles.3.size`,
/// for values that make no sense and for references that no entity has; others for a mesh and tensors that cannot be
/// used.
[[nodiscard]] TAUT_EXPORT Tensors with_local_sizes(const Mesh& mesh, Tensors metric, const LocalSizes& sizes);

}  // namespace taut
