#ifndef QUADRILLE_INTERNAL_FILE_PART_THREADS_H
#define QUADRILLE_INTERNAL_FILE_PART_THREADS_H

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace quadrille::internal {

/// Runs tasks 0 to n − 1, each once, by several threads. After an exception no more are begun, and
/// that of the lowest task is thrown when all that were begun are over.
class PartThreads {
public:
  /// `watch` is called by this thread now and then, while there is more than one.
  template <class Task, class Watch>
  static void run(std::size_t n, unsigned threads, const Task& task, const Watch& watch) {
    if (threads <= 1 || n <= 1) {
      for (std::size_t i = 0; i < n; ++i)
        task(i);
      return;
    }
    PartThreads all(n);
    {
      std::vector<std::jthread> workers;
      for (unsigned t = 0; t < std::min<std::size_t>(threads, n); ++t)
        workers.emplace_back([&] { all.work(task); });
      all.wait(watch);
    }
    for (const std::exception_ptr& error : all.errors_)
      if (error)
        std::rethrow_exception(error);
  }

private:
  explicit PartThreads(std::size_t n) : errors_(n + 1) {}

  template <class Task>
  void work(const Task& task) {
    for (std::size_t i = next_++; i + 1 < errors_.size() && !is_failed_; i = next_++) {
      try {
        task(i);
      } catch (...) {
        errors_[i] = std::current_exception();
        is_failed_ = true;
      }
      const std::lock_guard lock(mutex_);
      ++done_;
      change_.notify_one();
    }
  }

  // Until nothing is left to do, or something has failed.
  template <class Watch>
  void wait(const Watch& watch) {
    try {
      std::unique_lock lock(mutex_);
      while (done_ + 1 < errors_.size() && !is_failed_) {
        change_.wait_for(lock, std::chrono::milliseconds(100));
        lock.unlock();
        watch();
        lock.lock();
      }
    } catch (...) {
      errors_.back() = std::current_exception();
      is_failed_ = true;
    }
  }

  std::vector<std::exception_ptr> errors_; // of each task, and of the watch
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> is_failed_ = false;
  std::mutex mutex_;
  std::condition_variable change_;
  std::size_t done_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PART_THREADS_H
