#include "command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "taut/error.hpp"
#include "taut/version.hpp"

namespace taut::program {
namespace {

/// The innermost command that the words chose: "extract" of "taut levelset extract".
const CLI::App& chosen_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : chosen_command(*chosen.front());
}

std::string names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  const std::string last = names.back();
  names.pop_back();
  return names.empty() ? last : fmt::format("{} or {}", fmt::join(names, ", "), last);
}

bool needs_command(const CLI::App& app) {
  return app.get_require_subcommand_min() > 0;
}

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  // An unknown word explains why others seem to be missing, so it is named first.
  for (const std::string& word : app.remaining(true)) {
    return fmt::format("unknown {} {}", word.starts_with('-') ? "option" : "word", word);
  }
  if (const CLI::App& command = chosen_command(app); needs_command(command))
    return fmt::format("no command found, expected {}", names_of_commands(command));

  std::string text = error.what();
  if (error.get_name() != "ArgumentMismatch") return text;
  const char* expected = text.ends_with(" missing") ? "a value" : "exactly one value";
  return fmt::format("{}: expected {}", text.substr(0, text.find(':')), expected);
}

std::string help_command(const CLI::App& app) {
  std::string words = app.get_name();
  for (const CLI::App* command = &app; !command->get_subcommands().empty();) {
    command = command->get_subcommands().front();
    words += ' ' + command->get_name();
  }
  return words + " --help";
}

/// False if the words asked for help or the version, which is then printed.
bool parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::Success& asked) {
    app.exit(asked);
    return false;
  } catch (const CLI::ParseError& error) {
    throw InputError(fmt::format("{}; see '{}'", complaint(app, error), help_command(app)));
  }
}

}  // namespace

void run(int argc, char** argv) {
  CLI::App app("taut: anisotropic adaptation of tetrahedral meshes", "taut");
  app.set_version_flag("--version", "taut " TAUT_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 success, 1 the work could not be done, 2 wrong usage or unusable input.\n"
      "Files: Gamma Mesh Format, .mesh and .sol (text), .meshb and .solb (binary).");
  Job job;
  add_adapt(app, job);
  add_levelset(app, job);
  add_metric(app, job);
  add_move(app, job);
  add_quality(app, job);
  add_transfer(app, job);
  if (parse(app, argc, argv)) job();
}

}  // namespace taut::program
