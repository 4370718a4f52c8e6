#include "adapt_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <utility>
#include <vector>

#include "check.hpp"
#include "files.hpp"
#include "options.hpp"

namespace taut::program {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  taut adapt wing.meshb --metric wing-met.solb -o adapted.meshb\n"
    "  taut adapt part.mesh --size 0.05 --surface fixed -o fine.mesh\n"
    "  taut adapt wing.meshb --field mach.solb --complexity 50000 -o next.meshb\n"
    "  taut adapt wing.meshb --optimise --local finer-edge.json -o better.meshb\n"
    "  taut adapt step3.meshb --size 0.1 --geometry first.meshb -o step4.meshb\n"
    "  taut adapt box.meshb --metric m.solb --gradation 1.3 --hmin 1e-4 -o out.meshb --report out.json";

void add_files(CLI::App& command, AdaptJob& job) {
  command.add_option("IN", job.input, "mesh to adapt, .mesh or .meshb")->required()->type_name("");
  command
      .add_option("-o,--output", job.output,
                  "file for the adapted mesh, .mesh or .meshb; may be IN; or .vtu, for ParaView")
      ->required()
      ->type_name("OUT");
  command.add_option("--metric", job.metric, "sizes or tensors at the vertices of IN, .sol or .solb")->type_name("SOL");
  command
      .add_option("--metric-out", job.metric_out,
                  "file for the metric at the vertices of OUT, .sol or .solb; by default none, and with --field OUT "
                  "with .metric "
                  "before that extension")
      ->type_name("SOL");
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
  command.add_flag("--quiet", job.quiet, "print only errors");
}

void add_sizes(CLI::App& command, AdaptJob& job) {
  add_size(command, job.size);
  command.add_flag("--optimise,--optimize", job.optimise,
                   "keep the sizes and the stretching that the mesh has, and mend its quality, instead of a metric");
  command
      .add_option("--local", job.local,
                  "sizes by the references of triangles, edges, vertices and tetrahedra, .json, beside those of a "
                  "metric; alone, beside those that the mesh has")
      ->type_name("FILE");
}

void add_boundary(CLI::App& command, AdaptJob& job) {
  add_surface(command, job.options.surface,
              "remesh all, with vertices on the curved surface that the triangles stand for");
  add_geometry(command, job.geometry, "the same file for many adaptations keeps the surface");
  command
      .add_option("--ridges", job.ridges,
                  "edges that are ridges whatever the angle: those marked in a mesh, .mesh or .meshb, or all of its "
                  "edges if none is, found in IN by their places; or text with two vertex numbers a line, from 1")
      ->type_name("FILE");
  add_ridge_angle(command, job.options.ridge_angle);
  command
      .add_option("--deviation", job.options.deviation,
                  "allowed distance between triangles and the curved surface: makes sizes smaller where it is curved")
      ->type_name("D")
      ->check(positive_number());
}

void require_one_target(const AdaptJob& job) {
  std::vector<std::string_view> found;
  if (!job.metric.empty()) found.emplace_back("--metric");
  if (job.size) found.emplace_back("--size");
  if (adapts_to_fields(job)) found.emplace_back("--field");
  if (job.optimise) found.emplace_back("--optimise");
  if (found.empty() && job.local.empty())
    throw InputError("none of --metric, --size, --field and --optimise found, expected one; see 'taut adapt --help'");
  if (found.size() > 1)
    throw InputError(
        fmt::format("{} found, expected only one of them; see 'taut adapt --help'", fmt::join(found, " and ")));
}

}  // namespace

void add_options(CLI::App& command, AdaptJob& job) {
  add_files(command, job);
  add_sizes(command, job);
  add_fields(command, job.field);
  add_limits(command, job.limits);
  add_boundary(command, job);
  command
      .add_option("--rounds,--passes", job.options.max_rounds,
                  "at most this many rounds; it stops earlier once they gain little")
      ->type_name("N")
      ->capture_default_str()
      ->check(count());
  add_threads(command, job.threads);
  command
      .add_option("--block-size", job.options.block_size,
                  "vertices per block, the part that one thread works on at a time; 0: the whole mesh")
      ->type_name("N")
      ->capture_default_str()
      ->check(count());
  command.footer(examples);
}

void require_sound(const AdaptJob& job) {
  require_one_target(job);
  require_adapted_surface(job.geometry, job.options.surface, "adapt");
  require_sound(job.limits, "adapt");
}

AdaptJob with_outputs(AdaptJob job) {
  if (adapts_to_fields(job)) {
    if (job.field.output.empty()) job.field.output = beside(job.output, "");
    if (job.metric_out.empty()) job.metric_out = beside(job.output, ".metric");
  }
  require_output(job.output, mesh_outputs);
  require_output(job.field.output, solution_files);
  require_output(job.metric_out, solution_files);
  require_output(job.report, report_files);
  require_different("fields", job.field.output, "metric", job.metric_out);
  return job;
}

}  // namespace taut::program
