// A parallel counting sort into a few groups, each with its own array; base/buckets.hpp is for many keys.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace taut {

/// For each group below `groups`, the indices 0 .. group_of.size() - 1 that are in it, ascending. Other groups are
/// ignored.
template <class Id>
[[nodiscard]] std::vector<std::vector<Id>> group(const std::vector<std::uint32_t>& group_of, std::size_t groups) {
  const Chunks chunks(group_of.size(), std::size_t{1} << 16);
  std::vector<std::vector<std::uint32_t>> start(chunks.size(), std::vector<std::uint32_t>(groups, 0));
  const auto for_each_member = [&](auto visit) {
    for_each_task(chunks.size(), [&](std::size_t chunk, int) {
      for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i)
        if (group_of[i] < groups) visit(chunk, group_of[i], static_cast<std::uint32_t>(i));
    });
  };
  for_each_member([&](std::size_t chunk, std::uint32_t g, std::uint32_t) { ++start[chunk][g]; });
  std::vector<std::vector<Id>> members(groups);
  for_each_task(groups, [&](std::size_t g, int) {
    std::uint32_t sum = 0;
    for (auto& counts : start) sum += std::exchange(counts[g], sum);
    members[g].resize(sum);
  });
  for_each_member(
      [&](std::size_t chunk, std::uint32_t g, std::uint32_t i) { members[g][start[chunk][g]++] = static_cast<Id>(i); });
  return members;
}

}  // namespace taut
