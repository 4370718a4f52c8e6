// Names of files of which a run writes one per step.
#pragma once

#include <cstddef>
#include <string>

namespace taut::program {

/// A name such as `out-%04d.meshb`, where `%04d` stands for the number of a step with at least four digits.
class StepNames {
public:
  /// Throws InputError unless the name of the file, without its folder, contains `%0Nd` once, N from 1 to 9, and no
  /// other %.
  explicit StepNames(const std::string& pattern);

  /// The name for one step.
  [[nodiscard]] std::string operator()(std::size_t step) const;

private:
  std::string before_, after_;
  int digits_ = 0;
};

}  // namespace taut::program
