// The passes of the adaptation loop (Dobrzynski and Frey 2008, 4.2). Each visits what has changed since its last visit.
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

/// The ids that the kernel's block may need if no vertex is inserted.
[[nodiscard]] IdNeed ids_for_swaps(const Kernel& kernel);

/// The ids that the kernel's block may need. Measures the edges that are not measured yet.
[[nodiscard]] IdNeed ids_for_insertion(Kernel& kernel);

/// Splits the longest edge of each tetrahedron if it is longer than sqrt 2. Tetrahedra with a much longer edge that
/// reaches beyond the block are added to `stuck`.
void insertion_pass(Kernel& kernel, const InsertionRules& rules, std::vector<TetId>& stuck, Tally& tally);

/// The same for tetrahedra that no block can split. Otherwise the mesh would be refined around a long edge, which then
/// reaches through several blocks at every cut. The kernel's block is the whole mesh.
void split_stuck(Kernel& kernel, const InsertionRules& rules, std::span<const TetId> stuck, Tally& tally);

/// Collapses edges shorter than 1/sqrt 2.
void collapse_pass(Kernel& kernel, const CollapseRules& rules, Tally& tally);

/// Swaps edges and faces of the tetrahedra with 1/Q up to rules.good_enough.
void swap_pass(Kernel& kernel, const SwapRules& rules, Tally& tally);

/// Repairs the few tetrahedra that are still bad after the other passes.
void repair_pass(Kernel& kernel, const RepairRules& rules, Tally& tally);

/// The same for the whole mesh, which is the kernel's block, after the last round: also repairs what was at the seams.
void mend(Kernel& kernel, const RepairRules& rules, Tally& tally);

/// Moves each restless vertex once.
void relocation_pass(Kernel& kernel, const RelocationRules& rules, Tally& tally);

}  // namespace taut
