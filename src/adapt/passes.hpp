// The four passes of the adaptation loop (Dobrzynski and Frey 2008, 4.2), each over what has changed since it was last
// looked at.
#pragma once

#include "adapt/tally.hpp"
#include "cavity/collapse.hpp"
#include "cavity/insertion.hpp"
#include "cavity/kernel.hpp"
#include "cavity/relocation.hpp"
#include "cavity/repair.hpp"
#include "cavity/swap.hpp"

namespace taut {

/// Splits the longest edge of each tetrahedron that has one longer than sqrt 2.
void insertion_pass(Kernel& kernel, const InsertionRules& rules, Tally& tally);

/// Collapses edges shorter than 1/sqrt 2.
void collapse_pass(Kernel& kernel, const CollapseRules& rules, Tally& tally);

/// Swaps edges and faces of the tetrahedra whose 1/Q is not above rules.good_enough.
void swap_pass(Kernel& kernel, const SwapRules& rules, Tally& edges, Tally& faces);

/// Mends the few tetrahedra that the other passes leave bad.
void repair_pass(Kernel& kernel, const RepairRules& rules, Tally& tally);

/// Moves each restless vertex once.
void relocation_pass(Kernel& kernel, const RelocationRules& rules, Tally& tally);

}  // namespace taut
