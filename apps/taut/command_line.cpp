#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "taut/error.hpp"
#include "taut/version.hpp"

namespace taut::program {
namespace {

// "adapt, quality or transfer"
std::string commands_of(const CLI::App& app) {
  std::string list;
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  for (std::size_t i = 0; i < commands.size(); ++i)
    list += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " or ") + commands[i]->get_name();
  return list;
}

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  // An unknown word explains why others seem to be missing, so it is named first.
  for (const std::string& word : app.remaining(true)) {
    return fmt::format("unknown {} {}", word.starts_with('-') ? "option" : "word", word);
  }
  if (app.get_subcommands().empty()) return "no command found, expected " + commands_of(app);

  std::string text = error.what();
  if (error.get_name() != "ArgumentMismatch") return text;
  return text.substr(0, text.find(':')) + ": expected exactly one value";
}

std::string help_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? "taut --help" : fmt::format("taut {} --help", chosen.front()->get_name());
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
  add_quality(app, job);
  add_transfer(app, job);
  if (parse(app, argc, argv)) job();
}

}  // namespace taut::program
