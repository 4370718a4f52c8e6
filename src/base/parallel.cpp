// The only file that uses oneTBB. Built without ThreadSanitizer, which would report the scheduler's hand-overs as
// races.
#include "base/parallel.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <optional>

#include "taut/error.hpp"
#include "taut/threads.hpp"

namespace taut {

int worker_count() {
  return tbb::this_task_arena::max_concurrency();
}

namespace detail {

// Each runner takes the next task when it has finished one, so that none waits while there is work. Each task is
// isolated: a task that waits for parallel work of its own, as a metric function may, does not begin another task
// meanwhile.
void run_tasks(std::size_t count, Call call, void* context) {
  const auto runners = static_cast<int>(std::min(count, static_cast<std::size_t>(worker_count())));
  std::atomic<std::size_t> next = 0;
  const auto run = [&](int worker) {
    for (std::size_t task = next++; task < count; task = next++)
      tbb::this_task_arena::isolate([&] { call(context, task, worker); });
  };
  if (runners <= 1) {
    run(0);
    return;
  }
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, runners, run, tbb::simple_partitioner{}); });
}

}  // namespace detail

void on_threads(int threads, const std::function<void()>& work) {
  if (threads < 0 || threads > most_threads)
    throw InputError(fmt::format("{} threads found, expected 0 to {}", threads, most_threads));
  if (threads == 0) {
    work();
    return;
  }
  std::optional<tbb::global_control> more;  // threads than cores: oneTBB starts them only on request
  if (threads > tbb::info::default_concurrency())
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] { work(); });
}

}  // namespace taut
