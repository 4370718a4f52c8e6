#include "transfer/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require_sound(const Field& field, std::size_t number, std::size_t points) {
  const std::size_t size = field.size();
  if (field.values.size() != size * points)
    throw InputError(fmt::format("fields: field {}: {} values found, expected {} for each of {} vertices", number,
                                 field.values.size(), size, points));
  for_each_index(field.values.size(), [&](std::size_t i) {
    if (!std::isfinite(field.values[i]))
      throw InputError(fmt::format("fields: field {}: vertex {}, component {}: {} found, expected a finite number",
                                   number, i / size + 1, i % size + 1, field.values[i]));
  });
}

std::size_t components_of(const std::vector<Field>& fields) {
  std::size_t sum = 0;
  for (const Field& field : fields) sum += field.size();
  return sum;
}

}  // namespace

void require_sound(const std::vector<Field>& fields, std::size_t points) {
  if (fields.empty()) throw InputError("fields: none found, expected at least one");
  for (std::size_t i = 0; i < fields.size(); ++i) require_sound(fields[i], i + 1, points);
}

Values gathered(const std::vector<Field>& fields, std::span<const std::uint32_t> point_of_item) {
  Values values(components_of(fields), point_of_item.size());
  for_each_index(point_of_item.size(), [&](std::size_t i) {
    double* to = &values.all[i * values.size];
    for (const Field& field : fields) {
      const double* from = &field.values[point_of_item[i] * field.size()];
      to = std::copy(from, from + field.size(), to);
    }
  });
  return values;
}

std::vector<Field> split(const Values& values, const std::vector<Field>& like) {
  std::vector<Field> fields;
  std::size_t first = 0;
  for (const Field& old : like) {
    Field field{old.kind, std::vector<double>(old.size() * values.items())};
    for_each_index(values.items(), [&](std::size_t i) {
      for (std::size_t c = 0; c < field.size(); ++c) field.values[i * field.size() + c] = values[i][first + c];
    });
    first += field.size();
    fields.push_back(std::move(field));
  }
  return fields;
}

}  // namespace taut
