// What the adaptation is doing, on one line of a terminal that is rewritten.
#pragma once

#include "taut/adapt.hpp"

namespace taut::program {

/// Silent when standard error is no terminal. The line is wiped out at the end.
class ProgressLine {
public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);

private:
  bool shown_;
};

}  // namespace taut::program
