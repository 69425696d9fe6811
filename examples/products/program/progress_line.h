#ifndef QUADRILLE_EXAMPLES_PROGRAM_PROGRESS_LINE_H
#define QUADRILLE_EXAMPLES_PROGRAM_PROGRESS_LINE_H

#include "figures.h"

#include <quadrille/report.h>

#include <chrono>
#include <iostream>
#include <string>

namespace quadrille_examples {

/// A line on a terminal that tells how far the program is, and is gone at the end. Anywhere else
/// there is none.
class ProgressLine {
public:
  explicit ProgressLine(bool is_shown) : is_shown_(is_shown) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }

  /// Takes the line away, so that something else can be printed.
  void clear() {
    if (is_there_)
      std::cerr << "\r\033[K" << std::flush;
    is_there_ = false;
  }

  void show_stage(const std::string& stage) {
    began_ = {};
    show(stage, Clock::now());
  }

  /// While something else is done, of which so much is behind, from 0 to 1.
  void show_part(const std::string& stage, double part) {
    const Clock::time_point now = Clock::now();
    if (is_shown_ && now - last_ >= std::chrono::milliseconds(100))
      show(stage + ", " + std::to_string(static_cast<int>(100 * part)) + " % done", now);
  }

  /// While a surface is simplified; hardly more often than ten times a second.
  void show(const quadrille::Status& status) {
    const Clock::time_point now = Clock::now();
    if (!is_shown_ || now - last_ < std::chrono::milliseconds(100))
      return;
    if (status.progress == 0)
      return show("preparing", now);
    if (began_ == Clock::time_point())
      began_ = now;
    const double passed = std::chrono::duration<double>(now - began_).count();
    std::string text = "simplifying: " + with_commas(status.faces) + " faces left";
    if (passed > 1 && status.progress < 1)
      text +=
          ", about " + duration_text(passed * (1 - status.progress) / status.progress) + " to go";
    show(text, now);
  }

  /// Is it on a terminal?
  bool is_shown() const { return is_shown_; }
  void show_text(const std::string& text) { show(text, Clock::now()); }

private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& text, Clock::time_point now) {
    if (!is_shown_)
      return;
    std::cerr << "\r\033[K" << text << std::flush;
    is_there_ = true;
    last_ = now;
  }

  bool is_shown_;
  bool is_there_ = false;
  Clock::time_point last_{}, began_{};
};

} // namespace quadrille_examples

#endif
