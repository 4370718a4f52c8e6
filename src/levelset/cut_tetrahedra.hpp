// The part of a level set inside tetrahedra.
#pragma once

#include <vector>

#include "levelset/level_field.hpp"

namespace taut {

/// The triangles in all tetrahedra that have vertices on both sides of the level, in the order of the tetrahedra.
/// Throws InputError if one of these is flat.
[[nodiscard]] std::vector<CrossingTriangle> cut_tetrahedra(const LevelField& field);

}  // namespace taut
