#include "adapt_job.hpp"

#include <fmt/format.h>

#include "check.hpp"

namespace taut::program {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  taut adapt wing.meshb --metric wing-met.solb -o adapted.meshb\n"
    "  taut adapt part.mesh --size 0.05 --surface fixed -o fine.mesh\n"
    "  taut adapt box.meshb --metric m.solb --gradation 1.3 --hmin 1e-4 -o out.meshb --report out.json";

void add_files(CLI::App& command, AdaptJob& job) {
  command.add_option("IN", job.input, "mesh to adapt, .mesh or .meshb")->required()->type_name("");
  command.add_option("-o,--output", job.output, "file for the adapted mesh, .mesh or .meshb; may be IN")
      ->required()
      ->type_name("OUT");
  command.add_option("--metric", job.metric, "sizes or tensors at the vertices of IN, .sol or .solb")->type_name("SOL");
  command.add_option("--metric-out", job.metric_out, "file for the metric at the vertices of OUT, .sol or .solb")
      ->type_name("SOL");
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
  command.add_flag("--quiet", job.quiet, "print only errors");
}

void add_size(CLI::App& command, AdaptJob& job) {
  const auto set_size = [&job](const std::string& word) { job.size = number_in(word); };
  command.add_option_function<std::string>("--size", set_size, "one size everywhere, instead of a metric")
      ->type_name("H")
      ->check(positive_number());
}

void add_surface(CLI::App& command, AdaptOptions& options) {
  const auto set_surface = [&options](const std::string& word) {
    options.surface = word == "fixed" ? Surface::fixed : Surface::adapt;
  };
  command
      .add_option_function<std::string>("--surface", set_surface,
                                        "adapt (the default): remesh planar patches; fixed: keep all triangles")
      ->type_name("WORD")
      ->check(one_of("adapt", "fixed"));
  command
      .add_option("--angle", options.ridge_angle,
                  "an edge is a ridge if the normals of its triangles differ by this or more, in degrees")
      ->type_name("DEG")
      ->capture_default_str()
      ->check(number([](double x) { return x > 0 && x < 180; }, "degrees between 0 and 180"));
}

void require_one_target(const AdaptJob& job) {
  if (job.metric.empty() && !job.size)
    throw InputError("neither --metric nor --size found, expected one of them; see 'taut adapt --help'");
  if (!job.metric.empty() && job.size)
    throw InputError("both --metric and --size found, expected only one of them; see 'taut adapt --help'");
}

}  // namespace

void add_options(CLI::App& command, AdaptJob& job) {
  add_files(command, job);
  add_size(command, job);
  add_limits(command, job.limits);
  add_surface(command, job.options);
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
  require_sound(job.limits, "adapt");
}

}  // namespace taut::program
