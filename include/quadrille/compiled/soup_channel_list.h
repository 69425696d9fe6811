#ifndef QUADRILLE_COMPILED_SOUP_CHANNEL_LIST_H
#define QUADRILLE_COMPILED_SOUP_CHANNEL_LIST_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_channel_map.h>
#include <quadrille/internal/attributes/soup_channels.h>
#include <quadrille/internal/core/adapter/split_points.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/memory/array.h>

#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

/// \file
/// Channels whose number, kinds and components are chosen at run time, as one argument of
/// `simplify`, so that one engine is compiled for all of them.

namespace quadrille::internal {

/// The argument: the channels, and the destination of the results.
struct SoupChannelList {
  std::span<const SoupChannelView> channels;
  std::vector<SoupChannel>* results;

  void validate() const {
    for (const SoupChannelView& channel : channels)
      channel.options.validate();
  }
};
template <>
inline constexpr bool is_channel<SoupChannelList> = true;

struct SoupChannelMaps {
  std::vector<SoupChannelMap> maps;
  std::vector<SoupChannel>* results;
};
inline SoupChannelMaps channel_maps(const std::tuple<SoupChannelList>& channels) {
  const auto& [list] = channels;
  SoupChannelMaps result{{}, list.results};
  for (const SoupChannelView& channel : list.channels)
    result.maps.emplace_back(channel);
  return result;
}

/// SoupChannels documents its counterpart for other maps.
template <>
class SoupChannels<SoupChannelMaps> {
public:
  explicit SoupChannels(SoupChannelMaps maps)
      : maps_(std::move(maps.maps)), results_(maps.results) {}

  void read(std::size_t /*points*/, const Array<TriangleComplex::Triangle>& of_points, Arena& arena,
            InputWithChannels& surface) {
    for (SoupChannelMap& map : maps_) {
      ChannelInput input = map.input(arena);
      if (map.is_indexed())
        read_triples(map.channel().triangles, of_points.size(), map.value_count(), input);
      map.end_of_reading(input, of_points);
      surface.channels.push_back(std::move(input));
    }
  }

  /// Returns the channels with index triples; the others are still empty.
  template <class Result>
  std::vector<SoupChannel> rewritten(const Result& result, const Array<Index>& faces) const {
    std::vector<SoupChannel> left(maps_.size());
    for (std::size_t c = 0; c < maps_.size(); ++c) {
      left[c].components = maps_[c].channel().components;
      if (maps_[c].is_indexed())
        rewrite_triples(
            result, faces, {c, left[c].components}, maps_[c].channel().triangles, left[c].triangles,
            [&](const WedgeUse& use) { append(result, c, use.wedge, use.old, left[c].values); });
    }
    return left;
  }

  /// Returns the new values at points, for each channel over points.
  template <class Result>
  std::vector<std::vector<double>> values(const Result& result, const Array<Index>& vertices,
                                          const Array<Index>& inputs) const {
    std::vector<std::vector<double>> values(maps_.size());
    for_each_of_points([&](std::size_t c) {
      for (Index vertex : vertices)
        append(result, c, result.first_wedge(vertex), inputs[vertex], values[c]);
    });
    return values;
  }
  template <class Result>
  std::vector<std::vector<double>> values(const Result& result, const SplitPoints& points) const {
    std::vector<std::vector<double>> values(maps_.size());
    for_each_of_points([&](std::size_t c) {
      for (std::size_t i = 0; i < points.size(); ++i)
        append(result, c, result.wedge(c, points.face(i), points.corner(i)), points.origin(i),
               values[c]);
    });
    return values;
  }
  void write(const std::vector<std::vector<double>>& values) { written_ = values; }
  std::vector<std::size_t> of_points() const {
    std::vector<std::size_t> channels;
    for_each_of_points([&](std::size_t c) { channels.push_back(c); });
    return channels;
  }

  void swap(std::vector<SoupChannel>& rewritten) {
    for_each_of_points([&](std::size_t c) { rewritten[c].values = std::move(written_[c]); });
    results_->swap(rewritten);
  }
  void undo() {} // the caller's arrays have not been changed

private:
  template <class Visit>
  void for_each_of_points(Visit visit) const {
    for (std::size_t c = 0; c < maps_.size(); ++c)
      if (!maps_[c].is_indexed())
        visit(c);
  }

  template <class Result>
  void append(const Result& result, std::size_t c, Index wedge, Index old,
              std::vector<double>& values) const {
    std::vector<double> components(maps_[c].channel().components);
    for (std::size_t k = 0; k < components.size(); ++k)
      components[k] = result.value(c, wedge, k);
    maps_[c].append(components, result.origin(c, wedge) == none, old, values);
  }

  std::vector<SoupChannelMap> maps_;
  std::vector<SoupChannel>* results_;
  std::vector<std::vector<double>> written_; // for channels over points
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_CHANNEL_LIST_H
