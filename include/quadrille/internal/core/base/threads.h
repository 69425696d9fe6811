#ifndef QUADRILLE_INTERNAL_CORE_BASE_THREADS_H
#define QUADRILLE_INTERNAL_CORE_BASE_THREADS_H

#include <cstddef>
#include <stdexcept>
#include <string>

/// Some translation units of a program may have oneTBB, and others not. Code that depends on that
/// is in the inline namespace QUADRILLE_THREADING, so that no function has two definitions; all
/// other code learns it at run time, from Threads.

#ifdef QUADRILLE_WITH_TBB
#define QUADRILLE_THREADING with_tbb
#else
#define QUADRILLE_THREADING without_tbb
#endif

namespace quadrille::internal {

/// The body of a loop, or a whole task, of any type: refers to it.
class TaskView {
public:
  template <class Task>
  explicit TaskView(const Task& task)
      : task_(&task), call_([](const void* t, std::size_t i, std::size_t worker) {
          (*static_cast<const Task*>(t))(i, worker);
        }) {}

  void operator()(std::size_t i, std::size_t worker) const { call_(task_, i, worker); }

private:
  const void* task_;
  void (*call_)(const void*, std::size_t, std::size_t);
};

/// How many threads a call may use, at least one, and how.
class Threads {
public:
  /// This is how a library of threads runs a loop on more than one of them.
  struct Library {
    void (*loop)(std::size_t n, TaskView task);   ///< see parallel_for()
    void (*run)(unsigned threads, TaskView task); ///< task(0, 0): see with_threads()
  };

  constexpr Threads() = default; ///< one
  constexpr Threads(unsigned count, const Library* library) : count_(count), library_(library) {}

  constexpr operator unsigned() const { return count_; }
  const Library& library() const { return *library_; } ///< there has to be one

  /// Throws std::invalid_argument for threads that there can't be.
  void validate(const std::string& function) const {
    if (!library_ && count_ > 1)
      throw std::invalid_argument(function + ": " + std::to_string(count_) +
                                  " threads need oneTBB: link quadrille::parallel");
  }

private:
  unsigned count_ = 1;
  const Library* library_ = nullptr;
};

/// Runs task(), in which parallel_for() may use that many threads. They stay awake between the
/// loops of one task: to wake one takes longer than many loops do.
template <class Task>
void with_threads(Threads threads, const Task& task) {
  if (threads == 1)
    task();
  else
    threads.library().run(threads, TaskView([&](std::size_t, std::size_t) { task(); }));
}

/// Calls task(i, worker) for i from 0 to n − 1, at most `threads` at a time; no two calls at a time
/// have the same worker, a number below `threads`. Inside of with_threads(threads, …) only.
template <class Task>
void parallel_for(Threads threads, std::size_t n, const Task& task) {
  if (threads > 1 && n > 1) {
    threads.library().loop(n, TaskView(task));
    return;
  }
  for (std::size_t i = 0; i < n; ++i)
    task(i, std::size_t{0});
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_THREADS_H
