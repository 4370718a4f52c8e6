// taut levelset place: moves and inserts vertices, so that the surface on which a field takes a value runs through
// them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "check.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "json.hpp"
#include "options.hpp"
#include "solution.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

constexpr const char* place_examples =
    "Examples:\n"
    "  taut levelset place box.meshb u.solb --metric m.solb -o placed.meshb --values-out u-placed.solb\n"
    "  taut levelset place box.meshb u.solb --deviation 1e-4 -o placed.meshb";

struct PlaceJob {
  std::string input, field, output;
  std::string metric;                          ///< empty: the one that the mesh implies
  std::string report, metric_out, values_out;  ///< empty: not written
  double level = 0;
  PlaceOptions options;
  bool quiet = false;
  int threads = 0;
};

void add_place_files(CLI::App& command, PlaceJob& job) {
  command.add_option("IN", job.input, "mesh, .mesh or .meshb")->required()->type_name("");
  command.add_option("FIELD", job.field, "one number at each vertex of IN, .sol or .solb")->required()->type_name("");
  command.add_option("-o,--output", job.output, "file for the mesh, .mesh or .meshb; may be IN; or .vtu, for ParaView")
      ->required()
      ->type_name("OUT");
  command
      .add_option("--metric", job.metric,
                  "sizes or tensors at the vertices of IN, .sol or .solb, in which quality is judged; by default those "
                  "that the mesh has")
      ->type_name("SOL");
  command.add_option("--metric-out", job.metric_out, "file for the metric at the vertices of OUT, .sol or .solb")
      ->type_name("SOL");
  command
      .add_option("--values-out", job.values_out,
                  "file for the field at the vertices of OUT, less the level: exactly 0 "
                  "at the vertices on the surface")
      ->type_name("SOL");
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
}

void add_place_rules(CLI::App& command, PlaceJob& job) {
  command.add_option("--level", job.level, "the value that the field takes on the surface")
      ->type_name("V")
      ->capture_default_str()
      ->check(number([](double x) { return std::isfinite(x); }, "a number"));
  command.add_option("--deviation", job.options.deviation, "split the surface where it deviates by more than this")
      ->type_name("D")
      ->check(positive_number());
  command.add_option("--q-max", job.options.Q_max, "largest Q that an inserted vertex may leave")
      ->type_name("Q")
      ->capture_default_str()
      ->check(number([](double x) { return x > 1 && std::isfinite(x); }, "a number above 1"));
  add_surface(command, job.options.surface, "vertices on planar patches move");
  add_ridge_angle(command, job.options.ridge_angle);
}

bool takes(const std::vector<double>& values, double level) {
  const auto [least, greatest] = std::ranges::minmax(values);
  return least <= level && level <= greatest;
}

Placed place_files(const PlaceJob& job) {
  const Mesh mesh = read_mesh(job.input);
  const std::vector<double> field = read_scalar(job.field, mesh.points.size());
  std::vector<double> values = field;
  for (double& value : values) value -= job.level;
  Placed placed = with_files(job.input, {{"metric: ", job.metric}, {"field: ", job.field}}, [&] {
    const Metric metric = job.metric.empty() ? Metric{implied_metric(mesh)} : read_metric(job.metric);
    return place_on_level_set(mesh, metric, values, job.options);
  });
  if (!takes(field, job.level)) throw no_surface(job.field, job.level, field);
  return placed;
}

Json place_json(const PlaceJob& job, const Placed& placed) {
  const PlaceOptions& o = job.options;
  Json json = {{"taut", TAUT_VERSION},
               {"input", job.input},
               {"field", job.field},
               {"metric", null_if_empty(job.metric)},
               {"output", job.output},
               {"metric_out", null_if_empty(job.metric_out)},
               {"values_out", null_if_empty(job.values_out)},
               {"level", job.level}};
  json["options"] = {{"deviation", o.deviation > 0 ? Json(o.deviation) : Json()},
                     {"q_max", o.Q_max},
                     {"surface", word_of(o.surface)},
                     {"angle", null_if_none(o.ridge_angle)}};
  json.update({{"moved", placed.moved}, {"inserted", placed.inserted}, {"crossed", placed.crossed}});
  json["on_surface"] = std::ranges::count(placed.values, 0.0);
  json["quality"] = json_of(placed.adapted.report.quality, true);
  return json;
}

void write_placed(const PlaceJob& job, const Placed& placed) {
  if (!job.metric_out.empty()) write_solution(job.metric_out, {field_of(placed.adapted.metric)});
  if (!job.values_out.empty()) write_solution(job.values_out, {{.kind = Field::Kind::scalar, .values = placed.values}});
  write_output(job.output, placed.adapted.mesh, {{.kind = Field::Kind::scalar, .values = placed.values}},
               placed.adapted.metric);
  if (!job.report.empty()) write_text(job.report, text_of(place_json(job, placed)));
}

void run_place(const PlaceJob& job) {
  const Stopwatch watch;
  require_output(job.output, mesh_outputs);
  require_output(job.metric_out, solution_files);
  require_output(job.values_out, solution_files);
  require_output(job.report, report_files);
  require_different("--metric-out", job.metric_out, "--values-out", job.values_out);
  const Placed placed = place_files(job);
  write_placed(job, placed);
  if (job.quiet) return;
  fmt::print("{} -> {}: {} vertices moved, {} inserted, {} edges still crossed, {:.2f} s\n\n{}", job.input, job.output,
             placed.moved, placed.inserted, placed.crossed, watch.seconds(),
             quality_table(placed.adapted.report.quality, true));
}

}  // namespace

void add_place(CLI::App& levelset, Job& job) {
  CLI::App* command = levelset.add_subcommand("place", "move and insert vertices onto the surface");
  const auto asked = std::make_shared<PlaceJob>();
  add_place_files(*command, *asked);
  add_place_rules(*command, *asked);
  command->add_flag("--quiet", asked->quiet, "print only errors");
  add_threads(*command, asked->threads);
  command->footer(place_examples);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_place(*asked); }); }; });
}

}  // namespace taut::program
