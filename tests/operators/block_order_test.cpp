// The operations of different blocks do not depend on each other: the same bits in any order, on any thread.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

#include "base/parallel.hpp"
#include "operators/cut_bench.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

using test::bits_of;
using test::CutBench;
using test::kinds;
using test::plenty;
using test::run_all;

// Calls work(block, kind) for all blocks and kinds, in its own order.
using Work = std::function<void(std::size_t block, std::size_t kind)>;
using Schedule = void (*)(std::size_t blocks, const Work& work);

void in_order(std::size_t blocks, const Work& work, const std::function<void(std::vector<std::size_t>&)>& arrange) {
  std::vector<std::size_t> order(blocks);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    arrange(order);
    for (std::size_t b : order) work(b, kind);
  }
}

void forward(std::size_t blocks, const Work& work) {
  in_order(blocks, work, [](auto&) {});
}

void backward(std::size_t blocks, const Work& work) {
  in_order(blocks, work, [](auto& order) { std::ranges::reverse(order); });
}

void shuffled(std::size_t blocks, const Work& work) {
  std::mt19937 generator(7);
  in_order(blocks, work, [&](auto& order) { std::ranges::shuffle(order, generator); });
}

void block_by_block(std::size_t blocks, const Work& work) {
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) work(b, kind);
}

void on_three_threads(std::size_t blocks, const Work& work) {
  on_threads(3, [&] {
    for_each_task(blocks, [&](std::size_t b, int) {
      for (std::size_t kind = 0; kind < kinds.size(); ++kind) work(b, kind);
    });
  });
}

// The ids that a mesh would hand out next.
std::vector<std::uint32_t> next_ids(TetMesh& mesh) {
  Block block;
  block.borrow(mesh, plenty);
  std::vector<std::uint32_t> ids;
  const auto add = [&ids](const auto& pool) { ids.insert(ids.end(), pool.unused().begin(), pool.unused().end()); };
  add(block.vertices);
  add(block.tets);
  add(block.triangles);
  return ids;
}

struct Adapted {
  test::Bits bits;
  std::vector<std::uint32_t> next;
  std::string fault;
  bool operator==(const Adapted&) const = default;
};

// The mesh after three rounds, each with another cut.
Adapted adapted(Schedule schedule, bool one_kernel) {
  CutBench cut(0);
  for (unsigned round = 0; round < 3; ++round) {
    if (round > 0) cut.cut(round, plenty);
    Kernel shared = cut.kernel(0);
    schedule(cut.blocks.size(), [&](std::size_t b, std::size_t kind) {
      if (!one_kernel) {
        Kernel own = cut.kernel(b);
        (void)run_all(kinds[kind], own);
        return;
      }
      shared.block = &cut.blocks[b];
      (void)run_all(kinds[kind], shared);
    });
    cut.blocks.close();
  }
  Adapted outcome{bits_of(cut.mesh), {}, first_broken_invariant(cut.mesh)};
  outcome.next = next_ids(cut.mesh);
  return outcome;
}

TEST(BlocksOfAMesh, GiveTheSameBitsInAnyOrder) {
  const Adapted expected = adapted(forward, true);
  EXPECT_EQ(expected.fault, "");
  EXPECT_TRUE(adapted(forward, true) == expected);
  EXPECT_TRUE(adapted(forward, false) == expected) << "a kernel remembers";
  EXPECT_TRUE(adapted(backward, true) == expected);
  EXPECT_TRUE(adapted(shuffled, true) == expected);
  EXPECT_TRUE(adapted(block_by_block, true) == expected);
  EXPECT_TRUE(adapted(on_three_threads, false) == expected);
}

}  // namespace
}  // namespace taut
