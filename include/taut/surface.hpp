// What may change on surfaces.
#pragma once

namespace taut {

/// What may change on the boundary and on the faces between regions.
enum class Surface {
  /// All patches are remeshed. Vertices stay on the curved surface that the input's triangles stand for (Geometry).
  adapt,
  planar,  ///< planar patches are remeshed; patches that are not planar are kept as they are
  fixed,   ///< every triangle of the input is kept as it is
};

}  // namespace taut
