// taut metric: makes metrics from solutions, meshes, sizes and other metrics.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>

#include "check.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "limits.hpp"
#include "metric_work.hpp"
#include "options.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

constexpr const char* metric_examples =
    "Examples:\n"
    "  taut metric lp wing.meshb mach.solb --complexity 50000 -o metric.solb\n"
    "  taut metric lp wing.meshb mach.solb density.solb --complexity 50000 --norm 4 --hmin 1e-4 -o metric.solb\n"
    "  taut metric error wing.meshb mach.solb --error 0.01 --gradation 1.5 -o metric.solb\n"
    "  taut metric curvature wing.meshb --deviation 1e-3 --gradation 1.5 -o metric.solb\n"
    "  taut metric implied wing.meshb -o metric.solb";

using Work = std::function<void(const MetricJob&, const Mesh&)>;

void run_metric(const MetricJob& job, const CLI::App& command, const Work& work) {
  require_sound(job.limits, fmt::format("metric {}", command.get_name()));
  require_output(job.output, solution_files);
  const Mesh mesh = read_mesh(job.mesh);
  work(job, mesh);
}

/// A subcommand of `taut metric` with what all have in common.
CLI::App* add_kind(CLI::App& metric, Job& job, const std::shared_ptr<MetricJob>& asked, const char* name,
                   const char* what, Work work) {
  CLI::App* command = metric.add_subcommand(name, what);
  command->add_option("MESH", asked->mesh, "mesh, .mesh or .meshb")->required()->type_name("");
  command->add_option("-o,--output", asked->output, "file for the result, .sol or .solb")->required()->type_name("OUT");
  add_threads(*command, asked->threads);
  command->add_flag("--quiet", asked->quiet, "print only errors and notes");
  command->callback([asked, command, work = std::move(work), &job] {
    job = [asked, command, work] { on_threads(asked->threads, [&] { run_metric(*asked, *command, work); }); };
  });
  return command;
}

CLI::Option* add_inputs(CLI::App& command, MetricJob& job, const char* name, const char* what) {
  return command.add_option(name, job.inputs, what)->type_name("");
}

void add_fields(CLI::App& command, MetricJob& job) {
  add_inputs(command, job, "FIELDS",
             "solutions at the vertices, .sol or .solb: scalars, or vectors, of which each component counts")
      ->required();
  add_recovery(command, job.recovery);
}

void add_lp(CLI::App& metric, Job& job) {
  const auto asked = std::make_shared<MetricJob>();
  CLI::App* command =
      add_kind(metric, job, asked, "lp", "for the least error of a solution at a given complexity", run_lp);
  add_fields(*command, *asked);
  add_complexity(*command, asked->lp.complexity)->required();
  add_norm(*command, asked->lp.norm);
  add_limits(*command, asked->limits);
}

void add_error(CLI::App& metric, Job& job) {
  const auto asked = std::make_shared<MetricJob>();
  CLI::App* command = add_kind(metric, job, asked, "error", "for a given interpolation error everywhere", run_error);
  add_fields(*command, *asked);
  command->add_option("--error", asked->error, "wanted error, in the unit of the solution")
      ->required()
      ->type_name("E")
      ->check(positive_number());
  add_limits(*command, asked->limits);
}

void add_level_set(CLI::App& metric, Job& job) {
  const auto asked = std::make_shared<MetricJob>();
  CLI::App* command =
      add_kind(metric, job, asked, "levelset", "that resolves the surface where a solution is zero", run_level_set);
  add_inputs(*command, *asked, "FIELDS", "solutions at the vertices, .sol or .solb")->required();
  LevelSetOptions& options = asked->level_set;
  command->add_option("--error", options.error, "size across the surface; the distance to it will be about 0.3 E")
      ->required()
      ->type_name("E")
      ->check(positive_number());
  command->add_option("--level", asked->level, "value of the solution on the surface")
      ->type_name("V")
      ->capture_default_str();
  command->add_option("--across", options.across, "smallest size across the surface, as a share of that along it")
      ->type_name("S")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 0; }, "a number, 0 or more"));
  command
      ->add_option("--growth", options.growth,
                   "growth of the size across the surface per distance from it; all sizes grow by the same factor")
      ->type_name("C")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 0; }, "a number, 0 or more"));
  command
      ->add_option("--refinement", options.refinement,
                   "sizes shrink at most by this factor from those of the mesh: adapt and repeat until nothing changes")
      ->type_name("F")
      ->capture_default_str()
      ->check(number([](double x) { return x > 1; }, "a number above 1"));
  add_limits(*command, asked->limits);
}

void add_curvature(CLI::App& metric, Job& job) {
  const auto asked = std::make_shared<MetricJob>();
  CLI::App* command =
      add_kind(metric, job, asked, "curvature", "that resolves the curved parts of the mesh's surface", run_curvature);
  CurvatureOptions& options = asked->curvature;
  command
      ->add_option("--deviation", options.deviation,
                   "how far edges may be from the surface between their ends, in the unit of the mesh")
      ->required()
      ->type_name("D")
      ->check(positive_number());
  command->add_flag("--relative", options.relative, "D is a share of the diagonal of the mesh's bounding box");
  command
      ->add_option("--turn", options.turn,
                   "degrees by which the surface turns at most along an edge, whatever the deviation")
      ->type_name("DEG")
      ->capture_default_str()
      ->check(number([](double x) { return x > 0 && x <= 90; }, "degrees above 0, at most 90"));
  add_ridge_angle(*command, options.ridge_angle);
  add_limits(*command, asked->limits);
}

void add_plain_kinds(CLI::App& metric, Job& job) {
  const auto hessian = std::make_shared<MetricJob>();
  add_fields(
      *add_kind(metric, job, hessian, "hessian", "no metric, but the second derivatives of a solution", run_hessian),
      *hessian);
  const auto implied = std::make_shared<MetricJob>();
  add_limits(*add_kind(metric, job, implied, "implied", "in which the mesh is a unit mesh", run_implied),
             implied->limits);
  const auto size = std::make_shared<MetricJob>();
  CLI::App* command = add_kind(metric, job, size, "size", "from one size, or from sizes at the vertices", run_size);
  add_inputs(*command, *size, "SIZES", "sizes at the vertices, .sol or .solb");
  command->add_option("--size", size->size, "one size everywhere")->type_name("H")->check(positive_number());
  add_limits(*command, size->limits);
}

void add_combinations(CLI::App& metric, Job& job) {
  const auto both = std::make_shared<MetricJob>();
  CLI::App* command =
      add_kind(metric, job, both, "intersect", "the largest sizes that no metric forbids", run_intersect);
  add_inputs(*command, *both, "METRICS", "sizes or tensors at the vertices, .sol or .solb")->required();
  add_limits(*command, both->limits);
  const auto graded = std::make_shared<MetricJob>();
  command =
      add_kind(metric, job, graded, "gradate", "limits on another metric: growth, sizes, anisotropy", run_intersect);
  add_inputs(*command, *graded, "METRIC", "sizes or tensors at the vertices, .sol or .solb")->required()->expected(1);
  add_limits(*command, graded->limits);
}

}  // namespace

void add_metric(CLI::App& app, Job& job) {
  CLI::App* metric = app.add_subcommand("metric", "make a metric from a solution, a mesh or other metrics");
  metric->require_subcommand(1);
  metric->footer(metric_examples);
  add_lp(*metric, job);
  add_error(*metric, job);
  add_level_set(*metric, job);
  add_curvature(*metric, job);
  add_plain_kinds(*metric, job);
  add_combinations(*metric, job);
}

}  // namespace taut::program
