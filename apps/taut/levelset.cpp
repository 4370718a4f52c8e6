// taut levelset extract: writes the surface on which a field takes a value, and compares it with another surface.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "files.hpp"
#include "json.hpp"
#include "levelset_job.hpp"
#include "solution.hpp"
#include "stopwatch.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

struct Extracted {
  SurfaceMesh surface;
  SurfaceMeasures measures;
  std::optional<SurfaceDistance> distance;
};

Extracted extract(const ExtractJob& job) {
  const Mesh mesh = read_mesh(job.input);
  const std::vector<double> values = read_scalar(job.field, mesh.points.size());
  std::optional<SurfaceMesh> other;
  if (!job.compare.empty()) other = read_surface(job.compare);
  Extracted result;
  result.surface = with_files(job.input, job.field, [&] { return isosurface(mesh, values, job.level).surface; });
  if (result.surface.triangles.empty()) throw no_surface(job.field, job.level, values);
  result.measures = measure(result.surface);
  if (!other) return result;
  if (other->triangles.empty()) throw InputError(fmt::format("{}: no triangles found", job.compare));
  result.distance = distance(result.surface, *other, job.sampling);
  return result;
}

Json deviation_json(const Deviation& deviation) {
  return {{"worst", deviation.worst},
          {"where", deviation.where},
          {"mean", deviation.mean},
          {"area", deviation.area},
          {"samples", deviation.samples}};
}

Json extract_json(const ExtractJob& job, const Extracted& found) {
  const SurfaceMeasures& m = found.measures;
  Json json = {
      {"taut", TAUT_VERSION}, {"input", job.input}, {"field", job.field}, {"output", job.output}, {"level", job.level}};
  json["surface"] = {{"points", found.surface.points.size()},
                     {"triangles", found.surface.triangles.size()},
                     {"area", m.area},
                     {"open_edges", m.open_edges},
                     {"volume", m.open_edges == 0 ? Json(m.volume) : Json()}};
  json["compare"] = null_if_empty(job.compare);
  if (!found.distance) return json;
  json["distance"] = {{"to_other", deviation_json(found.distance->from_first)},
                      {"from_other", deviation_json(found.distance->from_second)},
                      {"worst", found.distance->worst},
                      {"mean", found.distance->mean}};
  return json;
}

std::string surface_text(const Extracted& found) {
  const SurfaceMeasures& m = found.measures;
  std::string text = fmt::format("points        {}\ntriangles     {}\narea          {:.9g}\n",
                                 found.surface.points.size(), found.surface.triangles.size(), m.area);
  if (m.open_edges > 0) return text + fmt::format("volume        none: the surface has {} open edges\n", m.open_edges);
  return text + fmt::format("volume        {:.9g} enclosed\n", m.volume);
}

std::string distance_text(const SurfaceDistance& d, const std::string& other) {
  const auto line = [](const char* way, double worst, double mean) {
    return fmt::format("  {:<12}worst {:.4g}, mean {:.4g}\n", way, worst, mean);
  };
  return fmt::format("\ndistance to {}\n", other) + line("to it", d.from_first.worst, d.from_first.mean) +
         line("from it", d.from_second.worst, d.from_second.mean) + line("both ways", d.worst, d.mean);
}

void run_extract(const ExtractJob& job) {
  const Stopwatch watch;
  require_output(job.output, mesh_files);
  require_output(job.report, report_files);
  const Extracted found = extract(job);
  write_surface(job.output, found.surface);
  if (!job.report.empty()) write_text(job.report, text_of(extract_json(job, found)));
  if (job.quiet) return;
  fmt::print("{} -> {}: {:.2f} s\n\n{}", job.input, job.output, watch.seconds(), surface_text(found));
  if (found.distance) fmt::print("{}", distance_text(*found.distance, job.compare));
}

void add_extract(CLI::App& levelset, Job& job) {
  CLI::App* command = levelset.add_subcommand("extract", "write the surface on which a field takes a value");
  const auto asked = std::make_shared<ExtractJob>();
  add_options(*command, *asked);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_extract(*asked); }); }; });
}

}  // namespace

void add_levelset(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("levelset", "surfaces on which a field takes a value");
  command->require_subcommand(1);
  add_extract(*command, job);
  add_place(*command, job);
}

}  // namespace taut::program
