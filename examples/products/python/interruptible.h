#ifndef QUADRILLE_EXAMPLES_PYTHON_INTERRUPTIBLE_H
#define QUADRILLE_EXAMPLES_PYTHON_INTERRUPTIBLE_H

#include <quadrille/file_report.h>
#include <quadrille/report.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <utility>

namespace quadrille_examples {

namespace py = pybind11;

/// What a simplification or a verification asks now and then, without the lock of the interpreter:
/// up to 25 times a second it takes the lock, lets Python handle signals, such as that of Ctrl-C,
/// and calls a function of the user's. What these raise ends it.
class Interruptible {
public:
  /// `progress` is a function or None.
  explicit Interruptible(py::object progress) : progress_(std::move(progress)) {}

  bool operator()(const quadrille::Status& status) { return ask(status, status.progress); }
  /// Each stage of a file is told.
  bool operator()(const quadrille::FileStatus& status) {
    if (std::exchange(stage_, status.stage) != status.stage ||
        std::exchange(phase_, status.phase) != status.phase)
      last_ = {};
    return ask(status, status.progress);
  }
  bool operator()(double part) { return ask(part, part); }

private:
  template <class Told>
  bool ask(const Told& told, double part) {
    const auto now = Clock::now();
    if (now - last_ < pause && part < 1)
      return true;
    last_ = now;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (progress_.is_none())
      return true;
    const py::object answer = progress_(told);
    return answer.is_none() || answer.cast<bool>();
  }

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds pause{40};

  py::object progress_;
  Clock::time_point last_{}; // long ago
  quadrille::FileStage stage_{};
  unsigned phase_ = 0;
};

} // namespace quadrille_examples

#endif
