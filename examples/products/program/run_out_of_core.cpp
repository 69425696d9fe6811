#include "check_chunks.h"
#include "file_progress.h"
#include "launch.h"
#include "outcome.h"
#include "runs.h"
#include "simplify_mesh.h"
#include "tiles.h"

#include "../chunks/policies_of_chunks.h"
#include "../mesh_io/attributes/mesh_channels.h"
#include "../mesh_io/replace_file.h"

#include <quadrille/file.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace quadrille_examples {

namespace {

using quadrille::FileReport;
using quadrille::internal::BuiltInPlacement;
using quadrille::internal::DistanceChoice;

quadrille::OutOfCore out_of_core(const Options& options, FileProgress& progress) {
  quadrille::OutOfCore result;
  result.scratch = options.scratch;
  result.memory = options.memory;
  result.chunks_in_flight = options.threads;
  result.restart = options.restarts || options.step == "close";
  result.attribute_importance = options.cost.empty() ? 1 : hardly;
  result.positions_only = options.positions_only;
  result.tolerance = options.target.tolerance;
  result.locks_boundary = options.locks_boundaries;
  result.keeps_tiles = keeps_tiles(options);
  result.welds = options.weld.has_value();
  result.proceed = [&](const quadrille::FileStatus& status) {
    progress.show(status);
    return !Interruption::is_asked();
  };
  return result;
}

/// A run by parts, or a step of one.
class ChunksRun {
public:
  ChunksRun(const Options& options, ProgressLine& progress) : options_(options), line_(progress) {
    if (options.step.empty() && launched_processes() > 1)
      launch_.emplace();
    progress_.emplace(options, progress, !launch_ || launch_->is_first());
  }

  /// Of ranks the first one tells how it ended, and only its status counts, as otherwise mpirun
  /// might end it before it has.
  bool run() {
    if (!launch_ || launch_->is_first())
      return run_to_end();
    try {
      run_cost();
    } catch (const std::exception&) {
    }
    return true;
  }

private:
  bool run_to_end() {
    try {
      return run_cost();
    } catch (const Interrupted&) {
      progress_->end("interrupted", std::nullopt);
      throw;
    } catch (const quadrille::internal::JobCancelled&) { // of a step
      progress_->end("interrupted", std::nullopt);
      throw Interrupted();
    } catch (const std::exception& error) {
      progress_->end("failed", std::nullopt, error.what());
      throw;
    }
  }

  void require_files() const {
    if (!keeps_tiles(options_) && output_extension(options_) != ".ply")
      throw std::runtime_error(options_.output + ": --out-of-core writes PLY only");
    if (is_standard_input(options_.input) || is_standard_output(options_.output))
      throw std::runtime_error(
          "--out-of-core reads and writes files, not standard input or output");
    if (options_.memory < 128'000'000)
      throw std::runtime_error("--memory: too little; the least is 128M");
    if (options_.measures || options_.verifies)
      require_input_stays();
    if (keeps_tiles(options_))
      return;
    require_replaceable(options_.output, options_.is_forced);
    quadrille::internal::require_writable(options_.output);
  }

  /// What is measured by parts is measured between files.
  void require_input_stays() const {
    std::set<std::filesystem::path> results;
    for (const std::filesystem::path& result : result_files(options_).paths)
      results.insert(std::filesystem::weakly_canonical(result));
    for (const std::filesystem::path& input : surface_files(options_).paths)
      if (results.count(std::filesystem::weakly_canonical(input)) > 0)
        throw std::runtime_error(
            input.string() + ": is both IN and OUT, so IN will be gone when OUT is to be measured");
  }

  bool run_cost() {
    if (launch_)
      launch_->on_first([&] { require_files(); });
    else
      require_files();
    if (options_.target.faces && options_.target.ratio)
      throw std::runtime_error("--out-of-core takes --faces or --keep, not both");
    const quadrille::SoupOptions soup = soup_options(options_);
    const auto limit = limit_of_chunks(soup, options_.target.tolerance);
    return with_policies_of_chunks(
        soup, limit.has_value(), [&](const auto& cost, const auto& stop) {
          return run_with(cost, stop, placement_of_chunks<std::decay_t<decltype(cost)>>(soup),
                          limit);
        });
  }

  template <class Cost, class Stop>
  bool run_with(const Cost& cost, const Stop& stop, const BuiltInPlacement& placement,
                const std::optional<DistanceChoice>& limit) {
    const quadrille::OutOfCore how = out_of_core(options_, *progress_);
    const quadrille::SurfaceFiles files = surface_files(options_);
    const quadrille::Topology kept = topology(options_);
    if (launch_)
      return report_on(
          launch_->simplify_file(files, options_.output, stop, how, cost, placement, kept, limit));
    quadrille::PartitionedSimplifier<Cost, BuiltInPlacement, quadrille::Topology,
                                     std::optional<DistanceChoice>>
        job(files, stop, how, cost, placement, kept, limit);
    return options_.step.empty() ? report_on(job(options_.output)) : step(job);
  }

