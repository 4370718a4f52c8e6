#include "base/sort.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace taut {
namespace {

bool is_before(const KeyedIndex& a, const KeyedIndex& b) {
  return a.key != b.key ? a.key < b.key : a.index < b.index;
}

}  // namespace

// Sorts runs and merges them in pairs. Does not use oneTBB's sort, because ThreadSanitizer cannot see what orders its
// threads.
void sort(std::vector<KeyedIndex>& values) {
  constexpr std::size_t run_length = std::size_t{1} << 13;
  const auto at = [](std::vector<KeyedIndex>& of, std::size_t i) {
    return of.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const Chunks runs(values.size(), run_length);
  for_each_task(runs.size(), [&](std::size_t run, int) {
    std::sort(at(values, runs.begin(run)), at(values, runs.end(run)), is_before);
  });
  std::vector<KeyedIndex> merged(runs.size() > 1 ? values.size() : 0);
  for (std::size_t length = run_length; length < values.size(); length *= 2) {
    const Chunks pairs(values.size(), 2 * length);
    for_each_task(pairs.size(), [&](std::size_t pair, int) {
      const std::size_t begin = pairs.begin(pair), end = pairs.end(pair), middle = std::min(begin + length, end);
      std::merge(at(values, begin), at(values, middle), at(values, middle), at(values, end), at(merged, begin),
                 is_before);
    });
    values.swap(merged);
  }
}

}  // namespace taut
