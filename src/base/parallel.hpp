// Loops on several threads. What they compute depends neither on the number of threads nor on the order of the tasks.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace taut {

/// The largest number of tasks that run at a time; the worker numbers of a loop are below it.
[[nodiscard]] int worker_count();

namespace detail {

using Call = void (*)(void* context, std::size_t task, int worker);
void run_tasks(std::size_t count, Call call, void* context);

/// Of all exceptions, keeps the one of the first task: which one is thrown first is a matter of chance.
class FirstFailure {
public:
  void keep(std::size_t task) {
    const std::lock_guard lock(mutex_);
    if (failure_ && task_ < task) return;
    task_ = task;
    failure_ = std::current_exception();
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  std::mutex mutex_;
  std::size_t task_ = 0;
  std::exception_ptr failure_;
};

/// States that the tasks of a loop run after its beginning and before its end. oneTBB guarantees it, but
/// ThreadSanitizer cannot see into oneTBB. Nothing is stated about the order of tasks.
class ForkAndJoin {
public:
  void fork() { started_.store(true, std::memory_order_release); }
  void begin_task() { (void)started_.load(std::memory_order_acquire); }
  void end_task() { ended_.fetch_add(1, std::memory_order_release); }
  void join() { (void)ended_.load(std::memory_order_acquire); }

private:
  std::atomic<bool> started_ = false;
  std::atomic<std::size_t> ended_ = 0;
};

}  // namespace detail

/// Calls body(task, worker) once for each task below `count`. Several tasks run at a time, but never two with the same
/// worker number; later tasks start later. Returns when all tasks are done. If tasks throw, all others still run, and
/// then the exception of the first of them is thrown.
template <class Body>
void for_each_task(std::size_t count, Body&& body) {
  struct Context {
    std::remove_reference_t<Body>& body;
    detail::FirstFailure failure{};
    detail::ForkAndJoin order{};
  } context{body};
  context.order.fork();
  detail::run_tasks(
      count,
      [](void* opaque, std::size_t task, int worker) {
        auto& c = *static_cast<Context*>(opaque);
        c.order.begin_task();
        try {
          c.body(task, worker);
        } catch (...) {
          c.failure.keep(task);
        }
        c.order.end_task();
      },
      &context);
  context.order.join();
  context.failure.rethrow();
}

/// Parts of a range. Their bounds depend only on its length.
struct Chunks {
  std::size_t count, length;

  explicit Chunks(std::size_t size, std::size_t chunk_length = std::size_t{1} << 14)
      : count(size), length(chunk_length) {}
  [[nodiscard]] std::size_t size() const { return (count + length - 1) / length; }
  [[nodiscard]] std::size_t begin(std::size_t chunk) const { return chunk * length; }
  [[nodiscard]] std::size_t end(std::size_t chunk) const { return chunk + 1 < size() ? begin(chunk + 1) : count; }
};

/// Calls body(i) for each i of the chunks. Calls for different i must not touch the same memory.
template <class Body>
void for_each_index(Chunks chunks, Body&& body) {
  for_each_task(chunks.size(), [&](std::size_t chunk, int) {
    for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i) body(i);
  });
}
template <class Body>
void for_each_index(std::size_t count, Body&& body) {
  for_each_index(Chunks(count), std::forward<Body>(body));
}

/// The sum of what add(sum, i) adds for each i of the chunks. Each chunk starts with a Sum{}; the sums of the chunks
/// are added by `sum += other`, in the order of the chunks.
template <class Sum, class Add>
[[nodiscard]] Sum sum_in_order(Chunks chunks, Add&& add) {
  std::vector<Sum> sums(chunks.size());
  for_each_task(chunks.size(), [&](std::size_t chunk, int) {
    Sum own{};
    for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i) add(own, i);
    sums[chunk] = std::move(own);
  });
  Sum total{};
  for (const Sum& sum : sums) total += sum;
  return total;
}
template <class Sum, class Add>
[[nodiscard]] Sum sum_in_order(std::size_t count, Add&& add) {
  return sum_in_order<Sum>(Chunks(count), std::forward<Add>(add));
}

/// What add(list, i) or add(list, i, worker) appends to a list for each i of the chunks, in ascending order of i.
template <class T, class Add>
[[nodiscard]] std::vector<T> collect_in_order(Chunks chunks, Add&& add) {
  std::vector<std::vector<T>> lists(chunks.size());
  for_each_task(chunks.size(), [&](std::size_t chunk, int worker) {
    std::vector<T> own;
    for (std::size_t i = chunks.begin(chunk); i < chunks.end(chunk); ++i)
      if constexpr (std::is_invocable_v<Add, std::vector<T>&, std::size_t, int>)
        add(own, i, worker);
      else
        add(own, i);
    lists[chunk] = std::move(own);
  });
  std::vector<std::size_t> start(1, 0);
  for (const auto& list : lists) start.push_back(start.back() + list.size());
  std::vector<T> all(start.back());
  for_each_task(lists.size(), [&](std::size_t chunk, int) {
    std::copy(lists[chunk].begin(), lists[chunk].end(), all.begin() + static_cast<std::ptrdiff_t>(start[chunk]));
  });
  return all;
}

/// The indices 0 .. count - 1 that fulfil the condition, ascending.
template <class Condition>
[[nodiscard]] std::vector<std::uint32_t> indices_where(std::size_t count, Condition&& condition) {
  return collect_in_order<std::uint32_t>(Chunks(count), [&](std::vector<std::uint32_t>& list, std::size_t i) {
    if (condition(i)) list.push_back(static_cast<std::uint32_t>(i));
  });
}

}  // namespace taut
