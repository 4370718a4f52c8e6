// A sort in parallel.
#pragma once

#include <cstdint>
#include <vector>

namespace taut {

struct KeyedIndex {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key, and what has the same key by index.
void sort(std::vector<KeyedIndex>& values);

}  // namespace taut
