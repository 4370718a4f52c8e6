// Measures and reports as text for people.
#pragma once

#include <string>

#include "taut/adapt.hpp"
#include "taut/quality.hpp"

namespace taut::program {

/// Counts, measures and histograms. Without a metric the wanted lengths are unknown, so what needs them is left out.
[[nodiscard]] std::string quality_table(const Quality& quality, bool in_metric);

/// Operations and seconds of each pass, then the seconds of the phases outside the passes.
[[nodiscard]] std::string work_table(const Report& report);

}  // namespace taut::program
