// The subcommands. Each adds itself to the command line and, when it is chosen, sets the job to do.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace taut::program {

using Job = std::function<void()>;

void add_adapt(CLI::App& app, Job& job);
void add_levelset(CLI::App& app, Job& job);
void add_metric(CLI::App& app, Job& job);
void add_move(CLI::App& app, Job& job);
void add_place(CLI::App& levelset, Job& job);  ///< to the command `levelset`
void add_quality(CLI::App& app, Job& job);
void add_transfer(CLI::App& app, Job& job);

}  // namespace taut::program
