#ifndef QUADRILLE_INTERNAL_BASE_PARALLEL_H
#define QUADRILLE_INTERNAL_BASE_PARALLEL_H

#include <quadrille/internal/base/threads.h>

#ifdef QUADRILLE_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// Returns task(), in which parallel_for() may use so many threads. They stay awake between the
/// loops of one task: to wake one takes longer than many loops do.
template <class Task>
auto with_threads(OneThread, const Task& task) {
  return task();
}

/// Calls task(i, worker) for i from 0 to n − 1, at most `threads` at a time; no two calls at a time
/// have the same worker, a number below `threads`. Inside of with_threads(threads, …) only.
template <class Task>
void parallel_for(OneThread, std::size_t n, const Task& task) {
  for (std::size_t i = 0; i < n; ++i)
    task(i, 0);
}

#ifdef QUADRILLE_WITH_TBB

template <class Task>
auto with_threads(Threads<true> threads, const Task& task) {
  if (threads == 1)
    return task();
  // oneTBB prints a warning where it is asked for more than it has, and makes do with these.
  const std::size_t available =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>((std::min)(std::size_t{threads}, available)));
  return arena.execute(task);
}

template <class Task>
void parallel_for(Threads<true> threads, std::size_t n, const Task& task) {
  if (threads == 1 || n <= 1) {
    parallel_for(OneThread(), n, task);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        const int worker = tbb::this_task_arena::current_thread_index();
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          task(i, static_cast<std::size_t>(worker));
      },
      tbb::simple_partitioner{});
}

#endif

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_PARALLEL_H
