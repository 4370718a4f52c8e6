// What stops bodies that move.
#pragma once

#include <map>

#include "adapt/session.hpp"
#include "taut/motion.hpp"

namespace taut {

/// By reference of triangles. Those of any other reference stay where they are.
using MotionOfReference = std::map<int, RigidMotion>;

/// What is in the way of a tetrahedron that would turn over. `mesh` is the session's. Without motions, in a step in
/// which the caller moves points, each reference counts as a body.
[[nodiscard]] Obstacle obstacle_at(TetId tet, const Session& session, const Mesh& mesh,
                                   const MotionOfReference& motions);

}  // namespace taut
