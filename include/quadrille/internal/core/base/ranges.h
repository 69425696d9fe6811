#ifndef QUADRILLE_INTERNAL_CORE_BASE_RANGES_H
#define QUADRILLE_INTERNAL_CORE_BASE_RANGES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>

#include <cstddef>

namespace quadrille::internal {

/// Consecutive numbers.
struct Range {
  Index begin, end;
  bool contains(Index i) const { return i - begin < end - begin; }
};

/// All numbers that there are.
struct WholeRange {
  Index begin, end;
  static constexpr bool contains(Index) { return true; }
};

/// Calls task(range, worker) for ranges that together are 0, 1, …, size − 1, one for each thread.
///
/// So a sum over the faces of each vertex is computed by all threads without a lock, and to the
/// last bit as by one: each looks at all faces, in their order, and adds to the vertices of its
/// range only.
template <class Task>
void for_each_range(Threads threads, std::size_t size, const Task& task) {
  const unsigned count = threads;
  const auto bound = [=](std::size_t i) { return static_cast<Index>(size * i / count); };
  if (count == 1)
    task(WholeRange{0, bound(1)}, 0);
  else
    parallel_for(threads, count, [&](std::size_t i, std::size_t worker) {
      task(Range{bound(i), bound(i + 1)}, worker);
    });
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_RANGES_H
