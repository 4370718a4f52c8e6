// The adaptation loop (Dobrzynski and Frey 2008, 4.2).
#pragma once

#include <cstddef>

#include "adapt/session.hpp"
#include "taut/adapt.hpp"

namespace taut {

/// Which passes a round makes. Without insertion and collapse no vertex comes or goes.
struct PassChoice {
  bool insertion = true, collapse = true, swap = true, repair = true, relocation = true;
};

struct RoundRules {
  int most = 40;                  ///< rounds; they end earlier when two in a row gain less than they cost
  std::size_t block_size = 8192;  ///< vertices; 0: the whole mesh is one block
  PassChoice passes{};
  int swap_period = 2;  ///< unless the mesh still grows, swaps come in every so many rounds, 1 or more
};

/// Repeats insertion, collapse, swaps, repair and relocation until the mesh is unit in its target, or `progress` says
/// stop. Numbers the mesh anew where its order has decayed, and at the end. Adds to the report what was done.
void run_rounds(Session& session, const RoundRules& rules, const ProgressCallback& progress, Report& report);

}  // namespace taut
