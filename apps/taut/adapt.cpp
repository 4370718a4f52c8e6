// taut adapt: reads a mesh and a metric, writes a mesh whose edges have about unit length in the metric.
#include <fmt/format.h>

#include <memory>

#include "adapt_job.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "progress_line.hpp"
#include "solution.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

void require_outputs(const AdaptJob& job) {
  require_output(job.output, mesh_files);
  require_output(job.metric_out, solution_files);
  require_output(job.report, report_files);
}

Metric uniform(double size) {
  const double m = 1 / (size * size);
  return [m](const Point&) { return Tensor{m, 0, 0, m, 0, m}; };
}

Metric target_of(const AdaptJob& job) {
  return job.size ? uniform(*job.size) : read_metric(job.metric);
}

AdaptResult adapt_files(const AdaptJob& job, const Interrupt& interrupt) {
  const Stopwatch watch;
  const Mesh mesh = read_mesh(job.input);
  const Metric metric = target_of(job);
  const double seconds = watch.seconds();
  if (interrupt.requested()) throw Failure("interrupted while reading: nothing was written");

  ProgressLine line(job.quiet);
  AdaptOptions options = job.options;
  options.limits = limits_of(job.limits);
  options.progress = [&](const Progress& progress) {
    line.show(progress);
    return !interrupt.requested();
  };
  options.expecting = [&](double tetrahedra) {
    line.show_expected(tetrahedra);
    return !interrupt.requested();
  };
  AdaptResult result = with_files(job.input, {{"metric: ", job.size ? "--size" : job.metric}},
                                  [&] { return adapt(mesh, metric, options); });
  result.report.seconds.emplace(result.report.seconds.begin(), "read", seconds);
  return result;
}

// The report is written last, because it holds the seconds that writing took.
void write_outputs(const AdaptJob& job, AdaptResult& result) {
  const Stopwatch watch;
  if (!job.metric_out.empty()) write_solution(job.metric_out, {field_of(result.metric)});
  write_mesh(job.output, result.mesh);
  result.report.seconds.emplace_back("write", watch.seconds());
  if (job.report.empty()) return;
  Json json = {{"taut", TAUT_VERSION}};
  json.update(json_of(job));
  json.update(json_of(result.report));
  json["quality"] = json_of(result.report.quality, true);
  write_text(job.report, text_of(json));
}

void print_note(const std::string& file, std::size_t count, const char* what) {
  if (count > 0) fmt::print(stderr, "taut: note: {}: {} {}\n", file, count, what);
}

void print_notes(const AdaptJob& job, const Report& report) {
  print_note(job.input, report.reoriented, "inverted tetrahedra were reoriented");
  print_note(job.input, report.triangles_built, "missing triangles on the boundary or between regions were added");
  if (job.options.surface == Surface::adapt)
    print_note(job.input, report.triangles_frozen,
               "triangles were kept as they are, because their patch is not planar or they are required");
}

void print_summary(const AdaptJob& job, const Report& report, double seconds) {
  print_notes(job, report);
  fmt::print("{} -> {}: {} rounds, {} threads, {} blocks, {:.2f} s\n\n{}\n{}", job.input, job.output, report.rounds,
             report.threads, report.blocks, seconds, quality_table(report.quality, true), work_table(report));
}

void run_adapt(const AdaptJob& job) {
  const Stopwatch watch;
  require_sound(job);
  require_outputs(job);
  const Interrupt interrupt;
  AdaptResult result = adapt_files(job, interrupt);
  write_outputs(job, result);
  if (!job.quiet) print_summary(job, result.report, watch.seconds());
  if (result.report.cancelled)
    throw Failure(fmt::format("interrupted in round {}: {} holds the mesh as it was then, which is valid",
                              result.report.rounds, job.output));
}

}  // namespace

void add_adapt(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("adapt", "adapt a mesh to a metric or to one size");
  const auto asked = std::make_shared<AdaptJob>();
  add_options(*command, *asked);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_adapt(*asked); }); }; });
}

}  // namespace taut::program
