// Numbers in a vector of Eigen, seen as values at vertices.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

#include "base/vec3.hpp"

namespace taut {

template <class Value>
Value value_at(const Eigen::VectorXd& values, std::size_t i) {
  if constexpr (std::is_same_v<Value, double>) {
    return values[static_cast<Eigen::Index>(i)];
  } else {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    return {values[at], values[at + 1], values[at + 2]};
  }
}

}  // namespace taut
