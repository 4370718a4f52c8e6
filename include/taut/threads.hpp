// How many threads the library may use.
#pragma once

#include <functional>

namespace taut {

inline constexpr int most_threads = 1024;

/// Calls work(), and lets what it calls of this library run on so many threads at most; more than there are cores are
/// started if asked for. 0: on those of the oneTBB task arena that this is called from, by default one a core. What
/// work() throws comes through. No function's result depends on the number of threads. Throws InputError unless
/// `threads` is 0 to most_threads.
void on_threads(int threads, const std::function<void()>& work);

}  // namespace taut
