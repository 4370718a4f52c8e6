// The option --geometry: a file whose curved surface the vertices of the boundary are to lie on.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "taut/adapt.hpp"

namespace taut::program {

/// Adds the option; `more` says more of it. It fills `file`, which must outlive the command.
void add_geometry(CLI::App& command, std::string& file, const std::string& more);

/// Throws InputError for a file beside a surface that is kept: nothing would be moved onto it. `command` names the
/// command in the message.
void require_adapted_surface(const std::string& file, Surface surface, const std::string& command);

/// None if there is no file. Throws InputError, which names it.
[[nodiscard]] std::optional<Geometry> read_geometry(const std::string& file, std::optional<double> ridge_angle);

}  // namespace taut::program
