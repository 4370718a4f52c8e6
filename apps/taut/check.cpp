#include "check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "taut/threads.hpp"

namespace taut::program {

std::optional<double> number_in(std::string_view word) {
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || last != end) return std::nullopt;
  return value;
}

CLI::Validator number(std::function<bool(double)> fits, std::string expected) {
  const auto check = [fits = std::move(fits), expected = std::move(expected)](const std::string& word) {
    const std::optional<double> value = number_in(word);
    return value && fits(*value) ? std::string() : fmt::format("{} found, expected {}", word, expected);
  };
  return CLI::Validator(check, "");
}

CLI::Validator positive_number() {
  return number([](double x) { return x > 0 && std::isfinite(x); }, "a number above 0");
}

CLI::Validator count() {
  constexpr int most = std::numeric_limits<int>::max();
  return number([](double x) { return x >= 0 && x <= most && x == std::floor(x); }, "a whole number, 0 or more");
}

void add_threads(CLI::App& command, int& threads) {
  const auto fits = [](double x) { return x >= 0 && x <= most_threads && x == std::floor(x); };
  command
      .add_option("--threads", threads,
                  "at most this many threads; 0 (the default): one per core. The result does not depend on it")
      ->type_name("N")
      ->check(number(fits, fmt::format("a whole number, 0 to {}", most_threads)));
}

CLI::Validator word_or(std::string word, const CLI::Validator& other) {
  const auto check = [word = std::move(word), other](const std::string& found) {
    if (found == word) return std::string();
    const std::string complaint = other(found);
    return complaint.empty() ? complaint : fmt::format("{}, or {}", complaint, word);
  };
  return CLI::Validator(check, "");
}

CLI::Validator one_of(std::vector<std::string> words) {
  const auto check = [words = std::move(words)](const std::string& found) {
    if (std::ranges::find(words, found) != words.end()) return std::string();
    const std::span others(words.begin(), words.end() - 1);
    return fmt::format("{} found, expected {} or {}", found, fmt::join(others, ", "), words.back());
  };
  return CLI::Validator(check, "");
}

}  // namespace taut::program
