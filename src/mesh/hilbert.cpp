#include "mesh/hilbert.hpp"

#include <algorithm>

#include "base/box.hpp"
#include "base/parallel.hpp"
#include "base/sort.hpp"

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

// Number of cells per unit of length in each direction of a box.
Vec3 scale_of(const Box& box) {
  Vec3 scale{};
  for (int d = 0; d < 3; ++d) scale[d] = box.high[d] > box.low[d] ? ((1 << bits) - 1) / (box.high[d] - box.low[d]) : 0;
  return scale;
}

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Vec3> points) {
  const Box box = sum_in_order<Box>(points.size(), [&](Box& sum, std::size_t i) { sum += {points[i], points[i]}; });
  const Vec3 scale = scale_of(box);
  std::vector<KeyedIndex> keys(points.size());
  for_each_index(points.size(), [&](std::size_t i) {
    std::array<std::uint32_t, 3> cell{};
    for (int d = 0; d < 3; ++d) cell[d] = static_cast<std::uint32_t>((points[i][d] - box.low[d]) * scale[d]);
    keys[i] = {hilbert_index(cell), static_cast<std::uint32_t>(i)};
  });
  sort(keys);
  std::vector<std::uint32_t> order(points.size());
  for_each_index(keys.size(), [&](std::size_t i) { order[i] = keys[i].index; });
  return order;
}

}  // namespace taut
