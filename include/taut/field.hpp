// Fields as users hold them: numbers at the points of a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "taut/error.hpp"
#include "taut/export.hpp"
#include "taut/metric.hpp"

namespace taut {

/// One solution field at the vertices of a mesh. `values` holds `size()` numbers per vertex: vectors in the order of
/// the file, tensors in the order of taut::Tensor.
struct Field {
  /// What stands at each vertex. The numbers are those of the file format.
  enum class Kind {
    scalar = 1,  ///< one number
    vector = 2,  ///< three numbers
    tensor = 3,  ///< six numbers, symmetric
  };
  Kind kind = Kind::scalar;    ///< of every vertex
  std::vector<double> values;  ///< vertex by vertex

  /// Numbers per vertex.
  [[nodiscard]] std::size_t size() const { return kind == Kind::scalar ? 1 : kind == Kind::vector ? 3 : 6; }

  /// Number k < size() of every vertex.
  [[nodiscard]] std::vector<double> component(std::size_t k) const {
    std::vector<double> numbers(values.size() / size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = values[i * size() + k];
    return numbers;
  }
};

/// The tensors as a field, as write_solution() and transfer() take it.
[[nodiscard]] TAUT_EXPORT Field field_of(const Tensors& tensors);

/// The tensors of a tensor field, as metrics and Hessians are given. Throws InputError for a field of another kind, and
/// if there are not six numbers per vertex.
[[nodiscard]] TAUT_EXPORT Tensors tensors_of(const Field& field);

}  // namespace taut
