#include "move_job.hpp"

#include <cmath>
#include <limits>

#include "check.hpp"
#include "geometry_file.hpp"
#include "options.hpp"
#include "taut/error.hpp"

namespace taut::program {
namespace {

constexpr const char* move_help =
    "--motion names a JSON file with the amounts of one step:\n"
    "  {\"bodies\": [{\"references\": [7, 8], \"translation\": [0, 0, -0.1]},\n"
    "              {\"references\": [9], \"rotation\": {\"centre\": [0, 0, 0], \"axis\": [0, 0, 1], \"degrees\": "
    "3.6}},\n"
    "              {\"references\": [5], \"motions\": [{\"rotation\": {...}}, {\"translation\": [...]}]}],\n"
    "   \"fixed\": [1], \"sliding\": [2]}\n"
    "References are those of triangles; all others are fixed. \"motions\" are done one after the other. Instead, each\n"
    "body may have \"displacements\": \"FILE.solb\", one vector per vertex; then --mode is move or flips.\n"
    "\n"
    "If a body cannot pass, the last valid mesh of that step is written, and the exit status is 1.\n"
    "\n"
    "Examples:\n"
    "  taut move rotor.meshb --motion rotor.json --steps 100 -o out-%04d.meshb\n"
    "  taut move rotor.meshb --motion rotor.json --steps 100 --follow share -o out-%04d.vtu --every 5\n"
    "  taut move box.meshb --motion m.json --steps 20 --metric m.solb --fields u.solb --fields-out u-%04d.solb "
    "-o out-%04d.meshb --report out.json";

void add_move_inputs(CLI::App& command, MoveJob& job) {
  command.add_option("IN", job.input, "mesh, .mesh or .meshb")->required()->type_name("");
  command.add_option("--motion", job.motion, "what moves, and how far per step, .json")->required()->type_name("FILE");
  command.add_option("--steps", job.steps, "number of steps")
      ->required()
      ->type_name("N")
      ->check(number([](double x) { return x >= 1 && x <= 1e9 && x == std::floor(x); }, "a whole number, 1 or more"));
  command
      .add_option("--metric", job.metric,
                  "sizes or tensors at the vertices of IN, .sol or .solb; by default those that the mesh has")
      ->type_name("SOL");
  add_size(command, job.size);
  command.add_option("--fields", job.fields, "fields at the vertices of IN, .sol or .solb, that are carried along")
      ->type_name("SOL");
}

void add_move_outputs(CLI::App& command, MoveJob& job) {
  command
      .add_option("-o,--output", job.output,
                  "files for the meshes, .mesh, .meshb or .vtu, for ParaView; %04d stands for the number of the step, "
                  "0 for the beginning")
      ->required()
      ->type_name("OUT");
  command.add_option("--fields-out", job.fields_out, "files for the fields, .sol or .solb, with %04d too")
      ->type_name("SOL");
  command.add_option("--metric-out", job.metric_out, "files for the metric, .sol or .solb, with %04d too")
      ->type_name("SOL");
  command
      .add_option("--pvd", job.pvd,
                  "file that lists the .vtu files with their steps, .pvd; by default OUT without the number")
      ->type_name("FILE");
  command.add_option("--every", job.every, "write the beginning, each K-th step and the last one")
      ->type_name("K")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 1 && x <= 1e9 && x == std::floor(x); }, "a whole number, 1 or more"));
  command.add_option("--report", job.report, "file for a report, .json")->type_name("FILE");
  command.add_flag("--quiet", job.quiet, "print only errors");
}

void add_changes(CLI::App& command, MotionOptions& options) {
  const auto set_changes = [&options](const std::string& word) {
    for (const MeshChanges changes : {MeshChanges::nothing, MeshChanges::flips, MeshChanges::all})
      if (word == word_of(changes)) options.changes = changes;
  };
  command
      .add_option_function<std::string>("--mode", set_changes,
                                        "all (the default): vertices come and go; flips: they keep their numbers; "
                                        "move: tetrahedra stay too")
      ->type_name("WORD")
      ->check(one_of({"move", "flips", "all"}));
  const auto set_following = [&options](const std::string& word) {
    options.following = word == word_of(Following::share) ? Following::share : Following::elastic;
  };
  command
      .add_option_function<std::string>("--follow", set_following,
                                        "elastic (the default): the inside follows as an elastic body; share: by "
                                        "shares of the bodies' motions, for bodies that turn")
      ->type_name("WORD")
      ->check(one_of({"elastic", "share"}));
}

void add_motion_rules(CLI::App& command, MotionOptions& options) {
  add_changes(command, options);
  command.add_option("--rounds", options.rounds, "rounds of optimisation after each step")
      ->type_name("N")
      ->capture_default_str()
      ->check(count());
  command.add_option("--stiffening", options.stiffening, "the stiffness of a tetrahedron is 1 / volume to this power")
      ->type_name("P")
      ->capture_default_str()
      ->check(number([](double x) { return x >= 0 && std::isfinite(x); }, "a number, 0 or more"));
  command.add_option("--shell", options.shell, "layers of vertices around a body that move as it does")
      ->type_name("N")
      ->capture_default_str()
      ->check(count());
  const auto is_reference = [](double x) {
    return std::abs(x) <= std::numeric_limits<int>::max() && x == std::floor(x);
  };
  command
      .add_option_function<std::string>(
          "--metric-follows",
          [&options](const std::string& word) { options.metric_follows = static_cast<int>(*number_in(word)); },
          "the metric follows the body with this reference; by default it is that of a place")
      ->type_name("REF")
      ->check(number(is_reference, "a reference of triangles"));
}

}  // namespace

void add_options(CLI::App& command, MoveJob& job) {
  add_move_inputs(command, job);
  add_move_outputs(command, job);
  add_motion_rules(command, job.options);
  add_method(command, "--transfer", job.options.transfer);
  add_limits(command, job.limits);
  add_surface(command, job.options.adaptation.surface, "remesh patches, those of bodies as they move");
  add_geometry(command, job.geometry, "it moves with the bodies");
  add_ridge_angle(command, job.options.adaptation.ridge_angle);
  add_threads(command, job.threads);
  command.footer(move_help);
}

void require_sound(const MoveJob& job) {
  if (!job.metric.empty() && job.size)
    throw InputError("--metric and --size found, expected at most one of them; see 'taut move --help'");
  require_sound(job.limits, "move");
  require_adapted_surface(job.geometry, job.options.adaptation.surface, "move");
  if (!job.fields_out.empty() && job.fields.empty())
    throw InputError("--fields-out found without --fields; see 'taut move --help'");
  if (!job.fields.empty() && job.fields_out.empty() && !job.output.ends_with(".vtu"))
    throw InputError("--fields found, expected --fields-out too, or .vtu files, which hold the fields");
}

const char* word_of(MeshChanges changes) {
  if (changes == MeshChanges::all) return "all";
  return changes == MeshChanges::flips ? "flips" : "move";
}

const char* word_of(Following following) {
  return following == Following::share ? "share" : "elastic";
}

}  // namespace taut::program
