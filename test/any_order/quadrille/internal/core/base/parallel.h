#ifndef QUADRILLE_INTERNAL_BASE_PARALLEL_H
#define QUADRILLE_INTERNAL_BASE_PARALLEL_H

#include <quadrille/internal/core/base/threads.h>

#include <cstddef>

namespace quadrille::internal {

/// For test_any_order: are the tasks done from the last to the first?
inline bool runs_backwards = false;

/// In place of a library of threads: all tasks one after the other, each by another of 3 workers.
inline void loop_one_by_one(std::size_t n, TaskView task) {
  for (std::size_t i = 0; i < n; ++i)
    task(runs_backwards ? n - 1 - i : i, i % 3);
}
inline void run_one_by_one(unsigned, TaskView task) {
  task(0, 0);
}
inline constexpr Threads::Library one_by_one{&loop_one_by_one, &run_one_by_one};

inline Threads threads_here(unsigned count) {
  return {count, &one_by_one};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_BASE_PARALLEL_H
