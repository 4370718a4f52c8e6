// One part of a step: how far the vertices can go, and their going there.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesh/tet_mesh.hpp"

namespace taut {

/// Where the vertices are after a share of the motion.
using Places = std::function<std::vector<Vec3>(double share)>;

/// A share of the motion that leaves all tetrahedra positive.
struct Reach {
  double share = 0;                   ///< 0 if there is none among those tried
  std::vector<Vec3> places;           ///< after it, by vertex
  std::optional<TetId> in_the_way{};  ///< the first that would not be positive after the smallest share refused
};

/// Tries `most`, then halves, down to the share `smallest`; below that, down to a millionth, as long as an edge of a
/// tetrahedron in the way changes by more than `smallest` of an edge of the metric.
[[nodiscard]] Reach reach_of(const TetMesh& mesh, const Places& places, double most, double smallest);

}  // namespace taut
