// taut move: a mesh follows moving bodies, step by step.
#include <fmt/format.h>

#include <initializer_list>
#include <memory>
#include <string>

#include "check.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "geometry_file.hpp"
#include "interrupt.hpp"
#include "move_bodies.hpp"
#include "move_files.hpp"
#include "move_job.hpp"
#include "move_report.hpp"
#include "options.hpp"
#include "progress_line.hpp"
#include "solution.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

MotionOptions motion_options(const MoveJob& job, const MovingBodies& bodies, const Interrupt& interrupt) {
  MotionOptions options = job.options;
  options.adaptation.limits = limits_of(job.limits);
  options.adaptation.geometry = read_geometry(job.geometry, options.adaptation.ridge_angle);
  options.adaptation.progress = [&interrupt](const Progress&) { return !interrupt.requested(); };
  options.sliding = bodies.sliding();
  return options;
}

Metric metric_for(const MoveJob& job, const Mesh& mesh) {
  if (job.size) return metric_of_size(*job.size);
  if (!job.metric.empty()) return read_metric(job.metric);
  return with_files(job.input, std::initializer_list<Source>{}, [&] { return Metric{implied_metric(mesh)}; });
}

MovingMesh moving_mesh(const MoveJob& job, MovingBodies& bodies, const MotionOptions& options) {
  const Mesh mesh = read_mesh(job.input);
  const std::vector<Field> fields = read_fields(job.fields, mesh.points.size());
  const Metric metric = metric_for(job, mesh);
  MovingMesh moving =
      with_files(job.input, {{"metric: ", job.size ? "--size" : job.metric}, {"geometry: ", job.geometry}},
                 [&] { return MovingMesh(mesh, metric, options); });
  bodies.fit(moving.mesh(), job.input);
  moving.set_fields(fields);
  return moving;
}

/// The steps of one run: does each, measures, writes and remembers it.
class MoveRun {
public:
  MoveRun(const MovingBodies& bodies, MovingMesh& mesh, MoveFiles& files, MoveReport& report)
      : bodies_(bodies), mesh_(mesh), files_(files), report_(report) {}

  /// Step 0 is the beginning.
  const MoveStep& do_step(std::size_t number, const Interrupt& interrupt) {
    MoveStep& step = report_.steps.emplace_back();
    step.step = number;
    step.done = number == 0 ? nothing_done() : bodies_.advance(mesh_, number);
    const Stopwatch measure_watch;
    step.quality = measure(mesh_.mesh(), mesh_.metric());
    add_phase(step.done.seconds, "measure", measure_watch.seconds());
    const bool is_last = step.done.obstacle || interrupt.requested();
    if (is_last || files_.wants(number)) write(step);
    if (is_last) report_.ended = reason_of(step);
    return step;
  }

private:
  static Advance nothing_done() {
    Advance done;
    done.share = 1;
    return done;
  }

  void write(MoveStep& step) {
    const Stopwatch watch;
    files_.write(mesh_, step.step);
    step.file = files_.mesh_name(step.step);
    add_phase(step.done.seconds, "write", watch.seconds());
  }

  static std::string reason_of(const MoveStep& step) {
    if (step.done.obstacle)
      return fmt::format("step {}: the bodies are stopped after {:.4g} of the step: {}; {} holds the last valid mesh",
                         step.step, step.done.share, description(*step.done.obstacle), step.file);
    return fmt::format("interrupted in step {}: {} holds the mesh as it was then, which is valid", step.step,
                       step.file);
  }

  const MovingBodies& bodies_;
  MovingMesh& mesh_;
  MoveFiles& files_;
  MoveReport& report_;
};

MoveReport move_files(const MoveJob& job) {
  const Stopwatch watch;
  const Interrupt interrupt;
  MovingBodies bodies(job.motion, job.options);
  MoveFiles files(job, bodies.files());
  MovingMesh mesh = moving_mesh(job, bodies, motion_options(job, bodies, interrupt));
  MoveReport report{.steps = {}, .pvd = files.pvd(), .ended = "", .read = watch.seconds(), .seconds = 0};

  ProgressLine line(job.quiet);
  MoveRun run(bodies, mesh, files, report);
  const auto steps = static_cast<std::size_t>(job.steps);
  for (std::size_t step = 0; step <= steps && report.ended.empty(); ++step)
    line.show_step(step, steps, run.do_step(step, interrupt).quality);
  report.seconds = watch.seconds();
  if (!job.report.empty()) write_text(job.report, text_of(json_of_move(job, report)));
  return report;
}

void run_move(const MoveJob& job) {
  require_sound(job);
  const MoveReport report = move_files(job);
  if (!report.ended.empty()) throw Failure(report.ended);
  if (job.quiet) return;
  fmt::print("{} -> {}: {} steps, {:.2f} s\n\n{}", job.input, job.output, job.steps, report.seconds,
             quality_table(report.steps.back().quality, true));
}

}  // namespace

void add_move(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("move", "let a mesh follow moving bodies, step by step");
  const auto asked = std::make_shared<MoveJob>();
  add_options(*command, *asked);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_move(*asked); }); }; });
}

}  // namespace taut::program
