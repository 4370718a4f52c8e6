// The geometry of a mesh whose boundary has moved.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Fits the planes and lines on which a vertex has moved (`has_moved` is not 0) to where their vertices lie now. A
/// patch that is not planar any more, or was curved, is frozen, a line that is not straight any more likewise; their
/// vertices stay from then on.
void refit(Model& model, TetMesh& mesh, const std::vector<std::uint8_t>& has_moved);

}  // namespace taut
