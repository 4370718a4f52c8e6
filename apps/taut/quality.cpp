// taut quality: measures a mesh, by itself or in a metric, and checks it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "check.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "json.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  taut quality wing.meshb --metric wing-met.solb\n"
    "  taut quality part.mesh --check\n"
    "  taut quality part.mesh --json > part.json";

struct QualityJob {
  std::string input, metric;
  bool json = false, check = false;
  int threads = 0;
};

struct Findings {
  Quality quality;
  std::vector<std::string> defects;
};

Metric metric_of(const QualityJob& job) {
  if (!job.metric.empty()) return read_metric(job.metric);
  return [](const Point&) { return Tensor{1, 0, 0, 1, 0, 1}; };  // Euclidean lengths and shapes
}

Findings examine(const QualityJob& job) {
  const Mesh mesh = read_mesh(job.input);
  const Metric metric = metric_of(job);
  return with_files(job.input, {{"metric: ", job.metric}}, [&] {
    return Findings{measure(mesh, metric), defects(mesh)};
  });
}

std::string json_text(const QualityJob& job, const Findings& findings) {
  Json json = {{"taut", TAUT_VERSION}, {"input", job.input}, {"metric", nullptr}};
  if (!job.metric.empty()) json["metric"] = job.metric;
  json["quality"] = json_of(findings.quality, !job.metric.empty());
  json["defects"] = findings.defects;
  return text_of(json);
}

std::string table_text(const QualityJob& job, const Findings& findings) {
  std::string text = quality_table(findings.quality, !job.metric.empty());
  text += findings.defects.empty() ? "\nconformity: no defects\n" : "\nconformity: defects found\n";
  for (const std::string& defect : findings.defects) text += fmt::format("  {}\n", defect);
  return text;
}

void run_quality(const QualityJob& job) {
  const Findings findings = examine(job);
  fmt::print("{}", job.json ? json_text(job, findings) : table_text(job, findings));
  if (job.check && !findings.defects.empty())
    throw Failure(fmt::format("{}: {} kinds of defects found, expected none", job.input, findings.defects.size()));
}

}  // namespace

void add_quality(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("quality", "measure a mesh and check that it is conforming");
  const auto asked = std::make_shared<QualityJob>();
  command->add_option("IN", asked->input, "mesh to measure, .mesh or .meshb")->required()->type_name("");
  command->add_option("--metric", asked->metric, "sizes or tensors at the vertices of IN, .sol or .solb")
      ->type_name("SOL");
  command->add_flag("--json", asked->json, "print JSON instead of the table");
  command->add_flag("--check", asked->check, "exit with status 1 if the mesh has any defect");
  add_threads(*command, asked->threads);
  command->footer(examples);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_quality(*asked); }); }; });
}

}  // namespace taut::program
