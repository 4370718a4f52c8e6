// The options --hmin, --hmax, --anisotropy, --gradation and --gradation-mix.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>

#include "taut/limits.hpp"

namespace taut::program {

struct AskedLimits {
  Limits bounds;                 ///< without `gradation`
  std::optional<double> beta;    ///< of the gradation; none: no gradation
  double mix = Gradation{}.mix;  ///< of the gradation
};

/// Adds the options to `command`; they fill `limits`, which must outlive it.
void add_limits(CLI::App& command, AskedLimits& limits);

[[nodiscard]] Limits limits_of(const AskedLimits& asked);

/// Throws InputError if the limits contradict each other. `command` is named in the message.
void require_sound(const AskedLimits& limits, std::string_view command);

}  // namespace taut::program
