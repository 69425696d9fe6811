#ifndef QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H
#define QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H

#include <cstddef>
#include <functional>
#include <utility>

namespace quadrille::internal {

/// This is thrown if the receiver of the progress cancels the check.
struct CheckCancelled {};

/// Reports the progress of verify(), in stages of equal length, and throws if the receiver cancels
/// it.
class CheckProgress {
public:
  CheckProgress(std::function<bool(double)> reported, std::size_t stages)
      : reported_(std::move(reported)), stages_(static_cast<double>(stages)) {}

  /// Reports the fraction of the present stage that is done, from 0 to 1. Throws CheckCancelled.
  void at(double fraction) {
    fraction_ = fraction;
    report();
  }
  /// Counts a step; there are too many steps to report each one.
  void step() {
    if (++steps_ % steps_between_words == 0)
      report();
  }
  void next_stage() {
    ++stage_;
    fraction_ = 0;
  }

private:
  static constexpr std::size_t steps_between_words = 256;

  void report() const {
    if (reported_ && !reported_((static_cast<double>(stage_) + fraction_) / stages_))
      throw CheckCancelled{};
  }

  std::function<bool(double)> reported_;
  double stages_, fraction_ = 0;
  std::size_t stage_ = 0, steps_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H
