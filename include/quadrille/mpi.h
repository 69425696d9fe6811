#ifndef QUADRILLE_MPI_H
#define QUADRILLE_MPI_H

#include <quadrille/file.h>
#include <quadrille/internal/file/task_claims.h>

#define OMPI_SKIP_MPICXX 1  ///< uses the interface of C only, with OpenMPI
#define MPICH_SKIP_MPICXX 1 ///< uses the interface of C only, with MPICH
#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>

/// \file
/// Surfaces larger than memory, over the ranks of an MPI program. Needs an MPI of version 3 or
/// later (Debian: libopenmpi-dev or libmpich-dev); CMake: find_package(MPI COMPONENTS C) and
/// MPI::MPI_C.

namespace quadrille {

namespace internal {

/// The ranks of a communicator. All of them call its functions in the same order.
class Ranks {
public:
  explicit Ranks(MPI_Comm communicator) {
    MPI_Comm_dup(communicator, &communicator_);
    MPI_Comm_rank(communicator_, &rank_);
    MPI_Comm_size(communicator_, &size_);
  }
  ~Ranks() { MPI_Comm_free(&communicator_); }
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool is_first() const { return rank_ == 0; }
  std::size_t size() const { return static_cast<std::size_t>(size_); }

  /// Runs a task on each rank. If it throws on some it does on all: what it threw there, and on the
  /// others what the first of these said.
  template <class Task>
  void run(const Task& task) const {
    bool is_cancelled = false;
    std::exception_ptr error;
    std::string message;
    try {
      task();
    } catch (const JobCancelled&) {
      is_cancelled = true;
    } catch (const std::exception& exception) {
      error = std::current_exception();
      message = exception.what();
    } catch (...) {
      error = std::current_exception();
    }
    const auto [failed, cancelled] = first_of({error != nullptr, is_cancelled});
    if (failed < size_)
      notify_all(message, failed);
    if (error)
      std::rethrow_exception(error);
    if (failed < size_)
      throw std::runtime_error("rank " + std::to_string(failed) + ": " + message);
    if (cancelled < size_)
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

  /// Runs task(i) for i < n, each on one rank, as they come: see TaskClaims, which are in a folder
  /// that is made in `shared`, and is gone at the end. All ranks have to see that.
  template <class Task>
  void share(std::size_t n, const Task& task,
             const std::filesystem::path& shared = std::filesystem::temp_directory_path()) const {
    const auto number = on_first([&] {
      const std::random_device::result_type random = std::random_device()();
      std::filesystem::create_directory(claims(shared, random));
      return std::array<std::int64_t, 1>{random};
    })[0];
    const std::filesystem::path folder = claims(shared, number);
    const auto remove = [&](const void*) {
      std::error_code ignored;
      if (is_first())
        std::filesystem::remove_all(folder, ignored);
    };
    const std::unique_ptr<const void, decltype(remove)> at_end(this, remove);
    run([&] {
      if (!std::filesystem::exists(folder))
        fail_file(folder, "does not exist for rank " + std::to_string(rank_) +
                              ": all ranks must see the same scratch folder");
    });
    run([&] { run_claimed(folder, n, task); });
  }

private:
  static std::filesystem::path claims(const std::filesystem::path& shared, std::int64_t number) {
    return shared / ("claims-" + std::to_string(number));
  }

  template <class Task>
  void run_claimed(const std::filesystem::path& folder, std::size_t n, const Task& task) const {
    TaskClaims claims(folder, n, static_cast<std::size_t>(rank_), static_cast<std::size_t>(size_));
    try {
      while (const std::optional<std::size_t> i = claims.next())
        task(*i);
    } catch (...) {
      claims.end();
      throw;
    }
  }

  // The first rank of which each is true, or how many there are. Who waits sleeps, so that those
  // who work have all processors.
  std::array<int, 2> first_of(const std::array<bool, 2>& is_true) const {
    const std::array<int, 2> own{is_true[0] ? rank_ : size_, is_true[1] ? rank_ : size_};
    std::array<int, 2> first{};
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(own.data(), first.data(), 2, MPI_INT, MPI_MIN, communicator_, &request);
    for (int is_there = 0; MPI_Test(&request, &is_there, MPI_STATUS_IGNORE), is_there == 0;)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return first;
  }

  // Sends the text of one rank to all.
  void notify_all(std::string& text, int from) const {
    int size = static_cast<int>(text.size());
    MPI_Bcast(&size, 1, MPI_INT, from, communicator_);
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), size, MPI_CHAR, from, communicator_);
  }

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

/// The integers of a report, which all ranks know.
inline std::array<std::int64_t, 8> numbers_of(const FileReport& report) {
  const auto number = [](auto value) { return static_cast<std::int64_t>(value); };
  return {
      number(report.faces_before),   number(report.faces_after),   number(report.vertices_before),
      number(report.vertices_after), number(report.stop),          number(report.phases),
      number(report.chunks),         number(report.is_count_exact)};
}
inline void take_numbers(const std::array<std::int64_t, 8>& numbers, FileReport& report) {
  report.faces_before = static_cast<std::size_t>(numbers[0]);
  report.faces_after = static_cast<std::size_t>(numbers[1]);
  report.vertices_before = static_cast<std::size_t>(numbers[2]);
  report.vertices_after = static_cast<std::size_t>(numbers[3]);
  report.stop = static_cast<StopReason>(numbers[4]);
  report.phases = static_cast<unsigned>(numbers[5]);
  report.chunks = static_cast<std::size_t>(numbers[6]);
  report.is_count_exact = numbers[7] != 0;
}

/// simplify_file by a Job of each rank, which `make` makes.
template <class Job, class Make>
class JobOverRanks {
public:
  JobOverRanks(MPI_Comm communicator, const Make& make) : ranks_(communicator), make_(make) {}

