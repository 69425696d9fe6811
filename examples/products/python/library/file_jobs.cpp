// Simplifications from a file to a file, by parts.
#include "jobs.h"

#include "../../chunks/policies_of_chunks.h"

#include <quadrille/c/call.h>
#include <quadrille/compiled.h>
#include <quadrille/file.h>
#include <quadrille/report.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace quadrille;
using internal::BuiltInPlacement;
using internal::DistanceChoice;

namespace {

/// A function of Python, which is asked by one thread at a time: a generator answers.
struct AskedFunction {
  quadrille_file_progress function;
  std::mutex mutex = {};
};
using Asked = std::shared_ptr<AskedFunction>;

/// Asks a function at each stage and up to 25 times a second.
class FileProgress {
public:
  explicit FileProgress(Asked asked) : function_(std::move(asked)) {}

  bool operator()(const FileStatus& status) {
    const std::lock_guard lock(function_->mutex);
    const bool is_new = status.stage != last_.stage || status.phase != last_.phase;
    last_ = status;
    return ask(is_new || status.progress >= 1);
  }
  /// Asks while a part is simplified, of which nothing new is known.
  bool operator()() {
    const std::lock_guard lock(function_->mutex);
    return ask(false);
  }

private:
  bool ask(bool at_once) {
    const auto now = std::chrono::steady_clock::now();
    if (!function_->function || (!at_once && now - asked_ < std::chrono::milliseconds(40)))
      return true;
    asked_ = now;
    const FileStatus& s = last_;
    const int32_t answer = function_->function(
        {static_cast<int32_t>(s.stage), s.phase, s.phases, s.chunks, s.chunks_done, s.faces,
         s.progress, s.estimate.faces, s.estimate.memory, s.estimate.scratch, s.estimate.output,
         s.estimate.seconds});
    if (answer < 0)
      throw internal::FunctionFailed("progress");
    return answer != 0;
  }

  Asked function_;
  std::chrono::steady_clock::time_point asked_{}; // long ago
  FileStatus last_{.phase = 0};
};

} // namespace

/// The steps of a job, whatever its cost.
struct quadrille_file_job {
  quadrille_file_job() = default;
  quadrille_file_job(const quadrille_file_job&) = delete;
  quadrille_file_job& operator=(const quadrille_file_job&) = delete;
  virtual ~quadrille_file_job() = default;

  virtual FileEstimate estimate() const = 0;
  virtual std::size_t partition() = 0; ///< how many parts come next
  virtual std::size_t join() = 0;      ///< the same
  virtual void simplify(std::size_t part) const = 0;
  virtual std::size_t close() = 0; ///< the same, or 0 if nothing does
  virtual FileReport merge(const std::filesystem::path& output) = 0;
  virtual FileReport run(const std::filesystem::path& output) = 0;
};

namespace {

template <class Cost>
class FileJobBy : public quadrille_file_job {
public:
  template <class Stop>
  FileJobBy(const SurfaceFiles& input, const Stop& stop, const OutOfCore& how, const Cost& cost,
            const SoupOptions& options, Asked progress)
      : progress_(std::move(progress)),
        job_(input, stop, how, cost, quadrille_examples::placement_of_chunks<Cost>(options),
             options.topology.value_or(Topology::kept),
             quadrille_examples::limit_of_chunks(options, how.tolerance)) {}

