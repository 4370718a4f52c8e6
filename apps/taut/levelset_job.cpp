#include "levelset_job.hpp"

#include <cmath>

#include "check.hpp"

namespace taut::program {
namespace {

constexpr const char* extract_examples =
    "Examples:\n"
    "  taut levelset extract box.meshb distance.solb -o interface.meshb\n"
    "  taut levelset extract room.meshb heat.sol --level 20 -o isotherm.mesh\n"
    "  taut levelset extract box.meshb u.solb -o s.meshb --compare exact.meshb --report s.json";

}  // namespace

void add_options(CLI::App& command, ExtractJob& job) {
  command.add_option("IN", job.input, "mesh, .mesh or .meshb")->required()->type_name("");
  command.add_option("FIELD", job.field, "numbers at the vertices of IN, .sol or .solb")->required()->type_name("");
  command.add_option("-o,--output", job.output, "file for the surface, .mesh or .meshb")->required()->type_name("OUT");
  command.add_option("--level", job.level, "the value that the field takes on the surface")
      ->type_name("V")
      ->capture_default_str()
      ->check(number([](double x) { return std::isfinite(x); }, "a number"));
  command.add_option("--compare", job.compare, "mesh whose triangles are another surface: measure the distances")
      ->type_name("OTHER");
  command
      .add_option(
          "--spacing", job.sampling.spacing,
          "largest distance between the samples that --compare takes on a triangle; by default a five-hundredth "
          "of the diagonal of the box around both surfaces")
      ->type_name("H")
      ->check(positive_number());
  command
      .add_option("--divisions", job.sampling.divisions,
                  "at least so many parts of each edge between the samples that --compare takes on a triangle")
      ->type_name("N")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 1 && x <= 1000 && x == std::floor(x); }, "a whole number, 1 to 1000"));
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
  command.add_flag("--quiet", job.quiet, "print only errors");
  add_threads(command, job.threads);
  command.footer(extract_examples);
}

}  // namespace taut::program
