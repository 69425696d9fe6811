#ifndef QUADRILLE_INTERNAL_PARALLEL_H
#define QUADRILLE_INTERNAL_PARALLEL_H

#include <quadrille/internal/core/base/threads.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace quadrille::internal {

template <class Task>
auto with_threads(unsigned, const Task& task) {
  return task();
}

/// Stands in for that of the library: threads whose meetings the thread sanitizer sees.
template <class Task>
void parallel_for(unsigned threads, std::size_t n, const Task& task) {
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> workers;
  for (std::size_t worker = 0; worker < threads; ++worker)
    workers.emplace_back([&, worker] {
      for (std::size_t i; (i = next++) < n;)
        task(i, worker);
    });
  for (std::thread& worker : workers)
    worker.join();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PARALLEL_H
