// What `taut adapt --field` is asked to do besides.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "limits.hpp"
#include "taut/solution.hpp"

namespace taut::program {

struct FieldJob {
  std::vector<std::string> files;  ///< empty: the mesh is adapted to a metric or to one size
  std::string output;              ///< for the fields on the adapted mesh
  double complexity = 0;
  double norm = LpOptions{}.norm;
  Recovery recovery = Recovery::least_squares;
  Transfer transfer = Transfer::conservative;
};

/// Adds the options to `command`; they fill `job`, which must outlive it.
void add_fields(CLI::App& command, FieldJob& job);

/// What adapt_to_solution() shall do.
[[nodiscard]] SolutionOptions solution_options(const FieldJob& job, const AskedLimits& limits, AdaptOptions adapt);

/// What kept the mesh from the wanted complexity, one line each: a limit, or triangles that stay as they are.
[[nodiscard]] std::string complexity_notes(const FieldJob& job, const std::string& mesh, const SolutionResult& result);

/// The name of the mesh file with `middle` and the extension of a solution file, text or binary as the mesh is.
[[nodiscard]] std::string beside(const std::string& mesh, const char* middle);

}  // namespace taut::program
