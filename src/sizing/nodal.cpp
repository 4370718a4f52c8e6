#include "sizing/nodal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

void require_one_per_point(std::size_t found, std::size_t points) {
  if (found != points)
    throw InputError(fmt::format("field: {} values for {} vertices, expected one per vertex", found, points));
}

}  // namespace

void require_values(std::span<const double> values, std::size_t points) {
  require_one_per_point(values.size(), points);
  for_each_index(points, [&](std::size_t i) {
    if (!std::isfinite(values[i]))
      throw InputError(fmt::format("field: vertex {}: value {} is not finite", i + 1, values[i]));
  });
}

void require_tensors(std::span<const Tensor> tensors, std::size_t points) {
  require_one_per_point(tensors.size(), points);
  for_each_index(points, [&](std::size_t i) {
    if (!std::ranges::all_of(tensors[i], [](double x) { return std::isfinite(x); }))
      throw InputError(fmt::format("field: vertex {}: a number of the tensor is not finite", i + 1));
  });
}

}  // namespace taut
