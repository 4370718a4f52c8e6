#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "taut/error.hpp"
#include "taut/threads.hpp"

namespace taut {
namespace {

constexpr std::array<int, 8> thread_counts = {1, 2, 3, 4, 5, 6, 7, 8};

bool all_one(const std::vector<std::atomic<int>>& runs) {
  return std::ranges::all_of(runs, [](const auto& n) { return n == 1; });
}

TEST(ForEachTask, RunsEachOnce) {
  for (const int threads : thread_counts)
    on_threads(threads, [] {
      for (const std::size_t count : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> runs(count);
        for_each_task(count, [&](std::size_t task, int) { ++runs[task]; });
        EXPECT_TRUE(all_one(runs)) << count;
      }
    });
}

TEST(ForEachTask, LendsAWorkerNumberToOneTaskAtATime) {
  for (const int threads : thread_counts)
    on_threads(threads, [&] {
      std::vector<std::atomic<bool>> busy(static_cast<std::size_t>(threads));
      std::atomic<int> clashes = 0;
      for_each_task(200, [&](std::size_t, int worker) {
        if (worker < 0 || worker >= worker_count() || busy[static_cast<std::size_t>(worker)].exchange(true)) {
          ++clashes;
          return;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        busy[static_cast<std::size_t>(worker)] = false;
      });
      EXPECT_EQ(clashes, 0) << threads << " threads";
    });
}

TEST(ForEachTask, RunsAsManyAtATimeAsThereAreThreads) {
  // More than most machines have cores: each task waits for all the others to begin.
  constexpr int threads = 6;
  on_threads(threads, [] {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::atomic<int> begun = 0, alone = 0;
    for_each_task(threads, [&](std::size_t, int) {
      ++begun;
      while (begun < threads && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
      if (begun < threads) ++alone;
    });
    EXPECT_EQ(alone, 0);
  });
}

TEST(ForEachTask, ThrowsWhatTheFirstTaskThrewAfterTheOthers) {
  for (const int threads : thread_counts)
    on_threads(threads, [] {
      for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<std::atomic<int>> runs(100);
        std::string what;
        try {
          for_each_task(runs.size(), [&](std::size_t task, int) {
            ++runs[task];
            if (task == 17) std::this_thread::sleep_for(std::chrono::microseconds(200));  // so that it is not first
            if (task == 17 || task == 18 || task == 99) throw std::runtime_error(std::to_string(task));
          });
        } catch (const std::runtime_error& error) {
          what = error.what();
        }
        EXPECT_EQ(what, "17");
        EXPECT_TRUE(all_one(runs));
      }
    });
}

TEST(ForEachIndex, CallsForEachOnce) {
  on_threads(3, [] {
    std::vector<int> calls(100'000, 0);
    for_each_index(calls.size(), [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(std::ranges::count(calls, 1), 100'000);
    for_each_index(0, [](std::size_t) { ADD_FAILURE() << "there is none"; });
  });
}

TEST(SumInOrder, HasTheSameBitsOnAnyNumberOfThreads) {
  constexpr std::size_t count = 200'001;
  const auto term = [](std::size_t i) { return (i % 3 == 0 ? -1.0 : 1e3) / static_cast<double>(1 + i * i % 1009); };
  const auto sum = [&] { return sum_in_order<double>(count, [&](double& s, std::size_t i) { s += term(i); }); };
  const Chunks chunks(count);
  double expected = 0;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    double part = 0;
    for (std::size_t i = chunks.begin(c); i < chunks.end(c); ++i) part += term(i);
    expected += part;
  }
  double straight = 0;
  for (std::size_t i = 0; i < count; ++i) straight += term(i);
  EXPECT_NE(straight, expected) << "the order of these terms does not matter, so the test shows nothing";
  for (const int threads : thread_counts) on_threads(threads, [&] { EXPECT_EQ(sum(), expected) << threads; });
  EXPECT_EQ(sum_in_order<double>(0, [](double& s, std::size_t) { s = 1; }), 0);
}

TEST(Chunks, CoverTheRangeOneAfterTheOther) {
  for (const std::size_t length : {1, 2, 100})
    for (const std::size_t count : {0, 1, 2, 99, 100, 101, 305}) {
      const Chunks chunks(count, length);
      std::size_t at = 0;
      for (std::size_t c = 0; c < chunks.size(); ++c) {
        EXPECT_EQ(chunks.begin(c), at);
        EXPECT_GT(chunks.end(c), at) << "an empty one";
        EXPECT_LE(chunks.end(c) - at, length);
        at = chunks.end(c);
      }
      EXPECT_EQ(at, count);
    }
}

TEST(OnThreads, SetsTheNumberOfWorkers) {
  for (const int threads : {1, 2, 3, 8, 65}) {
    int found = 0;
    on_threads(threads, [&] { found = worker_count(); });
    EXPECT_EQ(found, threads);
  }
}

TEST(OnThreads, OfZeroKeepsToThoseAround) {
  const int outside = worker_count();
  int inner = 0, after = 0;
  on_threads(0, [&] { inner = worker_count(); });
  EXPECT_EQ(inner, outside);
  on_threads(3, [&] {
    on_threads(0, [&] { inner = worker_count(); });
    on_threads(1, [] {});
    after = worker_count();
  });
  EXPECT_EQ(inner, 3);
  EXPECT_EQ(after, 3);
  EXPECT_EQ(worker_count(), outside);
}

TEST(OnThreads, LetsExceptionsThrough) {
  const int outside = worker_count();
  for (const int threads : {0, 1, 3, 65}) {
    EXPECT_THROW(on_threads(threads, [] { throw std::out_of_range("away"); }), std::out_of_range);
    const auto from_a_task = [] { for_each_task(10, [](std::size_t, int) { throw std::out_of_range("away"); }); };
    EXPECT_THROW(on_threads(threads, from_a_task), std::out_of_range);
    EXPECT_EQ(worker_count(), outside);
  }
}

TEST(OnThreads, RefusesImpossibleNumbers) {
  for (const int threads : {-1, most_threads + 1})
    EXPECT_THROW(on_threads(threads, [] { ADD_FAILURE(); }), InputError) << threads;
}

}  // namespace
}  // namespace taut
