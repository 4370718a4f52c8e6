// Measures and reports as JSON, for programs. Numbers that are not finite become null.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "adapt_job.hpp"
#include "taut/adapt.hpp"
#include "taut/quality.hpp"

namespace taut::program {

using Json = nlohmann::ordered_json;

/// Histograms are lists of {from, to, count}. Without a metric what needs one is left out.
[[nodiscard]] Json json_of(const Quality& quality, bool in_metric);

[[nodiscard]] Json json_of(const Report& report);
[[nodiscard]] Json json_of(const AdaptJob& job);

/// Indented; bytes of file names that are no UTF-8 are replaced.
[[nodiscard]] std::string text_of(const Json& json);

}  // namespace taut::program
