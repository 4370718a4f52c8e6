// Curved patches and lines that move rigidly with their bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/model.hpp"
#include "mesh/tet_mesh.hpp"

namespace taut {

/// Which vertices have moved rigidly, and how.
struct RigidMoves {
  std::vector<RigidMotion> motions{};      ///< each once
  std::vector<std::uint32_t> of_vertex{};  ///< which motion; `none` for those that stayed or moved otherwise
};

/// Patches and lines, marked with 1.
struct Carried {
  std::vector<std::uint8_t> patch, line;
};

/// Moves with them each curved patch all of whose vertices have moved by the same motion, each bent line all of whose
/// patches have. Returns these patches and lines. Without any rigid moves, nothing happens.
Carried carry(Model& model, const TetMesh& mesh, const RigidMoves& moves);

}  // namespace taut
