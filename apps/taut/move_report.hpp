// What `taut move` did, step by step.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "json.hpp"
#include "move_job.hpp"
#include "taut/quality.hpp"

namespace taut::program {

/// What became of a step; of the beginning, if it is step 0.
struct MoveStep {
  std::size_t step = 0;
  std::string file;  ///< of the mesh; empty if it was not written
  Advance done;
  Quality quality;  ///< of the mesh after the step
};

struct MoveReport {
  std::vector<MoveStep> steps;   ///< begins with step 0
  std::string pvd;               ///< empty: none
  std::string ended;             ///< why before the last step; empty if that was reached
  double read = 0, seconds = 0;  ///< to read the files and set up; in all
};

/// Adds `seconds` to those of a phase.
void add_phase(Phases& phases, const std::string& phase, double seconds);

[[nodiscard]] Json json_of_move(const MoveJob& job, const MoveReport& report);

}  // namespace taut::program
