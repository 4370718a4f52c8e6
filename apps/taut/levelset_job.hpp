// What `taut levelset extract` is asked to do.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "taut/surface_distance.hpp"

namespace taut::program {

struct ExtractJob {
  std::string input, field, output;
  std::string compare;  ///< a surface to measure the distance to; empty: none
  std::string report;   ///< empty: not written
  double level = 0;
  DistanceOptions sampling;
  bool quiet = false;
  int threads = 0;
};

/// Adds the options to `command`; they fill `job`, which must outlive it.
void add_options(CLI::App& command, ExtractJob& job);

}  // namespace taut::program
