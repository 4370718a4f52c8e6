// What `taut adapt` is asked to do.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "field_job.hpp"
#include "limits.hpp"
#include "taut/adapt.hpp"

namespace taut::program {

struct AdaptJob {
  std::string input, metric, output;
  std::string report, metric_out;  ///< empty: not written
  std::string geometry;            ///< file of the surface for the boundary; empty: that of the mesh
  std::string ridges;              ///< file of edges that are ridges too; empty: none
  std::string local;               ///< file of sizes by reference; empty: none
  std::optional<double> size;      ///< wanted everywhere, instead of a metric or of fields
  bool optimise = false;           ///< keep the sizes of the mesh, instead of a metric or of fields
  FieldJob field;
  AskedLimits limits;
  bool quiet = false;
  int threads = 0;
  AdaptOptions options;  ///< without the limits
};

/// Adds the options to `command`; they fill `job`, which must outlive it.
void add_options(CLI::App& command, AdaptJob& job);

/// Whether the mesh is adapted to fields, which are then transferred.
[[nodiscard]] inline bool adapts_to_fields(const AdaptJob& job) {
  return !job.field.files.empty();
}

/// Throws InputError for options that are each valid but contradict each other.
void require_sound(const AdaptJob& job);

/// Names the outputs that are written by default. Throws InputError unless all can be written, each to a file of its
/// own.
[[nodiscard]] AdaptJob with_outputs(AdaptJob job);

}  // namespace taut::program
