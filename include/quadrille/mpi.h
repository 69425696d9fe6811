#ifndef QUADRILLE_MPI_H
#define QUADRILLE_MPI_H

#include <quadrille/file.h>

#define OMPI_SKIP_MPICXX 1  ///< of OpenMPI the interface of C only
#define MPICH_SKIP_MPICXX 1 ///< of MPICH the same
#include <mpi.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

/// \file
/// Surfaces larger than memory, over the ranks of an MPI program. Needs an MPI of version 3 or
/// later (Debian: libopenmpi-dev or libmpich-dev); CMake: find_package(MPI COMPONENTS C) and
/// MPI::MPI_C.

namespace quadrille {

namespace internal {

/// Which part is next, counted in the memory of the first rank. All ranks make it and destroy it
/// together.
class PartCounter {
public:
  explicit PartCounter(MPI_Comm communicator) {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    std::int64_t* count = nullptr;
    MPI_Win_allocate(rank == 0 ? sizeof(std::int64_t) : 0, sizeof(std::int64_t), MPI_INFO_NULL,
                     communicator, &count, &window_);
    MPI_Win_lock_all(0, window_);
    if (rank == 0)
      *count = 0;
    MPI_Win_sync(window_);
    MPI_Barrier(communicator);
  }
  ~PartCounter() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  PartCounter(const PartCounter&) = delete;
  PartCounter& operator=(const PartCounter&) = delete;

  std::size_t next() { return static_cast<std::size_t>(add(1)); }
  /// No rank begins another part.
  void end() { add(std::int64_t{1} << 40); }

private:
  std::int64_t add(std::int64_t number) {
    std::int64_t before = 0;
    MPI_Fetch_and_op(&number, &before, MPI_INT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
  }

  MPI_Win window_ = MPI_WIN_NULL;
};

/// The ranks of a communicator. All of them call its functions in the same order.
class Ranks {
public:
  explicit Ranks(MPI_Comm communicator) {
    MPI_Comm_dup(communicator, &communicator_);
    MPI_Comm_rank(communicator_, &rank_);
  }
  ~Ranks() { MPI_Comm_free(&communicator_); }
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool is_first() const { return rank_ == 0; }

  /// Runs a task on each rank. If it throws on one it does on all: what that threw, or that another
  /// rank has failed.
  template <class Task>
  void run(const Task& task) const {
    enum { well, cancelled, failed };
    int outcome = well, worst = well;
    std::exception_ptr error;
    try {
      task();
    } catch (const JobCancelled&) {
      outcome = cancelled;
    } catch (...) {
      outcome = failed;
      error = std::current_exception();
    }
    MPI_Allreduce(&outcome, &worst, 1, MPI_INT, MPI_MAX, communicator_);
    if (error)
      std::rethrow_exception(error);
    if (worst == failed)
      throw std::runtime_error("quadrille::simplify_file: another rank has failed");
    if (worst == cancelled)
      throw JobCancelled();
  }

  /// Runs a step on the first rank. All get the numbers that it gives.
  template <class Step>
  auto on_first(const Step& step) const {
    decltype(step()) numbers{};
    run([&] {
      if (is_first())
        numbers = step();
    });
    MPI_Bcast(numbers.data(), static_cast<int>(numbers.size()), MPI_INT64_T, 0, communicator_);
    return numbers;
  }

  /// Runs task(i) for i < n, each on one rank, as they come.
  template <class Task>
  void share(std::size_t n, const Task& task) const {
    PartCounter counter(communicator_);
    run([&] {
      try {
        for (std::size_t i = counter.next(); i < n; i = counter.next())
          task(i);
      } catch (...) {
        counter.end();
        throw;
      }
    });
  }

private:
  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0;
};

/// What all ranks know of a report: integers.
inline std::array<std::int64_t, 8> numbers_of(const FileReport& report) {
  const auto number = [](auto value) { return static_cast<std::int64_t>(value); };
  return {
      number(report.faces_before),   number(report.faces_after),   number(report.vertices_before),
      number(report.vertices_after), number(report.stop),          number(report.phases),
      number(report.parts),          number(report.is_count_exact)};
}
inline void take_numbers(const std::array<std::int64_t, 8>& numbers, FileReport& report) {
  report.faces_before = static_cast<std::size_t>(numbers[0]);
  report.faces_after = static_cast<std::size_t>(numbers[1]);
  report.vertices_before = static_cast<std::size_t>(numbers[2]);
  report.vertices_after = static_cast<std::size_t>(numbers[3]);
  report.stop = static_cast<StopReason>(numbers[4]);
  report.phases = static_cast<unsigned>(numbers[5]);
  report.parts = static_cast<std::size_t>(numbers[6]);
  report.is_count_exact = numbers[7] != 0;
}

} // namespace internal

/// simplify_file over the ranks of a communicator: all of them call it with the same arguments.
///
/// Each rank simplifies one part at a time, the next that is left; the steps between, the cut of
/// the file, the next phase, the result, are the first rank's. OutOfCore::memory is that of each
/// rank, and parts_in_flight does not count. Surfaces go through the files of the scratch folder
/// only, which all ranks must see, as they must see the input; messages hold a few integers. The
/// result has the same bytes for any number of ranks, and those of simplify_file in one process.
///
/// If a rank throws, all do, when the parts at work are done. If a rank is lost, MPI ends the job;
/// with OutOfCore::restart the next one goes on. OutOfCore::proceed is asked on the first rank,
/// between parts of its own. Returns the report on the first rank; on others its faces, vertices,
/// phases, parts, `stop` and is_count_exact.
template <class Cost = Quadric, class Placement = OptimalPlacement, class Stop, class... Policies>
FileReport simplify_file(MPI_Comm communicator, const std::filesystem::path& input,
                         const std::filesystem::path& output, const Stop& stop, OutOfCore options,
                         const Cost& cost = {}, const Placement& placement = {},
                         const Policies&... policies) {
  using Job = PartitionedSimplifier<Cost, Placement, Policies...>;
  const internal::Ranks ranks(communicator);
  if (!ranks.is_first())
    options.proceed = {};
  std::optional<Job> job;
  const auto take_up = [&](bool is_restarted) {
    options.restart = is_restarted;
    job.emplace(input, stop, options, cost, placement, policies...);
    job->partition();
  };
  const auto simplify_part = [&](std::size_t part) {
    if (!job->proceeds(part))
      throw internal::JobCancelled();
    job->simplify(part);
  };
  const auto begin = std::chrono::steady_clock::now();
  FileReport report;
  using Flag = std::array<std::int64_t, 1>;
  try {
    ranks.on_first([&] { return take_up(options.restart), Flag{}; });
    do {
      ranks.run([&] {
        if (!ranks.is_first())
          take_up(true);
      });
      ranks.share(job->parts(), simplify_part);
    } while (ranks.on_first([&] { return Flag{job->close()}; })[0] != 0);
    internal::take_numbers(ranks.on_first([&] {
      report = job->sew(output);
      return internal::numbers_of(report);
    }),
                           report);
  } catch (const internal::JobCancelled&) {
    report.stop = StopReason::cancelled;
  }
  report.seconds.contract =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

} // namespace quadrille

#endif // QUADRILLE_MPI_H
