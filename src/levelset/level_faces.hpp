// The part of a level set that consists of faces of the mesh.
#pragma once

#include <vector>

#include "levelset/level_field.hpp"

namespace taut {

/// The faces whose three values are the level, with values below it on exactly one of their two sides, in ascending
/// order of their vertices. Throws InputError if more than two tetrahedra share such a face, or if one at it is flat.
[[nodiscard]] std::vector<CrossingTriangle> level_faces(const LevelField& field);

}  // namespace taut
