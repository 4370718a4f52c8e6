// Options that several commands have.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "taut/metric.hpp"
#include "taut/sizing.hpp"
#include "taut/surface.hpp"
#include "taut/transfer.hpp"

namespace taut::program {

/// The option --complexity.
CLI::Option* add_complexity(CLI::App& command, double& complexity);

/// The option --norm.
CLI::Option* add_norm(CLI::App& command, double& norm);

/// The option --recovery.
CLI::Option* add_recovery(CLI::App& command, Recovery& recovery);

/// The option that chooses how fields get to another mesh; `name` is what the command calls it.
CLI::Option* add_method(CLI::App& command, const char* name, Transfer& method);

/// The option --surface; `adapt` says what the word adapt, the default, means.
void add_surface(CLI::App& command, Surface& surface, const std::string& adapt);

/// The option --size.
CLI::Option* add_size(CLI::App& command, std::optional<double>& size);

/// What it asks for.
[[nodiscard]] Metric metric_of_size(double size);

/// The option --angle.
void add_ridge_angle(CLI::App& command, double& degrees);
void add_ridge_angle(CLI::App& command, std::optional<double>& degrees);

/// The word for it on the command line.
[[nodiscard]] const char* word_of(Recovery recovery);
[[nodiscard]] const char* word_of(Transfer method);
[[nodiscard]] const char* word_of(Surface surface);

}  // namespace taut::program
