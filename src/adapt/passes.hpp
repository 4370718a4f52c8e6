// The passes of the adaptation loop (Dobrzynski and Frey 2008, 4.2), each over what has changed since it was last
// looked at.
#pragma once

#include <span>
#include <vector>

#include "adapt/tally.hpp"
#include "operators/collapse.hpp"
#include "operators/insertion.hpp"
#include "operators/kernel.hpp"
#include "operators/relocation.hpp"
#include "operators/repair.hpp"
#include "operators/swap.hpp"

namespace taut {

/// What the kernel's block may need. Measures the edges not measured yet.
[[nodiscard]] IdNeed needed_ids(Kernel& kernel);

/// Splits the longest edge of each tetrahedron that has one longer than sqrt 2. Those with a much longer one that
/// reaches beyond the block are added to `stuck`.
void insertion_pass(Kernel& kernel, const InsertionRules& rules, std::vector<TetId>& stuck, Tally& tally);

/// The same for tetrahedra that no block can split: were it left undone, all would be refined around one long edge,
/// which then reaches through several blocks wherever these are cut. The kernel's block is the whole mesh.
void split_stuck(Kernel& kernel, const InsertionRules& rules, std::span<const TetId> stuck, Tally& tally);

/// Collapses edges shorter than 1/sqrt 2.
void collapse_pass(Kernel& kernel, const CollapseRules& rules, Tally& tally);

/// Swaps edges and faces of the tetrahedra whose 1/Q is not above rules.good_enough.
void swap_pass(Kernel& kernel, const SwapRules& rules, Tally& tally);

/// Mends the few tetrahedra that the other passes leave bad.
void repair_pass(Kernel& kernel, const RepairRules& rules, Tally& tally);

/// The same for the whole mesh, which is the kernel's block: the last word, also where seams were when the rounds
/// ended.
void mend(Kernel& kernel, const RepairRules& rules, Tally& tally);

/// Moves each restless vertex once.
void relocation_pass(Kernel& kernel, const RelocationRules& rules, Tally& tally);

}  // namespace taut
