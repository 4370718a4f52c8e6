#include "cavity/small_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "cavity/tet_set.hpp"

namespace taut {
namespace {

TEST(SmallMap, DoesAsAMap) {
  std::mt19937 generator(1);
  SmallMap<64> map;
  for (int round = 0; round < 300; ++round) {
    map.clear();
    std::map<std::uint32_t, int> expected;
    // Few different keys of all sizes, or multiples of the number of slots, which collide in a poor hash.
    std::uniform_int_distribution<std::uint32_t> small(0, 50), any;
    for (int i = 0; i < 32; ++i) {
      const std::uint32_t key = round % 3 == 0 ? any(generator) : small(generator) * (round % 3 == 1 ? 1U : 64U);
      const int value = static_cast<int>(any(generator) % 1000);
      EXPECT_EQ(map.contains(key), expected.contains(key));
      EXPECT_EQ(map.find_or_insert(key, value), expected.try_emplace(key, value).first->second);
    }
    for (std::uint32_t key = 0; key < 100; ++key)
      EXPECT_EQ(map.find(key), expected.contains(key) ? expected.at(key) : SmallMap<64>::missing);
    for (const auto& [key, value] : expected) EXPECT_EQ(map.find(key), value);
  }
}

TEST(SmallMap, ForgetsWhenCleared) {
  SmallMap<8> map;
  EXPECT_FALSE(map.contains(0)) << "a map is empty when made";
  for (int round = 0; round < 1000; ++round) {
    EXPECT_EQ(map.find_or_insert(7, round), round);
    map.clear();
    EXPECT_FALSE(map.contains(7));
  }
}

TEST(TetSet, KeepsTheOrderOfAdditionUpToItsCapacity) {
  TetSet set;
  for (int i = 0; i < TetSet::capacity; ++i) {
    EXPECT_FALSE(set.contains(static_cast<TetId>(1000 - 3 * i)));
    EXPECT_TRUE(set.add(static_cast<TetId>(1000 - 3 * i)));
  }
  EXPECT_FALSE(set.add(TetId{5000}));
  EXPECT_FALSE(set.contains(TetId{5000}));
  EXPECT_EQ(set.size(), TetSet::capacity);
  for (int i = 0; i < TetSet::capacity; ++i) EXPECT_EQ(set[i], static_cast<TetId>(1000 - 3 * i));
  EXPECT_EQ(set.span().size(), static_cast<std::size_t>(TetSet::capacity));
  set.clear();
  EXPECT_EQ(set.size(), 0);
  EXPECT_FALSE(set.contains(TetId{1000}));
}

TEST(TetSet, Shrinks) {
  TetSet set;
  for (std::uint32_t t = 10; t < 20; ++t) (void)set.add(TetId{t});
  set.shrink(3, [](int i) { return i % 2 == 0; });
  const std::vector<TetId> left(set.span().begin(), set.span().end());
  EXPECT_TRUE(std::ranges::equal(left, std::array{10U, 11U, 12U, 14U, 16U, 18U}));
  for (std::uint32_t t = 10; t < 20; ++t)
    EXPECT_EQ(set.contains(TetId{t}), std::ranges::find(left, TetId{t}) != left.end());
  EXPECT_TRUE(set.add(TetId{13}));
  EXPECT_EQ(set[6], 13);
}

}  // namespace
}  // namespace taut
