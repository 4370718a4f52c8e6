// The components of all fields, vertex by vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "taut/field.hpp"

namespace taut {

/// All components of all fields in one array: component c of item i is at i * size + c.
struct Values {
  std::size_t size = 0;  ///< components
  std::vector<double> all;

  Values(std::size_t components, std::size_t items) : size(components), all(components * items) {}
  [[nodiscard]] std::span<const double> operator[](std::size_t i) const { return {&all[i * size], size}; }
  [[nodiscard]] std::span<double> operator[](std::size_t i) { return {&all[i * size], size}; }
  [[nodiscard]] std::size_t items() const { return size == 0 ? 0 : all.size() / size; }
};

/// Throws InputError, whose message starts with "fields: ", unless there is a field, and each has finite values for
/// `points` points.
void require_sound(const std::vector<Field>& fields, std::size_t points);

/// The values of item i of the result are those of point `point_of_item[i]`.
[[nodiscard]] Values gathered(const std::vector<Field>& fields, std::span<const std::uint32_t> point_of_item);

/// Fields of the kinds of `like` with one point per item.
[[nodiscard]] std::vector<Field> split(const Values& values, const std::vector<Field>& like);

}  // namespace taut
