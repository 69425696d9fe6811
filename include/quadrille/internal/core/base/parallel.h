#ifndef QUADRILLE_INTERNAL_CORE_BASE_PARALLEL_H
#define QUADRILLE_INTERNAL_CORE_BASE_PARALLEL_H

#include <quadrille/internal/core/base/threads.h>

#ifdef QUADRILLE_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>

/// \file
/// The library of threads of a translation unit: oneTBB, or none.

namespace quadrille::internal {

inline namespace QUADRILLE_THREADING {

#ifdef QUADRILLE_WITH_TBB

inline void loop_by_tbb(std::size_t n, TaskView task) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        const int worker = tbb::this_task_arena::current_thread_index();
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          task(i, static_cast<std::size_t>(worker));
      },
      tbb::simple_partitioner{});
}
inline void run_by_tbb(unsigned threads, TaskView task) {
  // oneTBB prints a warning where it is asked for more than it has, and makes do with these.
  const std::size_t available =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>((std::min)(std::size_t{threads}, available)));
  arena.execute([&] { task(0, 0); });
}
inline constexpr Threads::Library tbb_library{&loop_by_tbb, &run_by_tbb};

/// Returns `count` threads of the library that this translation unit has.
inline Threads threads_here(unsigned count) {
  return {count, &tbb_library};
}

#else

inline Threads threads_here(unsigned count) {
  return {count, nullptr};
}

#endif

/// Returns the threads of a call. Throws std::invalid_argument without oneTBB.
inline Threads threads_of(const char* function, unsigned count) {
  const Threads threads = threads_here(count);
  threads.validate(function);
  return threads;
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_PARALLEL_H
