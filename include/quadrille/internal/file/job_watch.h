#ifndef QUADRILLE_INTERNAL_FILE_JOB_WATCH_H
#define QUADRILLE_INTERNAL_FILE_JOB_WATCH_H

#include <quadrille/file_report.h>
#include <quadrille/internal/file/chunked_job.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Runs tasks 0 to n − 1, each once, on several threads. After an exception no more tasks begin,
/// and when all running tasks have ended, the exception of the lowest task is thrown.
class ChunkThreads {
public:
  /// This thread calls `watch` now and then, if there is more than one thread.
  template <class Task, class Watch>
  static void run(std::size_t n, unsigned threads, const Task& task, const Watch& watch) {
    if (threads <= 1 || n <= 1) {
      for (std::size_t i = 0; i < n; ++i)
        task(i);
      return;
    }
    ChunkThreads all(n);
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
  explicit ChunkThreads(std::size_t n) : errors_(n + 1) {}

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

  // Waits until nothing is left to do, or until something has failed.
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

/// This is thrown if a run ends because the user's `proceed` returned false.
struct JobCancelled : std::runtime_error {
  JobCancelled() : std::runtime_error("quadrille: OutOfCore::proceed has ended the run") {}
};

/// Reports the progress of a job to the user, and asks whether to go on.
class JobWatch {
public:
  explicit JobWatch(std::function<bool(const FileStatus&)> proceed)
      : proceed_(std::move(proceed)) {}

  /// Throws JobCancelled if the user cancels. `fraction` is the fraction of the stage that is done.
  void report(const ChunkedJob& job, FileStage stage, double fraction, std::size_t done = 0,
              std::size_t chunks = 0) const {
    if (!proceed_)
      return;
    FileStatus status;
    status.stage = stage;
    status.phase = job.plan().phase;
    status.phases = status.phase == 0 ? 0 : static_cast<unsigned>(job.schedule().size() + 1);
    status.chunks = chunks;
    status.chunks_done = done;
    status.faces = job.estimate().faces;
    status.estimate = job.estimate();
    status.progress = progress(job, stage, fraction);
    if (!proceed_(status))
      throw JobCancelled();
  }

  /// Runs task(i, is_cancelled) for i < n on the given number of threads; tasks should call
  /// is_cancelled() now and then. If the user cancels, it throws JobCancelled after all running
  /// tasks have ended.
  template <class Task>
  void run(const ChunkedJob& job, FileStage stage, std::size_t n, const Task& task) const {
    std::atomic<bool> is_cancelled = false;
    std::atomic<std::size_t> done = 0;
    const unsigned threads = job.budget().in_flight();
    const auto look = [&] {
      try {
        report(job, stage, static_cast<double>(done) / static_cast<double>(n), done, n);
      } catch (...) {
        is_cancelled = true;
        throw;
      }
    };
    const auto ask = [&] {
      if (std::min<std::size_t>(threads, n) <= 1) // other threads leave this to the user's thread
        look();
      return is_cancelled.load();
    };
    ChunkThreads::run(
        n, threads,
        [&](std::size_t i) {
          if (ask())
            throw JobCancelled();
          task(i, ask);
          ++done;
        },
        look);
  }

private:
  // Cutting the file takes about an eighth of the work; the rest is about proportional to the
  // number of faces with which phases begin.
  static double progress(const ChunkedJob& job, FileStage stage, double fraction) {
    const PhasePlan& plan = job.plan();
    if (stage <= FileStage::partition)
      return stage == FileStage::weld     ? 0
             : stage == FileStage::survey ? 0.04 * fraction
                                          : 0.04 + 0.06 * fraction;
    const auto all = static_cast<double>((std::max<std::uint64_t>)(plan.input.counted_faces, 1));
    double before = 0, begin = all;
    for (const std::uint64_t left : plan.faces_after_phases)
      before += std::exchange(begin, static_cast<double>(left));
    const double whole = before + begin + (plan.is_last || plan.is_exact ? 0 : faces_to_come(job));
    const double now = stage == FileStage::sample     ? 0
                       : stage == FileStage::simplify ? fraction * begin
                                                      : begin;
    return stage == FileStage::merge ? 0.98 : 0.12 + 0.86 * (before + now) / whole;
  }

  // Returns the number of faces with which the phases after this one begin.
  static double faces_to_come(const ChunkedJob& job) {
    const Schedule schedule = job.schedule();
    const bool fits = job.budget().whole_faces() > 2 * job.target() + job.target() / 5;
    const std::size_t end =
        fits ? (std::max<std::size_t>)(schedule.size(), job.plan().step + 1) : schedule.size() + 1;
    double sum = 0;
    for (std::size_t step = job.plan().step; step < end; ++step)
      sum += static_cast<double>(schedule.wanted(step, job.target()));
    return sum;
  }

  std::function<bool(const FileStatus&)> proceed_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_WATCH_H
