#ifndef QUADRILLE_EXAMPLES_PROGRAM_INTERRUPTION_H
#define QUADRILLE_EXAMPLES_PROGRAM_INTERRUPTION_H

#include <csignal>
#include <stdexcept>

namespace quadrille_examples {

/// Ctrl-C and SIGTERM: the first asks the program to end in order, a second one ends it at once.
class Interruption {
public:
  /// From now on. A signal that is ignored when the program starts, as by nohup, stays ignored.
  static void watch() {
    for (const int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, on_signal) == SIG_IGN)
        std::signal(signal, SIG_IGN);
  }
  static bool is_asked() { return signal_ != 0; }
  /// The exit status by which shells tell it: 130 for Ctrl-C.
  static int exit_status() { return 128 + signal_; }

private:
  static void on_signal(int signal) {
    signal_ = signal;
    std::signal(signal, SIG_DFL);
  }

  static inline volatile std::sig_atomic_t signal_ = 0;
};

/// Thrown where the program ends because it was interrupted.
struct Interrupted : std::runtime_error {
  explicit Interrupted(bool is_there = false)
      : std::runtime_error("interrupted"), is_output_there(is_there) {}

  bool is_output_there; ///< it had been written, and was being measured
};

} // namespace quadrille_examples

#endif
