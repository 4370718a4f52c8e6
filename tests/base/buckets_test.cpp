#include "base/buckets.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "base/sort.hpp"
#include "base/with_threads.hpp"

namespace taut {
namespace {

using test::with_threads;
using Items = std::vector<std::vector<std::uint32_t>>;  // by key

// Source s gives s % 3 items, the last of them with a key that all sources share.
struct Sources {
  std::vector<std::uint32_t> key;
  std::size_t keys;

  Sources(std::size_t count, std::size_t key_count) : key(count), keys(key_count) {
    std::mt19937 generator(1);
    for (auto& k : key) k = static_cast<std::uint32_t>(generator() % keys);
  }
  template <class Put>
  void operator()(std::size_t s, const Put& put) const {
    const auto item = static_cast<std::uint32_t>(s);
    if (s % 3 > 0) put(key[s], item);
    if (s % 3 > 1) put(static_cast<std::uint32_t>(keys / 2), item);
  }
  [[nodiscard]] Items one_by_one() const {
    Items items(keys);
    for (std::size_t s = 0; s < key.size(); ++s) (*this)(s, [&](auto k, auto item) { items[k].push_back(item); });
    return items;
  }
  [[nodiscard]] Items gathered() const {
    const auto buckets = gather<std::uint32_t>(key.size(), keys, *this);
    Items items;
    for (std::size_t k = 0; k < buckets.keys(); ++k) items.emplace_back(buckets[k].begin(), buckets[k].end());
    return items;
  }
};

TEST(Buckets, HoldWhatIsPutInTheOrderOfTheSources) {
  for (const auto& [count, keys] : std::map<std::size_t, std::size_t>{{0, 5}, {100, 1}, {1000, 9000}, {90000, 70000}}) {
    const Sources sources(count, keys);
    const Items expected = sources.one_by_one();
    for (const int threads : {1, 3})
      EXPECT_EQ(with_threads(threads, [&] { return sources.gathered(); }), expected) << count << " by " << keys;
  }
}

TEST(Buckets, OfNoKeys) {
  EXPECT_EQ(gather<int>(0, 0, [](std::size_t, auto) {}).keys(), 0);
}

TEST(CollectInOrder, AppendsInTheOrderOfTheIndices) {
  for (const std::size_t count : {0, 7, 50000}) {
    std::vector<int> expected;
    const auto add = [](std::vector<int>& list, std::size_t i) {
      for (std::size_t k = 0; k < i % 4; ++k) list.push_back(static_cast<int>(i));
    };
    for (std::size_t i = 0; i < count; ++i) add(expected, i);
    for (const int threads : {1, 3})
      EXPECT_EQ(with_threads(threads, [&] { return collect_in_order<int>(Chunks(count), add); }), expected);
  }
  EXPECT_EQ(indices_where(10, [](std::size_t i) { return i % 4 == 1; }), (std::vector<std::uint32_t>{1, 5, 9}));
}

TEST(SortOfKeyedIndices, IsByKeyThenIndex) {
  std::mt19937_64 generator(2);
  std::vector<KeyedIndex> values;
  for (std::uint32_t i = 0; i < 50000; ++i) values.push_back({generator() % 9000 << 40, 49999 - i});
  for (const int threads : {1, 3}) {
    auto sorted = values;
    on_threads(threads, [&] { sort(sorted); });
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      const KeyedIndex &a = sorted[i - 1], &b = sorted[i];
      ASSERT_TRUE(a.key < b.key || (a.key == b.key && a.index < b.index)) << i;
    }
  }
}

}  // namespace
}  // namespace taut
