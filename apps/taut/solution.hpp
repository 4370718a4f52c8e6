// Solution files as the work needs them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "taut/taut.hpp"

namespace taut::program {

/// Every number that stands at the vertices in the files, as one array each: scalars, and the components of vectors.
/// Throws InputError for a tensor, and unless all have `points` finite values: naming the file.
[[nodiscard]] std::vector<std::vector<double>> read_scalars(std::span<const std::string> files, std::size_t points);

/// A tensor field for write_solution().
[[nodiscard]] Field field_of(const Tensors& tensors);

}  // namespace taut::program
