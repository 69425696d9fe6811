#ifndef QUADRILLE_C_FUNCTIONS_H
#define QUADRILLE_C_FUNCTIONS_H

#include <quadrille/c/failures.h>
#include <quadrille/compiled/soup_job.h>
#include <quadrille/quadrille.h>
#include <quadrille/report.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// \file
/// Functions of the caller as functions of the library.

namespace quadrille::internal {

/// A function of the caller with its data.
template <class Function>
struct CallersFunction {
  Function function = nullptr;
  void* data = nullptr;

  explicit operator bool() const { return function != nullptr; }
};

/// Asks a function that answers yes or no. Throws FunctionFailed if it does neither.
template <class Function, class View>
bool answer_of(const CallersFunction<Function>& asked, const char* name, const View& view) {
  const std::int32_t answer = asked.function(asked.data, &view);
  if (answer < 0)
    throw FunctionFailed(name);
  return answer != 0;
}

inline quadrille_status view_of(const Status& status) {
  return {status.initial_faces, status.initial_vertices, status.faces,
          status.vertices,      status.contractions,     status.next_error,
          status.diagonal,      status.progress,         static_cast<std::int32_t>(status.stage)};
}

inline quadrille_contraction view_of(const SoupContraction& contraction) {
  static_assert(sizeof(SoupContraction::Face) == sizeof(quadrille_changed_face) &&
                offsetof(SoupContraction::Face, third) == offsetof(quadrille_changed_face, third));
  const auto& [x, y, z] = contraction.target;
  return {contraction.first,
          contraction.second,
          {x, y, z},
          reinterpret_cast<const quadrille_changed_face*>(contraction.faces.data()),
          contraction.faces.size(),
          contraction.removed_faces.data(),
          contraction.removed_faces.size(),
          contraction.highest_degree};
}

/// The progress of a call: asks a function up to 25 times a second, and at the end.
class CallProgress {
public:
  CallProgress(const CallersFunction<quadrille_progress_function>& asked,
               const std::atomic<bool>& is_cancelled)
      : asked_(asked), is_cancelled_(is_cancelled) {}

  bool operator()(const Status& status) {
    if (is_cancelled_)
      return false;
    const auto now = std::chrono::steady_clock::now();
    if (!asked_ || (now - last_ < std::chrono::milliseconds(40) && status.progress < 1))
      return true;
    last_ = now;
    return answer_of(asked_, "progress", view_of(status));
  }

private:
  const CallersFunction<quadrille_progress_function>& asked_;
  const std::atomic<bool>& is_cancelled_;
  std::chrono::steady_clock::time_point last_{}; // long ago
};

/// Returns the cost that a function answers. Throws FunctionFailed if it is none.
inline double cost_of(const CallersFunction<quadrille_cost_function>& asked, const SoupPair& pair) {
  static_assert(sizeof(SoupPair) == sizeof(quadrille_pair) &&
                offsetof(SoupPair, quadric) == offsetof(quadrille_pair, quadric));
  const auto view = std::bit_cast<quadrille_pair>(pair);
  const double cost = asked.function(asked.data, &view);
  if (!(cost >= 0) || !std::isfinite(cost))
    throw FunctionFailed("cost");
  return cost;
}

} // namespace quadrille::internal

#endif // QUADRILLE_C_FUNCTIONS_H
