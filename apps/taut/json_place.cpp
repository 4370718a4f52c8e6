#include "json_place.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <set>
#include <vector>

namespace taut::program {
namespace {

constexpr std::size_t longest_excerpt = 40;

/// The value in one line, cut where it gets long.
std::string excerpt(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > longest_excerpt) text = text.substr(0, longest_excerpt) + "...";
  return text;
}

/// Looks for keys that an object has twice: the parser would keep the last one only, without a word.
class RepeatedKeys {
public:
  explicit RepeatedKeys(const std::string& file) : file_(file) {}

  bool operator()(int, nlohmann::json::parse_event_t event, nlohmann::json& value) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(value.get<std::string>()).second)
      throw InputError(fmt::format("{}: key {} found twice in one object", file_, excerpt(value)));
    return true;
  }

private:
  const std::string& file_;
  std::vector<std::set<std::string>> keys_;  // of the objects around the present place
};

/// The parser's message without the parts that speak of the parser.
std::string complaint_of(const nlohmann::json::exception& error) {
  const std::string message = error.what();
  const std::size_t begin = message.find("] ");
  return begin == std::string::npos ? message : message.substr(begin + 2);
}

}  // namespace

JsonPlace JsonPlace::at(std::string_view key) const {
  const auto found = value_->find(key);
  if (found == value_->end()) fail(fmt::format("key \"{}\" expected, not found", key));
  return {*file_, way_.empty() ? std::string(key) : fmt::format("{}.{}", way_, key), *found};
}

JsonPlace JsonPlace::entry(std::size_t i) const {
  return {*file_, fmt::format("{}[{}]", way_, i), (*value_)[i]};
}

void JsonPlace::require_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) expected("an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    fail(fmt::format("unknown key {} found, expected {}", excerpt(key), fmt::join(keys, ", ")));
  }
}

double JsonPlace::number() const {
  if (!value_->is_number()) expected("a number");
  return value_->get<double>();
}

int JsonPlace::reference() const {
  constexpr std::string_view what = "a reference, which is a 32-bit integer,";
  constexpr std::int64_t least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  if (!value_->is_number_integer()) expected(what);
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > std::uint64_t{most}) expected(what);
  const auto number = value_->get<std::int64_t>();
  if (number < least) expected(what);
  return static_cast<int>(number);
}

std::array<double, 3> JsonPlace::three_numbers() const {
  const auto is_number = [](const nlohmann::json& value) { return value.is_number(); };
  if (!value_->is_array() || value_->size() != 3 || !std::all_of(value_->begin(), value_->end(), is_number))
    expected("three numbers");
  return value_->get<std::array<double, 3>>();
}

std::string JsonPlace::text(std::string_view what) const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) expected(what);
  return value_->get<std::string>();
}

void JsonPlace::expected(std::string_view what) const {
  fail(fmt::format("{} expected, found {}", what, excerpt(*value_)));
}

void JsonPlace::fail(std::string_view message) const {
  throw InputError(way_.empty() ? fmt::format("{}: {}", *file_, message)
                                : fmt::format("{}: {}: {}", *file_, way_, message));
}

nlohmann::json read_json(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("{}: cannot be read", file));
  try {
    return nlohmann::json::parse(in, RepeatedKeys(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file, complaint_of(error)));
  }
}

}  // namespace taut::program
