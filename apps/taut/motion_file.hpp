// The file of `taut move --motion`: how the boundary moves.
//
//   {"bodies": [{"references": [7, 8], "translation": [0, 0, -0.1]},
//               {"references": [9], "rotation": {"centre": [0, 0, 0], "axis": [0, 0, 1], "degrees": 3.6}},
//               {"references": [5], "motions": [{"rotation": {...}}, {"translation": [...]}]},
//               {"references": [3], "displacements": "wing.solb"}],
//    "fixed": [1], "sliding": [2]}
//
// All amounts are those of one step. References are those of the mesh's triangles.
#pragma once

#include <filesystem>
#include <vector>

#include "taut/rigid_motion.hpp"

namespace taut::program {

/// A part of the boundary and how it moves: either by `motions` or by `displacements`.
struct MovingBody {
  std::vector<int> references;          ///< of the triangles that move; never empty
  std::vector<RigidMotion> motions;     ///< of one step each, the first is done first; empty if displacements are given
  std::filesystem::path displacements;  ///< a solution file with one vector per vertex and step; empty if none is given

  /// Where the body is after `steps` steps, which need not be whole, from where it began. Each motion is done that many
  /// times before the next: with a rotation before a translation, the axis travels along, as that of a wheel does; with
  /// the translation first, the body moves away from an axis that stays. The identity without motions.
  [[nodiscard]] RigidMotion place_after(double steps) const;
};

/// What moves and what does not. No reference occurs twice. Triangles of other references stay fixed.
struct MotionFile {
  std::vector<MovingBody> bodies;  ///< at least one
  std::vector<int> fixed;          ///< references of triangles whose vertices stay where they are
  std::vector<int> sliding;        ///< references of triangles whose vertices may move within the surface
};

/// Throws InputError, which names the file and the place in it, for what is not as above: unknown keys, wrong types,
/// references given twice. The name of a file with displacements is relative to the folder of `file`; whether there is
/// such a file is not checked.
[[nodiscard]] MotionFile read_motion(const std::filesystem::path& file);

}  // namespace taut::program
