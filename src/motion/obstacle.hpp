// What stops bodies that move.
#pragma once

#include <map>
#include <span>

#include "adapt/session.hpp"
#include "motion/goal.hpp"
#include "taut/motion.hpp"

namespace taut {

/// By reference of triangles: a number of what moves them. The same number moves them alike; those without stay.
using Movers = std::map<int, std::size_t>;

/// Triangles of the reference bodies[i] do motion i of the goal. Where the caller moves points, each reference that has
/// some counts as moved by itself. `mesh` has the points and triangles.
[[nodiscard]] Movers movers_of(const Goal& goal, std::span<const int> bodies, const Mesh& mesh);

/// What is in the way of a tetrahedron of the session that would turn over. `mesh` is the session's.
[[nodiscard]] Obstacle obstacle_at(TetId tet, const Session& session, const Mesh& mesh, const Movers& movers);

}  // namespace taut
