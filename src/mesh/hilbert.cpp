#include "mesh/hilbert.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace taut {
namespace {

constexpr int bits = 16;

// J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004: axes to transposed index.
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t top = 1U << (bits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (int i = 0; i < 3; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  for (int i = 1; i < 3; ++i) x[i] ^= x[i - 1];
  std::uint32_t gray = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1)
    if ((x[2] & q) != 0) gray ^= q - 1;
  std::uint64_t index = 0;
  for (int b = bits - 1; b >= 0; --b)
    for (int i = 0; i < 3; ++i) index = (index << 1) | (((x[i] ^ gray) >> b) & 1U);
  return index;
}

struct Box {
  Vec3 low{}, scale{};
};

Box box_of(std::span<const Vec3> points) {
  constexpr double huge = std::numeric_limits<double>::infinity();
  Vec3 low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (const Vec3& p : points) {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  }
  Box box{low, {}};
  for (int d = 0; d < 3; ++d) box.scale[d] = high[d] > low[d] ? ((1 << bits) - 1) / (high[d] - low[d]) : 0;
  return box;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points) {
  const Box box = box_of(points);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (int d = 0; d < 3; ++d) cell[d] = static_cast<std::uint32_t>((points[i][d] - box.low[d]) * box.scale[d]);
    keys[i] = {hilbert_index(cell), i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace taut