  FileReport run(const std::filesystem::path& output) {
    const auto begin = std::chrono::steady_clock::now();
    FileReport report;
    try {
      ranks_.on_first([&] {
        make_(job_);
        job_->require_output(output);
        job_->cut();
        return Flag{};
      });
      do
        simplify_phase();
      while (ranks_.on_first([&] { return Flag{job_->regroup()}; })[0] != 0);
      take_numbers(ranks_.on_first([&] {
        report = job_->merge(output);
        return numbers_of(report);
      }),
                   report);
    } catch (const JobCancelled&) {
      report.stop = StopReason::cancelled;
    }
    report.seconds.contract =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
  }

private:
  using Flag = std::array<std::int64_t, 1>;

  void simplify_phase() {
    take_up_on_others();
    const auto is_cancelled = [this] { return this->is_cancelled(); };
    if (job_->samples() > 0) {
      share(job_->samples(), [&](std::size_t i) { return job_->sample(i, is_cancelled); });
      ranks_.on_first([&] { return job_->resolve(), Flag{}; });
      take_up_on_others();
    }
    share(job_->chunks(), [&](std::size_t chunk) { return job_->simplify(chunk, is_cancelled); });
  }

  bool is_cancelled() {
    const std::size_t all = job_->samples() > 0 ? job_->samples() : job_->chunks();
    return !job_->proceeds((std::min)(done_ * ranks_.size(), all));
  }

  template <class Task>
  void share(std::size_t n, const Task& task) {
    done_ = 0;
    ranks_.share(
        n,
        [&](std::size_t i) {
          if (is_cancelled() || !task(i))
            throw JobCancelled();
          ++done_;
        },
        job_->phase_folder());
  }

  void take_up_on_others() {
    ranks_.run([&] {
      if (!ranks_.is_first())
        make_(job_), job_->join();
    });
  }

  const Ranks ranks_;
  const Make& make_;
  std::optional<Job> job_;
  std::size_t done_ = 0; // by this rank
};

} // namespace internal

/// simplify_file over the ranks of a communicator: all of them call it with the same arguments.
///
/// Each rank simplifies one chunk at a time, or takes samples of one, the next that is left, and
/// asks no other rank for it; the steps between, the cut of the file, the next phase, the result,
/// are the first rank's.
/// OutOfCore::memory is that of each rank, and chunks_in_flight does not count. Surfaces go through
/// the files of the scratch folder only, which all ranks must see, as they must see the input;
/// messages hold a few integers. The result has the same bytes for any number of ranks, and those
/// of simplify_file in one process.
///
/// If a rank throws, all do, when the chunks in flight are done: the others a std::runtime_error
/// with its number and what it said. If a rank is lost, MPI ends the job; with OutOfCore::restart
/// the next one goes on. OutOfCore::proceed is asked on each rank, where there is one, and ends the
/// job of all. Returns the report on the first rank; on others its faces, vertices, phases, chunks,
/// `stop` and is_count_exact.
template <class Cost = Quadric, class Placement = OptimalPlacement, class Stop, class... Policies>
FileReport simplify_file(MPI_Comm communicator, const SurfaceFiles& input,
                         const std::filesystem::path& output, const Stop& stop,
                         const OutOfCore& options, const Cost& cost = {},
                         const Placement& placement = {}, const Policies&... policies) {
  const auto target = internal::faces_and_limit(stop);
  return std::apply(
      [&](const auto&... limit) {
        using Job =
            PartitionedSimplifier<Cost, Placement, Policies..., std::decay_t<decltype(limit)>...>;
        const auto make = [&](std::optional<Job>& job) {
          job.emplace(input, target.first, options, cost, placement, policies..., limit...);
        };
        return internal::JobOverRanks<Job, decltype(make)>(communicator, make).run(output);
      },
      target.second);
}

} // namespace quadrille

#endif // QUADRILLE_MPI_H
