#ifndef QUADRILLE_INTERNAL_PARALLEL_H
#define QUADRILLE_INTERNAL_PARALLEL_H

#include <quadrille/internal/base/threads.h>

#include <cstddef>

namespace quadrille::internal {

/// For test_any_order: are the tasks done from the last to the first?
inline bool runs_backwards = false;

template <class Task>
auto with_threads(unsigned, const Task& task) {
  return task();
}

/// In place of that of the library: all tasks one after the other, each by another worker.
template <class Task>
void parallel_for(unsigned threads, std::size_t n, const Task& task) {
  for (std::size_t i = 0; i < n; ++i)
    task(runs_backwards ? n - 1 - i : i, i % threads);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PARALLEL_H
