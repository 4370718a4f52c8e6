// taut adapt: reads a mesh and a metric or a solution, writes a mesh whose edges have about unit length in the metric.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt_job.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "geometry_file.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "local_file.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "ridges_file.hpp"
#include "solution.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

struct AdaptInput {
  Mesh mesh;
  Metric metric;              ///< without fields
  std::vector<Field> fields;  ///< empty: the metric counts
  LocalSizes local;
  std::optional<Geometry> geometry;
};

LocalSizes read_local(const AdaptJob& job) {
  if (job.local.empty()) return {};
  LocalSizes sizes = read_local_sizes(job.local);
  if (job.options.ridge_angle) sizes.ridge_angle = *job.options.ridge_angle;
  return sizes;
}

AdaptInput read_input(const AdaptJob& job) {
  AdaptInput input{.mesh = read_mesh(job.input),
                   .metric = {},
                   .fields = {},
                   .local = read_local(job),
                   .geometry = read_geometry(job.geometry, job.options.ridge_angle)};
  if (!job.ridges.empty()) input.mesh = with_ridges_of(job.ridges, std::move(input.mesh), job.input);
  if (adapts_to_fields(job)) {
    input.fields = read_fields(job.field.files, input.mesh.points.size());
  } else if (!job.metric.empty()) {
    input.metric = read_metric(job.metric);
  }
  return input;
}

/// Without fields.
Metric metric_of(const AdaptJob& job, const AdaptInput& input) {
  Metric metric = job.size              ? metric_of_size(*job.size)
                  : !job.metric.empty() ? input.metric
                                        : implied_metric(input.mesh);
  if (input.local.empty()) return metric;
  return with_local_sizes(input.mesh, tensors_of(input.mesh, metric), input.local);
}

/// For errors about it.
std::string name_of_metric(const AdaptJob& job) {
  return job.size ? "--size" : !job.metric.empty() ? job.metric : job.optimise ? "--optimise" : job.local;
}

SolutionResult work_on(const AdaptJob& job, const AdaptInput& input, AdaptOptions options) {
  if (adapts_to_fields(job))
    return with_files(job.input,
                      {{"fields: ", fmt::format("{}", fmt::join(job.field.files, ", "))},
                       {"metric: ", "--complexity"},
                       {"local sizes: ", job.local},
                       {"geometry: ", job.geometry}},
                      [&] {
                        SolutionOptions solution = solution_options(job.field, job.limits, options);
                        solution.local = input.local;
                        return adapt_to_solution(input.mesh, input.fields, solution);
                      });
  options.limits = limits_of(job.limits);
  SolutionResult result;
  result.adapted = with_files(
      job.input, {{"metric: ", name_of_metric(job)}, {"local sizes: ", job.local}, {"geometry: ", job.geometry}},
      [&] { return adapt(input.mesh, metric_of(job, input), options); });
  return result;
}

SolutionResult adapt_files(const AdaptJob& job, const Interrupt& interrupt) {
  const Stopwatch watch;
  const AdaptInput input = read_input(job);
  const double seconds = watch.seconds();
  if (interrupt.requested()) throw Failure("interrupted while reading: nothing was written");

  ProgressLine line(job.quiet);
  AdaptOptions options = job.options;
  options.geometry = input.geometry;
  options.progress = [&](const Progress& progress) {
    line.show(progress);
    return !interrupt.requested();
  };
  options.expecting = [&](double tetrahedra) {
    line.show_expected(tetrahedra);
    return !interrupt.requested();
  };
  SolutionResult result = work_on(job, input, std::move(options));
  auto& phases = result.adapted.report.seconds;
  phases.emplace(phases.begin(), "read", seconds);
  for (const auto& [step, time] : result.seconds)
    if (step != "adapt") phases.emplace_back(step, time);  // its phases are there already
  return result;
}

// The report is written last, because it holds the seconds that writing took.
void write_outputs(const AdaptJob& job, SolutionResult& result) {
  const Stopwatch watch;
  AdaptResult& adapted = result.adapted;
  if (!job.field.output.empty()) write_solution(job.field.output, result.fields);
  if (!job.metric_out.empty()) write_solution(job.metric_out, {field_of(adapted.metric)});
  write_output(job.output, adapted.mesh, result.fields, adapted.metric);
  adapted.report.seconds.emplace_back("write", watch.seconds());
  if (job.report.empty()) return;
  Json json = {{"taut", TAUT_VERSION}};
  json.update(json_of(job));
  if (adapts_to_fields(job)) json.update(json_of(job.field, result));
  json.update(json_of(adapted.report));
  json["quality"] = json_of(adapted.report.quality, true);
  write_text(job.report, text_of(json));
}

void print_note(const std::string& file, std::size_t count, const char* what) {
  if (count > 0) fmt::print(stderr, "taut: note: {}: {} {}\n", file, count, what);
}

void print_notes(const AdaptJob& job, const Report& report) {
  print_note(job.input, report.reoriented, "inverted tetrahedra were reoriented");
  print_note(job.input, report.triangles_built, "missing triangles on the boundary or between regions were added");
  print_note(job.input, report.edges_dropped,
             "edges were dropped, because a vertex of theirs belongs to no tetrahedron");
  print_note(
      job.geometry, report.off_surface,
      "vertices of the boundary are not on this geometry, because they may not move or tetrahedra would turn over");
  if (job.options.surface != Surface::fixed)
    print_note(job.input, report.triangles_frozen,
               job.options.surface == Surface::planar
                   ? "triangles were kept as they are, because their patch is not planar or they are required"
                   : "triangles were kept as they are, because they are required");
}

void print_summary(const AdaptJob& job, const SolutionResult& result, double seconds) {
  const Report& report = result.adapted.report;
  print_notes(job, report);
  if (adapts_to_fields(job)) fmt::print(stderr, "{}", complexity_notes(job.field, job.output, result));
  fmt::print("{} -> {}: {} rounds, {} threads, {} blocks, {:.2f} s\n\n", job.input, job.output, report.rounds,
             report.threads, report.blocks, seconds);
  if (adapts_to_fields(job)) fmt::print("{}\n", solution_table(result));
  fmt::print("{}\n{}", quality_table(report.quality, true), work_table(report));
}

void run_adapt(const AdaptJob& asked) {
  const Stopwatch watch;
  require_sound(asked);
  const AdaptJob job = with_outputs(asked);
  const Interrupt interrupt;
  SolutionResult result = adapt_files(job, interrupt);
  write_outputs(job, result);
  if (!job.quiet) print_summary(job, result, watch.seconds());
  if (const Report& report = result.adapted.report; report.cancelled)
    throw Failure(fmt::format("interrupted in round {}: {} holds the mesh as it was then, which is valid",
                              report.rounds, job.output));
}

}  // namespace

void add_adapt(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("adapt", "adapt a mesh to a metric, to one size or to a solution");
  const auto asked = std::make_shared<AdaptJob>();
  add_options(*command, *asked);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_adapt(*asked); }); }; });
}

}  // namespace taut::program
