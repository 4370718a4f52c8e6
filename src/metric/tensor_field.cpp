// Between tensors and the numbers of a field.
#include <fmt/format.h>

#include <algorithm>

#include "taut/field.hpp"

namespace taut {

Field field_of(const Tensors& tensors) {
  Field field{.kind = Field::Kind::tensor, .values = {}};
  field.values.reserve(field.size() * tensors.size());
  for (const Tensor& tensor : tensors) field.values.insert(field.values.end(), tensor.begin(), tensor.end());
  return field;
}

Tensors tensors_of(const Field& field) {
  if (field.kind != Field::Kind::tensor)
    throw InputError(fmt::format("field: {} numbers per vertex found, expected a tensor, which has six", field.size()));
  if (field.values.size() % field.size() != 0)
    throw InputError(fmt::format("field: {} numbers found, expected six per vertex", field.values.size()));
  Tensors tensors(field.values.size() / field.size());
  for (std::size_t v = 0; v < tensors.size(); ++v)
    std::copy_n(&field.values[field.size() * v], field.size(), tensors[v].begin());
  return tensors;
}

}  // namespace taut
