#include "solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace taut::program {
namespace {

// Values that are not finite are refused when the file is read.
std::vector<Field> read_fitting(const std::string& file, std::size_t points) {
  std::vector<Field> fields = read_solution(file);
  for (const Field& field : fields)
    if (field.values.size() != points * field.size())
      throw InputError(fmt::format("{}: values for {} vertices found, expected {}, one per vertex of the mesh", file,
                                   field.values.size() / field.size(), points));
  return fields;
}

void add_numbers(const Field& field, const std::string& file, std::vector<std::vector<double>>& all) {
  if (field.kind == Field::Kind::tensor)
    throw InputError(fmt::format("{}: a tensor field found, expected scalars or vectors", file));
  for (std::size_t k = 0; k < field.size(); ++k) all.push_back(field.component(k));
}

}  // namespace

std::vector<Field> read_fields(std::span<const std::string> files, std::size_t points) {
  std::vector<Field> all;
  for (const std::string& file : files) {
    std::vector<Field> fields = read_fitting(file, points);
    all.insert(all.end(), std::make_move_iterator(fields.begin()), std::make_move_iterator(fields.end()));
  }
  return all;
}

std::vector<std::vector<double>> read_scalars(std::span<const std::string> files, std::size_t points) {
  std::vector<std::vector<double>> all;
  for (const std::string& file : files)
    for (const Field& field : read_fitting(file, points)) add_numbers(field, file, all);
  return all;
}

std::vector<double> read_scalar(const std::string& file, std::size_t points) {
  std::vector<Field> fields = read_fitting(file, points);
  if (fields.size() != 1) throw InputError(fmt::format("{}: {} fields found, expected one", file, fields.size()));
  if (fields[0].kind != Field::Kind::scalar)
    throw InputError(fmt::format("{}: {} numbers per vertex found, expected one", file, fields[0].size()));
  return std::move(fields[0].values);
}

InputError no_surface(const std::string& file, double level, std::span<const double> values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  return InputError(fmt::format("{}: no surface at the level {} found: the values range from {} to {}", file, level,
                                least, greatest));
}

}  // namespace taut::program
