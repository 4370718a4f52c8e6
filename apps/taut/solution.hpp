// Solution files as the work needs them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "taut/taut.hpp"

namespace taut::program {

/// All fields of all files, in their order. Throws InputError, naming the file, unless each has finite values for
/// `points` vertices.
[[nodiscard]] std::vector<Field> read_fields(std::span<const std::string> files, std::size_t points);

/// Every number that stands at the vertices in the files, as one array each: scalars, and the components of vectors.
/// Throws InputError for a tensor too.
[[nodiscard]] std::vector<std::vector<double>> read_scalars(std::span<const std::string> files, std::size_t points);

/// The only number that stands at the vertices in the file. Throws InputError if there are more.
[[nodiscard]] std::vector<double> read_scalar(const std::string& file, std::size_t points);

/// The error of a file whose values nowhere take the level.
[[nodiscard]] InputError no_surface(const std::string& file, double level, std::span<const double> values);

}  // namespace taut::program
