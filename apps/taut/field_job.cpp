#include "field_job.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "options.hpp"

namespace taut::program {
namespace {

/// Whether the adaptation ended by itself, with most triangles of the surface as they were.
bool is_mostly_frozen(const AdaptResult& adapted) {
  return !adapted.report.cancelled && 2 * adapted.report.triangles_frozen > adapted.mesh.triangles.size();
}

}  // namespace

void add_fields(CLI::App& command, FieldJob& job) {
  CLI::Option* field =
      command
          .add_option(
              "--field", job.files,
              "solution at the vertices of IN, .sol or .solb: adapt to it, instead of to a metric, and transfer "
              "it; several files count together")
          ->type_name("SOL")
          ->allow_extra_args(false);
  CLI::Option* complexity = add_complexity(command, job.complexity);
  field->needs(complexity);
  CLI::Option* output = command
                            .add_option("--field-out", job.output,
                                        "file for the fields at the vertices of OUT, .sol or .solb; by default OUT "
                                        "with that extension")
                            ->type_name("SOL");
  for (CLI::Option* option : {complexity, add_norm(command, job.norm), add_recovery(command, job.recovery),
                              add_method(command, "--transfer", job.transfer), output})
    option->needs(field);
}

SolutionOptions solution_options(const FieldJob& job, const AskedLimits& limits, AdaptOptions adapt) {
  return {.sizing = {.complexity = job.complexity, .norm = job.norm, .limits = limits_of(limits)},
          .recovery = job.recovery,
          .adapt = std::move(adapt),
          .transfer = {.method = job.transfer}};
}

std::string complexity_notes(const FieldJob& job, const std::string& mesh, const SolutionResult& result) {
  std::string notes;
  if (!result.stopped_by.empty())
    notes += fmt::format("taut: note: {}: complexity {:.4g} instead of {:.4g}, because of {}\n", mesh,
                         result.complexity, job.complexity, result.stopped_by);
  const double expected = tetrahedra_per_complexity * result.complexity;
  const auto found = static_cast<double>(result.adapted.mesh.tetrahedra.size());
  if (is_mostly_frozen(result.adapted) && std::abs(found - expected) > 0.25 * expected)
    notes += fmt::format("taut: note: {}: {} tetrahedra instead of about {:.3g}, because of the triangles that stay\n",
                         mesh, found, expected);
  return notes;
}

std::string beside(const std::string& mesh, const char* middle) {
  std::filesystem::path path = mesh;
  const char* extension = path.extension() == ".meshb" ? ".solb" : ".sol";
  return path.replace_extension().string() + middle + extension;
}

}  // namespace taut::program