  template <class Job>
  bool step(Job& job) {
    const bool is_part = options_.step != "cut" && options_.step != "close";
    if (is_part)
      job.join();
    else
      begin(job);
    if (options_.step == "close" && !job.close()) {
      line_.clear();
      const bool is_met = report_on(job.merge(options_.output), true);
      std::cout << 0 << std::endl;
      return is_met;
    }
    if (is_part)
      simplify(job, static_cast<std::size_t>(std::stoull(options_.step)));
    line_.clear();
    progress_->end("done", std::nullopt);
    std::cout << job.chunks() << std::endl;
    return true;
  }

  template <class Job>
  void begin(Job& job) const {
    if (options_.step == "cut")
      job.require_output(options_.output);
    job.partition();
  }

  template <class Job>
  void simplify(Job& job, std::size_t part) {
    if (part >= job.chunks())
      throw std::runtime_error("--step " + options_.step + ": the phase has " +
                               std::to_string(job.chunks()) + " chunks, numbered from 0");
    if (!job.simplify(part, [] { return Interruption::is_asked(); }))
      throw Interrupted();
  }

  bool report_on(const FileReport& report, bool is_step = false) {
    if (report.stop == quadrille::StopReason::cancelled)
      throw Interrupted();
    if (launch_ && !launch_->is_first())
      return true;
    Outcome outcome{options_.output, options_.target, report, report.diagonal, {}, {}, report};
    check(outcome);
    line_.clear();
    progress_->end("done", report.faces_after);
    for (const std::string& dropped : report.dropped)
      print_remark(options_, "left out: " + dropped);
    const auto remark = [&](std::uint64_t count, const char* what) {
      if (count > 0)
        print_remark(options_, std::string(what) + ": " + std::to_string(count));
    };
    remark(report.short_faces, "faces left out (fewer than three different corners)");
    remark(report.fans, "polygons cut into fans (without area, or crossing themselves)");
    remark(report.welded_vertices, "vertices merged with another one at the same place");
    if (!report.is_count_exact)
      print_remark(
          options_,
          "the number of faces is not exact, since the whole result does not fit into memory: " +
              with_commas(report.faces_after) + "");
    remark(report.unused_not_finite, "isolated vertices left out (not finite)");
    remark(report.doubled_faces, "duplicate faces left out (same corners, same winding)");
    Options options = options_;
    options.is_quiet = options.is_quiet || is_step;
    return tell(options, {outcome});
  }

  /// Of what is written, in the folder in which parts have been.
  void check(Outcome& outcome) {
    if (outcome.report.faces_after == 0 || !(options_.measures || options_.verifies))
      return;
    const quadrille::OutOfCore how = out_of_core(options_, *progress_);
    const quadrille::SurfaceFiles input = surface_files(options_), result = result_files(options_);
    try {
      if (options_.measures)
        outcome.measured = measure_files(input, result, how);
      if (options_.verifies)
        outcome.verdict = verify_files(outcome.report, input, result, how);
    } catch (const quadrille::internal::JobCancelled&) {
      throw Interrupted(true);
    }
  }

  const Options& options_;
  ProgressLine& line_;
  std::optional<Launch> launch_; // where there are several ranks
  std::optional<FileProgress> progress_;
};

/// Faces of a file, if it is one that could be simplified by parts.
std::optional<std::uint64_t> faces_of_file(const std::filesystem::path& path) {
  try {
    if (equal_ignoring_case(path.extension().string(), ".stl"))
      return std::filesystem::file_size(path) / 50;
    if (equal_ignoring_case(path.extension().string(), ".ply"))
      return quadrille::internal::PlyInput(path).faces();
  } catch (const std::exception&) { // reading it will tell
  }
  return std::nullopt;
}

/// Of this process at most, in bytes.
double memory_there_is() {
  double memory =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  struct ::rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    memory = std::min(memory, static_cast<double>(limit.rlim_cur));
  return memory;
}

} // namespace

bool run_out_of_core(const Options& options, ProgressLine& progress) {
  return ChunksRun(options, progress).run();
}

void print_remark_of_memory(const Options& options) {
  constexpr double bytes_of_face = 250;
  const std::optional<std::uint64_t> faces = faces_of_file(options.input);
  const double needed = bytes_of_face * static_cast<double>(faces.value_or(0));
  if (needed > memory_there_is())
    print_remark(options,
                 "its " + with_commas(*faces) + " faces need about " + two_digits(needed / 1e9) +
                     " GB of memory, more than is available: " + "--out-of-core FOLDER needs less");
}

} // namespace quadrille_examples
