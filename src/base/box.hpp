// Boxes parallel to the axes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "base/vec3.hpp"

namespace taut {

/// From the lowest corner to the highest; empty at first.
struct Box {
  static constexpr double huge = std::numeric_limits<double>::infinity();
  Vec3 low{huge, huge, huge}, high{-huge, -huge, -huge};

  void include(const Vec3& x) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  }

  void include(const Box& other) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], other.low[d]);
      high[d] = std::max(high[d], other.high[d]);
    }
  }

  Box& operator+=(const Box& other) {
    include(other);
    return *this;
  }

  [[nodiscard]] bool meets(const Box& other) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (low[d] > other.high[d] || high[d] < other.low[d]) return false;
    return true;
  }

  /// Of a box that is not empty.
  [[nodiscard]] double diagonal() const { return norm(high - low); }
};

/// The box around some points.
template <class Points>
[[nodiscard]] Box box_around(const Points& points) {
  Box box;
  for (const auto& p : points) box.include(p);
  return box;
}

}  // namespace taut
