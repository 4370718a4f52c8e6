// Insertion: a new vertex in the middle of an edge, by the anisotropic Delaunay kernel.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct InsertionRules {
  double shortest_new_edge = 0.7;
  /// A new tetrahedron is too bad unless its 1/Q is above `worst_quality`, or above `share_of_old` times the worst 1/Q
  /// that is removed.
  double worst_quality = 0.1, share_of_old = 0.5;
};

/// Splits the edge if the cavity of its midpoint can be connected to the new vertex (Dobrzynski and Frey 2008, section
/// 3). The cavity grows from the shell over tetrahedra in conflict, loses those whose faces do not see the new vertex,
/// and is reduced to the shell if it is refused. Marks the shell as tried.
Outcome insert_on_edge(Kernel& kernel, TetId t, int edge, const InsertionRules& rules);

/// The same with the new vertex at x, near the edge, or at the nearest place on its patch or line.
Outcome insert_on_edge(Kernel& kernel, TetId t, int edge, const Vec3& x, const InsertionRules& rules);

}  // namespace taut
