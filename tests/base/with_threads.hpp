// The result of a computation on a given number of threads.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "taut/error.hpp"
#include "taut/threads.hpp"

namespace taut::test {

template <class Compute>
auto with_threads(int threads, Compute compute) {
  std::optional<decltype(compute())> result;
  on_threads(threads, [&] { result = compute(); });
  return *std::move(result);
}

/// The message with which the input is refused.
template <class Compute>
std::string refusal(int threads, Compute compute) {
  try {
    on_threads(threads, [&] { (void)compute(); });
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

}  // namespace taut::test
