#include "solution.hpp"

#include <fmt/format.h>

#include <cmath>

namespace taut::program {
namespace {

void add_components(const Field& field, const std::string& file, std::vector<std::vector<double>>& all) {
  if (field.kind == Field::Kind::tensor)
    throw InputError(fmt::format("{}: a tensor field found, expected scalars or vectors", file));
  for (std::size_t k = 0; k < field.size(); ++k) all.push_back(field.component(k));
}

void require_finite(const Field& field, const std::string& file) {
  for (std::size_t i = 0; i < field.values.size(); ++i)
    if (!std::isfinite(field.values[i]))
      throw InputError(
          fmt::format("{}: vertex {}: value {} is not finite", file, i / field.size() + 1, field.values[i]));
}

}  // namespace

std::vector<std::vector<double>> read_scalars(std::span<const std::string> files, std::size_t points) {
  std::vector<std::vector<double>> all;
  for (const std::string& file : files)
    for (const Field& field : read_solution(file)) {
      if (field.values.size() != points * field.size())
        throw InputError(fmt::format("{}: values for {} vertices found, expected {}, one per vertex of the mesh", file,
                                     field.values.size() / field.size(), points));
      require_finite(field, file);
      add_components(field, file, all);
    }
  return all;
}

Field field_of(const Tensors& tensors) {
  Field field{.kind = Field::Kind::tensor, .values = {}};
  field.values.reserve(6 * tensors.size());
  for (const Tensor& m : tensors) field.values.insert(field.values.end(), m.begin(), m.end());
  return field;
}

}  // namespace taut::program
