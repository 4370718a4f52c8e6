// The geometry of a mesh whose boundary has moved.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/carry.hpp"
#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Fits the planes and lines on which a vertex has moved (`has_moved` is not 0) to where their vertices lie now.
/// Curved patches and lines that have moved rigidly as a whole are carried along, the places of corners with their
/// vertices. A patch that is not planar any more, or is curved and has moved otherwise, is frozen, a line likewise;
/// their vertices stay from then on.
void refit(Model& model, TetMesh& mesh, const std::vector<std::uint8_t>& has_moved, const RigidMoves& rigid);

}  // namespace taut
