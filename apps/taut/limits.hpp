// The options --hmin, --hmax, --anisotropy and --gradation.
#pragma once

#include <CLI/CLI.hpp>

#include "taut/sizing.hpp"

namespace taut::program {

/// Adds the options to `command`; they fill `limits`, which must outlive it.
void add_limits(CLI::App& command, Limits& limits);

/// The option --norm.
void add_norm(CLI::App& command, double& norm);

/// Throws InputError if the limits contradict each other.
void require_sound(const Limits& limits, const CLI::App& command);

}  // namespace taut::program
