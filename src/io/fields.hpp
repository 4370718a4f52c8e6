// How the numbers of a field lie in a file.
#pragma once

#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "io/gmf_file.hpp"
#include "taut/io.hpp"

namespace taut::gmf {

/// Where the k-th number of a tensor in a file (xx, xy, yy, xz, yz, zz) stands in taut::Tensor (xx, xy, xz, yy, yz,
/// zz). Scalars and vectors keep their order, so their places are a part of `in_order`.
inline constexpr std::array<std::size_t, 6> tensor_order = {0, 1, 3, 2, 4, 5};
inline constexpr std::array<std::size_t, 6> in_order = {0, 1, 2, 3, 4, 5};

inline std::span<const std::size_t> places(const Field& field) {
  const bool tensor = field.kind == Field::Kind::tensor;
  return std::span(tensor ? tensor_order : in_order).first(field.size());
}

inline std::size_t values_of_a_vertex(const std::vector<Field>& fields) {
  return std::accumulate(fields.begin(), fields.end(), std::size_t{0},
                         [](std::size_t sum, const Field& field) { return sum + field.size(); });
}

/// The fields of an opened solution file.
[[nodiscard]] std::vector<Field> read_fields(const GmfFile& file);

/// Its only field, as a metric.
[[nodiscard]] Metric read_metric(const GmfFile& file);

}  // namespace taut::gmf
