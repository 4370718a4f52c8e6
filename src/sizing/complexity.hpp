// How many elements a metric asks for.
#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"
#include "taut/mesh.hpp"

namespace taut {

/// About how many tetrahedra a mesh has that is unit in the metric at the vertices of `mesh`: 10 per unit of
/// complexity, the integral of sqrt(det M) (measured; regular tetrahedra of unit edges would be 8.5). The metric is
/// taken at the middle of each tetrahedron, log-Euclidean, so that one small size at a vertex does not count for all
/// around it.
[[nodiscard]] double expected_tetrahedra(const TetMesh& mesh);

/// A quarter of the volume of the tetrahedra at each point: the weights with which values at the points are summed to
/// the integral of the field that is linear between them.
[[nodiscard]] std::vector<double> volumes_of_points(const Mesh& mesh);

}  // namespace taut
