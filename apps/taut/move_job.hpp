// What `taut move` is asked to do.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "limits.hpp"
#include "taut/motion.hpp"

namespace taut::program {

struct MoveJob {
  std::string input, motion;
  std::string output, fields_out, metric_out;  ///< patterns, see StepNames; but for `output`, empty: not written
  std::string metric;                          ///< empty: `size`, or else the metric that the mesh implies
  std::optional<double> size;                  ///< wanted everywhere
  std::vector<std::string> fields;
  std::string geometry;     ///< file of the surface for the boundary; empty: that of the mesh
  std::string report, pvd;  ///< empty: not written
  int steps = 0, every = 1;
  AskedLimits limits;
  bool quiet = false;
  int threads = 0;
  MotionOptions options;  ///< without the limits, the geometry and the sliding walls
};

/// Adds the options to `command`; they fill `job`, which must outlive it.
void add_options(CLI::App& command, MoveJob& job);

/// Throws InputError for options that are each valid but contradict each other.
void require_sound(const MoveJob& job);

/// The word for it on the command line.
[[nodiscard]] const char* word_of(MeshChanges changes);
[[nodiscard]] const char* word_of(Following following);

}  // namespace taut::program
