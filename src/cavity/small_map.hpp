// A set or map of a few dozen ids that fits into the first-level cache and is cleared in constant time.
#pragma once

#include <array>
#include <cstdint>

namespace taut {

/// Open addressing. The caller must use at most half of the `slots`.
template <int slots>
class SmallMap {
  static_assert((slots & (slots - 1)) == 0);

public:
  static constexpr int missing = -1;

  void clear() {
    if (++stamp_ == 0) {  // the counter has overflowed after 2^32 uses
      entries_.fill(0);
      stamp_ = 1;
    }
  }

  [[nodiscard]] int find(std::uint32_t key) const {
    const std::uint64_t wanted = entry(key);
    for (std::uint32_t h = hash(key);; h = (h + 1) & (slots - 1)) {
      if (entries_[h] == wanted) return values_[h];
      if (is_free(h)) return missing;
    }
  }
  [[nodiscard]] bool contains(std::uint32_t key) const { return find(key) != missing; }

  /// The value of `key`; if it has none, it becomes `value`.
  int find_or_insert(std::uint32_t key, int value) {
    const std::uint64_t wanted = entry(key);
    for (std::uint32_t h = hash(key);; h = (h + 1) & (slots - 1)) {
      if (entries_[h] == wanted) return values_[h];
      if (!is_free(h)) continue;
      entries_[h] = wanted;
      values_[h] = static_cast<std::int16_t>(value);
      return value;
    }
  }

private:
  // The stamp records in which use of the map a slot was filled.
  [[nodiscard]] std::uint64_t entry(std::uint32_t key) const { return (std::uint64_t{stamp_} << 32) | key; }
  [[nodiscard]] bool is_free(std::uint32_t slot) const { return (entries_[slot] >> 32) != stamp_; }
  static std::uint32_t hash(std::uint32_t key) { return (key * 2654435769U) >> (32 - log2_slots); }
  static constexpr int log2_slots = [] {
    int n = 0;
    while ((1 << n) < slots) ++n;
    return n;
  }();

  std::uint32_t stamp_ = 1;
  std::array<std::uint64_t, slots> entries_{};
  std::array<std::int16_t, slots> values_{};
};

}  // namespace taut
