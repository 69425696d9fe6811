#ifndef QUADRILLE_EXAMPLES_PROGRAM_FILE_PROGRESS_H
#define QUADRILLE_EXAMPLES_PROGRAM_FILE_PROGRESS_H

#include "figures.h"
#include "options.h"
#include "progress_line.h"
#include "runs.h"

#include <quadrille/file_report.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

namespace quadrille_examples {

/// How far a run by parts is: on a line of the terminal; where standard error is none, as in batch
/// jobs, on a line for each phase and each minute; and in the file of --progress, as a line of JSON
/// for each stage and each second.
class FileProgress {
public:
  /// Throws if the file could not be written. What a run wrote that this one goes on with stays.
  FileProgress(const Options& options, ProgressLine& line, bool is_first_rank)
      : options_(options), line_(line), has_received_(is_first_rank) {
    if (!has_received_ || options.progress.empty())
      return;
    const bool goes_on = options.restarts || !options.step.empty();
    file_.open(options.progress, goes_on ? std::ios::app : std::ios::trunc);
    if (!file_)
      throw std::runtime_error(options.progress + ": cannot be written");
  }

  void show(const quadrille::FileStatus& status) {
    if (!has_received_)
      return;
    const Clock::time_point now = Clock::now();
    const bool is_new = !last_ || last_->stage != status.stage || last_->phase != status.phase;
    if (!is_new && now - looked_ < std::chrono::milliseconds(100))
      return;
    looked_ = now;
    if (!last_)
      from_ = status.progress;
    if (line_.is_shown())
      line_.show_text(text_of(status));
    else if (!options_.is_quiet)
      print_batch(status, now);
    if (file_.is_open() && (is_new || now - written_ >= std::chrono::seconds(1)))
      write(status, now);
    last_ = status;
  }

  /// How it ended: done, interrupted or failed, with the faces that are left, or what is wrong.
  void end(const std::string& how, std::optional<std::size_t> faces_after,
           const std::string& message = "");

private:
  using Clock = std::chrono::steady_clock;

  double passed() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  // In seconds, once there is enough to tell from.
  std::optional<double> to_go(const quadrille::FileStatus& status) const {
    const double done = status.progress - from_;
    if (passed() < 5 || done < 0.02 || status.stage == quadrille::FileStage::check)
      return std::nullopt;
    return passed() * (1 - status.progress) / done;
  }

  std::string text_of(const quadrille::FileStatus& status) const {
    std::string text{to_string(status.stage)};
    if (status.phase > 0)
      text += ", phase " + std::to_string(status.phase) + " of " + std::to_string(status.phases);
    if (status.chunks > 0)
      text += ", " + with_commas(status.chunks_done) + " of " + with_commas(status.chunks) + " " +
              (status.stage == quadrille::FileStage::sample ? "samples" : "chunks");
    if (const std::optional<double> seconds = to_go(status))
      text += ", about " + duration_text(*seconds) + " to go";
    return text;
  }

  void print_batch(const quadrille::FileStatus& status, Clock::time_point now) {
    using quadrille::FileStage;
    const bool is_step = !options_.step.empty();
    const bool is_cut = status.stage >= FileStage::partition; // else it may be refused
    const bool is_phase = status.phase > phase_ && status.stage == FileStage::simplify;
    if (is_cut && !is_estimate_printed_ && !is_step)
      print_remark(options_, "about " + text_of(status.estimate));
    is_estimate_printed_ = is_estimate_printed_ || is_cut;
    if ((is_phase && !is_step) || now - reported_ >= std::chrono::minutes(1)) {
      print_remark(options_, text_of(status));
      reported_ = now;
    }
    if (is_phase)
      phase_ = status.phase;
  }
  static std::string text_of(const quadrille::FileEstimate& estimate) {
    const auto gigabytes = [](std::uint64_t bytes) {
      return two_digits(static_cast<double>(bytes) / 1e9) + " GB";
    };
    return duration_text(estimate.seconds) + ", " + gigabytes(estimate.memory) + " of memory and " +
           gigabytes(estimate.scratch) + " in the scratch folder";
  }

  void write(const quadrille::FileStatus& status, Clock::time_point now);

  const Options& options_;
  ProgressLine& line_;
  bool has_received_, is_estimate_printed_ = false;
  std::ofstream file_;
  std::optional<quadrille::FileStatus> last_;
  unsigned phase_ = 0; // that has been told
  double from_ = 0;    // of the progress, where this run goes on
  Clock::time_point began_ = Clock::now(), looked_{}, written_{}, reported_ = began_;
};

} // namespace quadrille_examples

#endif
