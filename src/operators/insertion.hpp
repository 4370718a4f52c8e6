// A new vertex in the middle of an edge, by the anisotropic Delaunay kernel.
#pragma once

#include "operators/kernel.hpp"

namespace taut {

struct InsertionRules {
  double shortest_new_edge = 0.7;
  /// A new tetrahedron is too bad if its 1/Q is not above the smaller of these, the second times the worst that goes.
  double worst_quality = 0.1, share_of_old = 0.5;
};

/// Splits the edge if the cavity of its middle can be re-joined (Dobrzynski and Frey 2008, section 3): the cavity grows
/// from the shell over tetrahedra in conflict, loses those whose faces do not see the new vertex, and shrinks back to
/// the shell if it is refused. Marks the shell as tried.
Outcome insert_on_edge(Kernel& kernel, TetId t, int edge, const InsertionRules& rules);

}  // namespace taut
