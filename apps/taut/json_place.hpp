// A value in a JSON file that a user wrote, with its place, so that errors can name it.
#pragma once

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "taut/error.hpp"

namespace taut::program {

/// A value and the way to it, as in `motion.json: bodies[1].rotation.axis`. It refers to the file's values, which must
/// outlive it. The functions that read throw InputError for a value of another kind.
class JsonPlace {
public:
  JsonPlace(const std::string& file, const nlohmann::json& value) : JsonPlace(file, "", value) {}

  /// The value of a key that must be there.
  [[nodiscard]] JsonPlace at(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return value_->contains(key); }

  /// Throws InputError unless this is an object whose keys are all among these.
  void require_keys(std::initializer_list<std::string_view> keys) const;

  /// Calls work(place) for each entry of an array; `what` says what it consists of.
  template <class Work>
  void for_each(std::string_view what, Work work) const {
    if (!value_->is_array()) expected(what);
    for (std::size_t i = 0; i < value_->size(); ++i) work(entry(i));
  }

  /// Calls work(key, place of its value) for each key of an object; `what` says what its keys are.
  template <class Work>
  void for_each_key(std::string_view what, Work work) const {
    if (!value_->is_object()) expected(what);
    for (const auto& item : value_->items()) work(item.key(), at(item.key()));
  }

  [[nodiscard]] std::size_t size() const { return value_->size(); }

  [[nodiscard]] double number() const;
  [[nodiscard]] int reference() const;
  [[nodiscard]] std::array<double, 3> three_numbers() const;
  [[nodiscard]] std::string text(std::string_view what) const;

  /// Throws InputError: the file, the place, `what` was expected and the value that was found.
  [[noreturn]] void expected(std::string_view what) const;
  /// Throws InputError: the file, the place and the message.
  [[noreturn]] void fail(std::string_view message) const;

private:
  JsonPlace(const std::string& file, std::string way, const nlohmann::json& value)
      : file_(&file), way_(std::move(way)), value_(&value) {}

  [[nodiscard]] JsonPlace entry(std::size_t i) const;

  const std::string* file_;
  std::string way_;
  const nlohmann::json* value_;
};

/// Reads a JSON file. Throws InputError if it cannot be read, is not JSON or gives a key twice in one object.
[[nodiscard]] nlohmann::json read_json(const std::string& file);

}  // namespace taut::program
