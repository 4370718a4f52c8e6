// Measures and reports as JSON, for programs. JSON has no infinity: numbers that are not finite become null.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "adapt_job.hpp"
#include "taut/adapt.hpp"
#include "taut/quality.hpp"
#include "taut/transfer.hpp"

namespace taut::program {

using Json = nlohmann::ordered_json;
using Phases = std::vector<std::pair<std::string, double>>;  ///< elapsed seconds by phase

/// The name of a file, or null if there is none.
[[nodiscard]] Json null_if_empty(const std::string& text);
/// The number, or null if there is none.
[[nodiscard]] Json null_if_none(const std::optional<double>& number);

[[nodiscard]] Json json_of_phases(const Phases& phases);

/// Histograms are lists of {from, to, count}; `to` of the last is null. What needs a metric is left out without one.
[[nodiscard]] Json json_of(const Quality& quality, bool in_metric);

[[nodiscard]] Json json_of(const Report& report);
[[nodiscard]] Json json_of(const AdaptJob& job);
[[nodiscard]] Json json_of(const TransferReport& report);

/// The parts "sizing" and "transfer" of an adaptation to fields.
[[nodiscard]] Json json_of(const FieldJob& job, const SolutionResult& result);

/// Indented; bytes of file names that are not UTF-8 are replaced.
[[nodiscard]] std::string text_of(const Json& json);

}  // namespace taut::program
