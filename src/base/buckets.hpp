// A parallel counting sort by many keys, into one array; base/grouping.hpp is for a few groups.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/raw_array.hpp"

namespace taut {

/// Items in one array, by ascending key.
template <class Item>
class Buckets {
public:
  /// Key k has the items first[k] to first[k + 1].
  Buckets(std::vector<std::size_t> first, RawArray<Item> items) : first_(std::move(first)), items_(std::move(items)) {}

  [[nodiscard]] std::size_t keys() const { return first_.size() - 1; }
  [[nodiscard]] std::span<Item> operator[](std::size_t key) {
    return all().subspan(first_[key], first_[key + 1] - first_[key]);
  }
  [[nodiscard]] std::span<const Item> operator[](std::size_t key) const {
    return all().subspan(first_[key], first_[key + 1] - first_[key]);
  }
  [[nodiscard]] std::span<Item> all() { return {items_.data(), items_.size()}; }
  [[nodiscard]] std::span<const Item> all() const { return {items_.data(), items_.size()}; }

private:
  std::vector<std::size_t> first_;
  RawArray<Item> items_;
};

/// Sorts in two steps, first by ranges of keys, so that no thread needs a counter for each key.
template <class Item>
class Gathering {
public:
  Gathering(std::size_t sources, std::size_t keys)
      : sources_(sources, std::max(std::size_t{1} << 14, sources >> 10)),
        shift_(std::max(10, static_cast<int>(std::bit_width(keys >> 9)))),
        ranges_(keys, std::size_t{1} << shift_),
        start_(sources_.size(), std::vector<std::size_t>(ranges_.size())),
        first_of_range_(ranges_.size() + 1) {}

  template <class Emit>
  [[nodiscard]] Buckets<Item> run(const Emit& emit) {
    count(emit);
    RawArray<Entry> entries(first_of_range_.back());
    fill(emit, entries.data());
    std::vector<std::size_t> first(ranges_.count + 1, 0);
    RawArray<Item> items(entries.size());
    for_each_task(ranges_.size(), [&](std::size_t range, int) {
      const std::size_t begin = first_of_range_[range];
      const std::span<const Entry> mine(entries.data() + begin, first_of_range_[range + 1] - begin);
      for (const Entry& e : mine) ++first[e.key + 1];
      std::size_t sum = begin;
      for (std::size_t key = ranges_.begin(range); key < ranges_.end(range); ++key)
        sum += std::exchange(first[key + 1], sum);
      for (const Entry& e : mine) items[first[e.key + 1]++] = e.item;
    });
    return {std::move(first), std::move(items)};
  }

private:
  struct Entry {
    std::uint32_t key;
    Item item;
  };

  template <class Emit>
  void count(const Emit& emit) {
    for_each_task(sources_.size(), [&](std::size_t chunk, int) {
      for (std::size_t s = sources_.begin(chunk); s < sources_.end(chunk); ++s)
        emit(s, [&](std::uint32_t key, const Item&) { ++start_[chunk][key >> shift_]; });
    });
    std::size_t sum = 0;
    for (std::size_t range = 0; range < ranges_.size(); ++range) {
      for (auto& start : start_) sum += std::exchange(start[range], sum);
      first_of_range_[range + 1] = sum;
    }
  }

  template <class Emit>
  void fill(const Emit& emit, Entry* entries) {
    for_each_task(sources_.size(), [&](std::size_t chunk, int) {
      for (std::size_t s = sources_.begin(chunk); s < sources_.end(chunk); ++s)
        emit(s, [&](std::uint32_t key, const Item& item) { entries[start_[chunk][key >> shift_]++] = {key, item}; });
    });
  }

  Chunks sources_;
  int shift_;
  Chunks ranges_;
  std::vector<std::vector<std::size_t>> start_;  ///< by chunk and range
  std::vector<std::size_t> first_of_range_;
};

/// Sorts by key all items that emit(source, put) passes to put(key, item), for each source below `sources`. Keys are
/// below `keys`. Items of one key keep the order of their sources. emit() is called twice for each source, and
/// concurrently.
template <class Item, class Emit>
[[nodiscard]] Buckets<Item> gather(std::size_t sources, std::size_t keys, const Emit& emit) {
  return Gathering<Item>(sources, keys).run(emit);
}

}  // namespace taut
