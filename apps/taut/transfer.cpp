// taut transfer: reads fields on one mesh, writes them on another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "check.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "json.hpp"
#include "options.hpp"
#include "stopwatch.hpp"
#include "table.hpp"
#include "taut/taut.hpp"

namespace taut::program {
namespace {

constexpr const char* transfer_examples =
    "Examples:\n"
    "  taut transfer old.meshb mach.solb new.meshb -o mach-new.solb\n"
    "  taut transfer old.meshb mach.solb new.meshb -o mach-new.solb --method linear --report out.json";

struct TransferJob {
  std::string from, fields, to, output;
  std::string report;  ///< empty: not written
  bool quiet = false;
  int threads = 0;
  TransferOptions options;
};

void add_transfer_options(CLI::App& command, TransferJob& job) {
  command.add_option("FROM", job.from, "old mesh, .mesh or .meshb")->required()->type_name("");
  command.add_option("FIELDS", job.fields, "fields at the vertices of FROM, .sol or .solb")->required()->type_name("");
  command.add_option("TO", job.to, "new mesh, .mesh or .meshb")->required()->type_name("");
  command.add_option("-o,--output", job.output, "file for the fields at the vertices of TO, .sol or .solb")
      ->required()
      ->type_name("OUT");
  add_method(command, "--method", job.options.method);
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
  command.add_flag("--quiet", job.quiet, "print only errors");
  add_threads(command, job.threads);
  command.footer(transfer_examples);
}

Transferred transfer_files(const TransferJob& job) {
  const Stopwatch watch;
  const Mesh from = read_mesh(job.from);
  const std::vector<Field> fields = read_solution(job.fields);
  const Mesh to = read_mesh(job.to);
  const double seconds = watch.seconds();
  Transferred result = with_files(job.from, {{"fields: ", job.fields}, {"target: ", job.to}},
                                  [&] { return transfer(from, fields, to, job.options); });
  result.report.seconds.emplace(result.report.seconds.begin(), "read", seconds);
  return result;
}

// The report is written last, because it holds the seconds that writing took.
void write_transfer(const TransferJob& job, Transferred& result) {
  const Stopwatch watch;
  write_solution(job.output, result.fields);
  result.report.seconds.emplace_back("write", watch.seconds());
  if (job.report.empty()) return;
  Json json = {
      {"taut", TAUT_VERSION}, {"from", job.from}, {"fields_file", job.fields}, {"to", job.to}, {"output", job.output}};
  json["options"] = {{"method", word_of(job.options.method)}, {"threads", job.threads}};
  json.update(json_of(result.report));
  write_text(job.report, text_of(json));
}

void run_transfer(const TransferJob& job) {
  const Stopwatch watch;
  require_output(job.output, solution_files);
  require_output(job.report, report_files);
  Transferred result = transfer_files(job);
  write_transfer(job, result);
  if (job.quiet) return;
  fmt::print("{}, {} -> {}, {}: {:.2f} s\n\n{}", job.from, job.fields, job.to, job.output, watch.seconds(),
             transfer_table(result.report));
}

}  // namespace

void add_transfer(CLI::App& app, Job& job) {
  CLI::App* command = app.add_subcommand("transfer", "transfer fields from one mesh to another");
  const auto asked = std::make_shared<TransferJob>();
  add_transfer_options(*command, *asked);
  command->callback([asked, &job] { job = [asked] { on_threads(asked->threads, [&] { run_transfer(*asked); }); }; });
}

}  // namespace taut::program
