// How many threads the library may use.
#pragma once

#include <functional>

#include "taut/export.hpp"

namespace taut {

/// Largest number of threads that can be asked for.
inline constexpr int most_threads = 1024;

/// Calls work(). The functions of this library that work() calls then use at most `threads` threads, even if that is
/// more than there are cores; 0: as many as the caller's oneTBB task arena has, by default one per core. No result
/// depends on the number of threads. An exception thrown by work() reaches the caller. Throws InputError unless
/// `threads` lies in [0, most_threads].
TAUT_EXPORT void on_threads(int threads, const std::function<void()>& work);

}  // namespace taut
