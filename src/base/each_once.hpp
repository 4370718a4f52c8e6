// Lists without repeats.
#pragma once

#include <algorithm>
#include <vector>

namespace taut {

/// Sorts and drops repeats.
template <class T>
void keep_each_once(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace taut
