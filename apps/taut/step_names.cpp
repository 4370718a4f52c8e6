#include "step_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "taut/error.hpp"

namespace taut::program {

StepNames::StepNames(const std::string& pattern) {
  constexpr std::size_t length = std::string_view("%04d").size();
  const std::size_t folder = pattern.rfind('/') + 1;  // 0 if there is none
  const std::size_t at = pattern.find('%');
  const std::string_view place = std::string_view(pattern).substr(std::min(at, pattern.size()), length);
  const bool is_place =
      place.size() == length && place[1] == '0' && place[2] >= '1' && place[2] <= '9' && place[3] == 'd';
  if (!is_place || at < folder || pattern.find('%', at + 1) != std::string::npos)
    throw InputError(
        fmt::format("{}: expected the step's number once in the file's name, as in out-%04d.meshb", pattern));
  before_ = pattern.substr(0, at);
  after_ = pattern.substr(at + length);
  digits_ = place[2] - '0';
}

std::string StepNames::operator()(std::size_t step) const {
  return fmt::format("{}{:0{}}{}", before_, step, digits_, after_);
}

}  // namespace taut::program
