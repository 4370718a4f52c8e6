#include "errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <string>

#include "taut/error.hpp"

namespace taut::program {
namespace {

int report(std::string message, ExitStatus status) {
  std::replace(message.begin(), message.end(), '\n', ' ');  // scripts rely on one line
  fmt::print(stderr, "taut: error: {}\n", message);
  return status;
}

}  // namespace

int exit_status_of(const std::function<void()>& work) {
  try {
    work();
    // On a full disk, what is still in the buffer would otherwise be lost without an error.
    if (std::fflush(stdout) != 0) throw Failure("standard output: cannot be written");
    return done;
  } catch (const InputError& error) {
    return report(error.what(), misused);
  } catch (const std::bad_alloc&) {
    return report("out of memory", not_done);
  } catch (const std::exception& error) {
    return report(error.what(), not_done);
  }
}

}  // namespace taut::program
