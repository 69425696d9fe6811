#ifndef QUADRILLE_C_CALL_H
#define QUADRILLE_C_CALL_H

#include <quadrille/c/arrays.h>
#include <quadrille/c/functions.h>
#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_job.h>
#include <quadrille/level_maps.h>
#include <quadrille/levels.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// The handles of the interface of C.

/// Levels with the comment of their file.
struct quadrille_levels {
  quadrille::Levels levels;
  std::string error, comment;
};

/// A level with its surface.
struct quadrille_level {
  quadrille::Level level;
};

/// A channel of a call.
struct quadrille_call_channel {
  quadrille::SoupChannelView::Kind kind;
  quadrille::internal::NamedArray values, corners;
  quadrille::ChannelOptions options;
};

struct quadrille_call {
  quadrille::internal::NamedArray points, triangles, labels;
  std::vector<quadrille_call_channel> channels;
  quadrille::internal::SoupJob job;
  quadrille_levels* levels = nullptr;

  quadrille::internal::CallersFunction<quadrille_progress_function> progress;
  quadrille::internal::CallersFunction<quadrille_stop_function> stop;
  quadrille::internal::CallersFunction<quadrille_filter_function> filter;
  quadrille::internal::CallersFunction<quadrille_cost_function> cost;
  std::atomic<bool> is_cancelled = false;

  quadrille::SoupResult result;
  std::vector<std::int64_t> vertex_map; ///< the vertex map of the result
  std::string report, report_text, error;
  quadrille::SparseRows old_to_new, new_to_old; ///< if the call has the option maps

  /// Returns a channel. Throws std::out_of_range if there is none.
  quadrille_call_channel& channel(std::size_t index) {
    if (index >= channels.size())
      throw std::out_of_range("the channel is " + std::to_string(index) + ", but there are " +
                              std::to_string(channels.size()) + ", numbered from 0");
    return channels[index];
  }
};

namespace quadrille::internal {

using SimplifyJob = std::function<SoupResult(const SoupView&, const SoupJob&)>;

/// Sets the sparse maps of a call from its levels.
void set_maps(quadrille_call& call, const SoupView& soup, const Levels& levels);

/// Runs a call by a function, and keeps its result. Returns the code of what it throws.
std::int32_t run_call(quadrille_call& call, const SimplifyJob& simplify);

} // namespace quadrille::internal

#endif // QUADRILLE_C_CALL_H
