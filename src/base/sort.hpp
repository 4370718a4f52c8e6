// A parallel sort.
#pragma once

#include <cstdint>
#include <vector>

namespace taut {

struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key; equal keys by index.
void sort(std::vector<KeyedIndex>& values);

}  // namespace taut
