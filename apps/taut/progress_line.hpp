// The progress of the work, on one line of the terminal that is rewritten after each pass or step.
#pragma once

#include "taut/adapt.hpp"
#include "taut/quality.hpp"

namespace taut::program {

/// Prints nothing if standard error is not a terminal. The line is erased at the end.
class ProgressLine {
public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  void show_expected(double tetrahedra);
  void show_step(std::size_t step, std::size_t steps, const Quality& quality);

private:
  bool shown_;
};

}  // namespace taut::program
