#ifndef QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H
#define QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H

#include <cstddef>
#include <functional>
#include <utility>

namespace quadrille::internal {

/// Thrown where whoever is told of the progress wants no more.
struct CheckCancelled {};

/// Tells how far verify() is, by stages of the same length, and hears whether it is to go on.
class CheckProgress {
public:
  CheckProgress(std::function<bool(double)> told, std::size_t stages)
      : reported_(std::move(told)), stages_(static_cast<double>(stages)) {}

  /// So much of the present stage is done, from 0 to 1. Throws CheckCancelled.
  void at(double part) {
    part_ = part;
    tell();
  }
  /// A step has been done, of which there are too many to tell each.
  void step() {
    if (++steps_ % steps_between_words == 0)
      tell();
  }
  void next_stage() {
    ++stage_;
    part_ = 0;
  }

private:
  static constexpr std::size_t steps_between_words = 256;

  void tell() const {
    if (reported_ && !reported_((static_cast<double>(stage_) + part_) / stages_))
      throw CheckCancelled{};
  }

  std::function<bool(double)> reported_;
  double stages_, part_ = 0;
  std::size_t stage_ = 0, steps_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECK_PROGRESS_H
