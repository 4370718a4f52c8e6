// Measures and reports as text for people.
#pragma once

#include <string>

#include "taut/adapt.hpp"
#include "taut/quality.hpp"
#include "taut/solution.hpp"
#include "taut/transfer.hpp"

namespace taut::program {

/// Counts, measures and histograms. Without a metric the wanted lengths are unknown, so what needs them is left out.
[[nodiscard]] std::string quality_table(const Quality& quality, bool in_metric);

/// Operations and seconds of each pass, then the seconds of the phases outside the passes.
[[nodiscard]] std::string work_table(const Report& report);

/// The complexity, and what the transfer of the fields did.
[[nodiscard]] std::string solution_table(const SolutionResult& result);

/// Mass and range of each component before and after, the volumes, and the points outside.
[[nodiscard]] std::string transfer_table(const TransferReport& report);

}  // namespace taut::program
