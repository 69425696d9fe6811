#ifndef QUADRILLE_EXAMPLES_WEB_CALL_H
#define QUADRILLE_EXAMPLES_WEB_CALL_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/presets.h>
#include <quadrille/levels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// A channel that a call owns.
struct CallChannel {
  quadrille::SoupChannelView::Kind kind;
  std::size_t components;
  std::vector<double> values;
  quadrille::SoupTriangles triangles;
  quadrille::ChannelOptions options;
};

/// An array of a call as JavaScript looks at it: where it begins, and how many numbers it has.
struct ArrayView {
  const void* begin = nullptr;
  std::uint32_t count = 0;
};

/// What one simplification takes and gives. All arrays that JavaScript fills or reads belong to
/// it, so that deleting it frees everything, whatever has happened.
struct Call {
  quadrille::SoupPoints positions;
  quadrille::SoupTriangles indices;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint8_t> fixed, selected; // a value for each, until the call runs
  std::deque<CallChannel> channels;
  quadrille::SoupOptions options;
  quadrille::SoupResult result;
  std::string text; // what was wrong, or the report
  ArrayView view;   // the array that was asked for last

  /// Simplifies. If there are levels, they are recorded.
  void run(quadrille::Levels* levels) {
    quadrille::SoupView soup{positions, indices, labels, {}};
    for (const CallChannel& channel : channels)
      soup.channels.push_back(
          {channel.kind, channel.components, channel.values, channel.triangles, channel.options});
    options.fixed.assign(fixed.begin(), fixed.end());
    options.selected.assign(selected.begin(), selected.end());
    if (levels) {
      options = quadrille::internal::options_of_levels(options, soup);
      options.recorder = quadrille::record_into(*levels);
    }
    result = quadrille::simplified_soup(soup, options);
    result.prepared = {};
  }

  /// Does what may throw, and tells whether it has not; else `text` says what was wrong.
  template <class Task>
  bool succeeds(Task task) {
    try {
      task();
      return true;
    } catch (const std::bad_alloc&) {
      text = "quadrille: out of memory";
    } catch (const std::length_error&) { // more than there are addresses
      text = "quadrille: out of memory";
    } catch (const std::exception& error) {
      text = error.what();
    }
    return false;
  }
};

/// A view of the numbers of a vector, of rows of them too.
template <class T>
ArrayView view_of(const std::vector<T>& numbers) {
  return {numbers.data(), static_cast<std::uint32_t>(numbers.size())};
}
template <class T, std::size_t n>
ArrayView view_of(const std::vector<std::array<T, n>>& rows) {
  return {rows.data(), static_cast<std::uint32_t>(n * rows.size())};
}

/// Makes room for so many numbers, and says where.
template <class T>
void* room_in(std::vector<T>& numbers, std::size_t count) {
  numbers.resize(count);
  return numbers.data();
}
template <class T, std::size_t n>
void* room_in(std::vector<std::array<T, n>>& rows, std::size_t count) {
  rows.resize(count / n);
  return rows.data();
}

/// Room for an array of the input by its name; null if there is no such array.
inline void* room_for_input(Call& call, std::string_view name, std::size_t count) {
  if (name == "positions")
    return room_in(call.positions, count);
  if (name == "indices")
    return room_in(call.indices, count);
  if (name == "labels")
    return room_in(call.labels, count);
  if (name == "fixed")
    return room_in(call.fixed, count);
  if (name == "selected")
    return room_in(call.selected, count);
  if (name == "importance")
    return room_in(call.options.importance, count);
  if (name == "tolerance")
    return room_in(call.options.tolerance, count);
  return nullptr;
}

/// An array of a SoupResult or a Level by its name; channels are "values" and "corners".
template <class Channels>
ArrayView view_of_channel(const Channels& channels, std::string_view name, std::size_t channel) {
  if (channel >= channels.size())
    return {};
  return name == "values" ? view_of(channels[channel].values)
                          : view_of(channels[channel].triangles);
}
inline ArrayView view_of_output(const quadrille::SoupResult& result, std::string_view name,
                                std::size_t channel) {
  if (name == "positions")
    return view_of(result.points);
  if (name == "indices")
    return view_of(result.triangles);
  if (name == "labels")
    return view_of(result.labels);
  if (name == "inputFaces")
    return view_of(result.input_faces);
  if (name == "vertex_map")
    return view_of(result.vertex_map);
  return view_of_channel(result.channels, name, channel);
}
inline ArrayView view_of_output(const quadrille::Level& level, std::string_view name,
                                std::size_t channel) {
  if (name == "positions")
    return view_of(level.points);
  if (name == "indices")
    return view_of(level.triangles);
  if (name == "inputVertices")
    return view_of(level.input_vertices);
  if (name == "inputFaces")
    return view_of(level.input_faces);
  return view_of_channel(level.channels, name, channel);
}

} // namespace quadrille_examples

#endif
