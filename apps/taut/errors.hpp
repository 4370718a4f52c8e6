// Where every error ends: one line on standard error and the exit status.
#pragma once

#include <functional>

namespace taut::program {

enum ExitStatus : int {
  done = 0,
  not_done = 1,  ///< the input was sound, but the work could not be done, was cancelled, or a check failed
  misused = 2,   ///< the command line or the input cannot be used
};

/// Calls work() and reports what it throws.
[[nodiscard]] int exit_status_of(const std::function<void()>& work);

}  // namespace taut::program