  FileEstimate estimate() const override { return job_.estimate(); }
  std::size_t partition() override { return job_.partition(), job_.chunks(); }
  std::size_t join() override { return job_.join(), job_.chunks(); }
  void simplify(std::size_t part) const override {
    if (part >= job_.chunks())
      throw std::out_of_range("part is " + std::to_string(part) + ", but the phase has " +
                              std::to_string(job_.chunks()) + " parts, numbered from 0");
    FileProgress proceed(progress_);
    job_.simplify(part, [&] { return !proceed(); });
  }
  std::size_t close() override { return job_.close() ? job_.chunks() : 0; }
  FileReport merge(const std::filesystem::path& output) override { return job_.merge(output); }
  FileReport run(const std::filesystem::path& output) override { return job_(output); }

private:
  Asked progress_;
  PartitionedSimplifier<Cost, BuiltInPlacement, Topology, std::optional<DistanceChoice>> job_;
};

OutOfCore how_of(const quadrille_bag& bag) {
  OutOfCore how;
  how.scratch = bag.path("scratch");
  const auto counts = bag.numbers<std::uint64_t>("counts");
  how.memory = counts[0];
  how.chunks_in_flight = static_cast<unsigned>(counts[1]);
  how.chunk_faces = counts[2];
  how.tolerance = bag.text("tolerance");
  how.restart = bag.flag("restart");
  how.positions_only = bag.flag("positions_only");
  how.keeps_tiles = bag.flag("keeps_tiles");
  how.locks_boundary = bag.flag("locks_boundary");
  how.welds = bag.flag("welds");
  how.attribute_importance = bag.number("attribute_importance");
  return how;
}

std::unique_ptr<quadrille_file_job> job_of(const quadrille_bag& bag, const SoupOptions& options,
                                           quadrille_file_progress function) {
  OutOfCore how = how_of(bag);
  const Asked progress(new AskedFunction{function});
  how.proceed = [proceed = std::make_shared<FileProgress>(progress)](const FileStatus& status) {
    return (*proceed)(status);
  };
  std::vector<std::filesystem::path> paths;
  for (const std::string& path : bag.texts("paths"))
    paths.emplace_back(path);
  const SurfaceFiles input(std::move(paths));
  const bool is_limited = quadrille_examples::limit_of_chunks(options, how.tolerance).has_value();
  return quadrille_examples::with_policies_of_chunks(
      options, is_limited,
      [&]<class Cost>(const Cost& cost, const auto& stop) -> std::unique_ptr<quadrille_file_job> {
        return std::make_unique<FileJobBy<Cost>>(input, stop, how, cost, options, progress);
      });
}

/// Gives a report, and what one of a file has beside what any has.
void give_report_of_file(quadrille_bag& bag, const FileReport& report) {
  quadrille_examples::give_report(bag, report);
  bag.give("faces_of_phases",
           std::vector<std::int64_t>(report.faces_of_phases.begin(), report.faces_of_phases.end()));
  const auto count = [](std::uint64_t number) { return static_cast<std::int64_t>(number); };
  bag.give("counts",
           std::vector<std::int64_t>{report.phases, count(report.chunks), report.is_count_exact,
                                     count(report.bytes_read), count(report.bytes_written),
                                     count(report.peak_memory), count(report.welded_vertices),
                                     count(report.fans), count(report.short_faces),
                                     count(report.unused_not_finite)});
  bag.give_numbers("diagonal", report.diagonal);
  bag.give_texts("dropped", report.dropped);
}

void give_count(quadrille_bag& bag, std::size_t parts) {
  bag.give("parts", std::vector<std::int64_t>{static_cast<std::int64_t>(parts)});
}

void do_step(quadrille_file_job& job, std::string_view step, quadrille_bag& bag) {
  if (step == "estimate") {
    const FileEstimate estimate = job.estimate();
    bag.give("estimate", std::vector<std::int64_t>{static_cast<std::int64_t>(estimate.faces),
                                                   static_cast<std::int64_t>(estimate.memory),
                                                   static_cast<std::int64_t>(estimate.scratch),
                                                   static_cast<std::int64_t>(estimate.output)});
    bag.give_numbers("seconds", estimate.seconds);
  } else if (step == "partition") {
    give_count(bag, job.partition());
  } else if (step == "join") {
    give_count(bag, job.join());
  } else if (step == "simplify") {
    job.simplify(static_cast<std::size_t>(bag.numbers<std::uint64_t>("part")[0]));
  } else if (step == "close") {
    give_count(bag, job.close());
  } else if (step == "merge") {
    give_report_of_file(bag, job.merge(bag.path("output")));
  } else {
    give_report_of_file(bag, job.run(bag.path("output")));
  }
}

/// A step that is not due is no invalid argument.
template <class Task>
void with_steps_as_runtime_errors(const Task& task) {
  try {
    task();
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::out_of_range&) {
    throw;
  } catch (const std::logic_error& error) {
    throw std::runtime_error(error.what());
  }
}

} // namespace

extern "C" {

quadrille_file_job* quadrille_file_job_new(quadrille_bag* bag, const quadrille_call* call,
                                           quadrille_file_progress progress, int32_t* code) {
  quadrille_file_job* job = nullptr;
  *code = internal::code_of(bag->error, [&] {
    with_steps_as_runtime_errors([&] { job = job_of(*bag, call->job, progress).release(); });
  });
  return job;
}

void quadrille_file_job_delete(quadrille_file_job* job) {
  delete job;
}

int32_t quadrille_file_job_step(quadrille_file_job* job, const char* step, quadrille_bag* bag) {
  return internal::code_of(
      bag->error, [&] { with_steps_as_runtime_errors([&] { do_step(*job, step, *bag); }); });
}

} // extern "C"
