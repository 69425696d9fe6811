#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_SOUP_CHANNELS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_SOUP_CHANNELS_H

#include <quadrille/internal/attributes/channel_map.h>
#include <quadrille/internal/core/adapter/soup_base.h>
#include <quadrille/internal/core/adapter/split_points.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Reads the index triples of a channel that has `values` values. Throws std::invalid_argument if
/// they are not one for each triangle, or name a value that is not there.
template <class Triples>
void read_triples(const Triples& triples, std::size_t triangles, std::size_t values,
                  ChannelInput& input) {
  if (std::ranges::size(triples) != triangles)
    throw std::invalid_argument("quadrille::simplify: a channel has index triples for " +
                                std::to_string(std::ranges::size(triples)) + " triangles of " +
                                std::to_string(triangles));
  for (const auto& triple : triples)
    input.corners.push_back(read_indices(triple, input.corners.size(), values,
                                         {"quadrille::simplify", "value", " of a channel"}, [&] {
                                           return " has " +
                                                  std::to_string(std::ranges::size(triple)) +
                                                  " indices of a channel, not 3";
                                         }));
}

/// A wedge of a channel that is left, by the first value of its corners; wedges of equal values
/// share one.
struct WedgeUse {
  Index old;
  std::vector<double> wedge_value; ///< empty: as it was
  Index wedge;
  bool is_as(const WedgeUse& other) const {
    return old == other.old && wedge_value == other.wedge_value;
  }
  friend bool operator<(const WedgeUse& a, const WedgeUse& b) {
    return std::tie(a.old, a.wedge_value, a.wedge) < std::tie(b.old, b.wedge_value, b.wedge);
  }
};

/// A channel of a result, and how many components it has.
struct ChannelNumber {
  std::size_t number, components;
};

/// The wedges that are left of a channel whose corners name values, in the order in which these are
/// written. `faces` are numbers of the result, and `triples` those of the input.
template <class Result, class Triples>
std::vector<WedgeUse> uses_of(const Result& result, const Array<Index>& faces, ChannelNumber c,
                              const Triples& triples) {
  const Array<Index> input_faces = result.input_faces();
  std::vector<Index> old(result.wedge_count(c.number), none);
  for (Index face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto index = static_cast<Index>(triples[input_faces[face]][i]);
      Index& first = old[result.wedge(c.number, face, i)];
      first = (std::min)(first, index);
    }
  std::vector<WedgeUse> uses;
  for (Index wedge = 0; wedge < old.size(); ++wedge) {
    if (old[wedge] == none)
      continue;
    const Index origin = result.origin(c.number, wedge);
    WedgeUse use{origin == none ? old[wedge] : origin, {}, wedge};
    for (std::size_t k = 0; k < c.components && origin == none; ++k)
      use.wedge_value.push_back(result.value(c.number, wedge, k));
    uses.push_back(std::move(use));
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// Writes the new index triples of a channel; add(use) is called for each value that is written.
/// The remaining values keep their order; a changed value is placed where its first wedge met it:
/// after the old values that come before.
template <class Result, class Old, class Left, class Add>
void rewrite_triples(const Result& result, const Array<Index>& faces, ChannelNumber c,
                     const Old& old, Left& left, Add add) {
  const std::vector<WedgeUse> uses = uses_of(result, faces, c, old);
  std::vector<Index> place(result.wedge_count(c.number), none);
  Index values = 0;
  const WedgeUse* last = nullptr;
  for (const WedgeUse& use : uses) {
    if (!last || !use.is_as(*last)) {
      add(use);
      ++values;
    }
    place[use.wedge] = values - 1;
    last = &use;
  }
  const Array<Index> input_faces = result.input_faces();
  for (Index face : faces)
    left.push_back(renumbered(old[input_faces[face]],
                              [&](auto i) { return place[result.wedge(c.number, face, i)]; }));
}

/// The channels of a soup: in maps over the indices of its points, or values with an index triple
/// for each triangle; where there is neither value nor triple, there is no channel.
template <class Maps>
class SoupChannels {
public:
  explicit SoupChannels(Maps maps) : maps_(std::move(maps)) {}

  /// `of_points`: the points of each triangle. Throws std::invalid_argument for index triples that
  /// are not one for each triangle, or name a value that is not there.
  void read(std::size_t points, const Array<TriangleComplex::Triangle>& of_points, Arena& arena,
            InputWithChannels& surface) {
    const std::size_t triangles = of_points.size();
    for_each_channel(maps_, [&](auto& map, std::size_t c) {
      numbers_[c] = surface.channels.size();
      ChannelInput input = map.input(arena);
      if constexpr (is_indexed<SourceOf<decltype(map)>>) {
        if (std::ranges::size(*map.source().values) == 0 &&
            std::ranges::size(*map.source().triples) == 0)
          return;
        read_indexed(map, triangles, input);
      } else {
        input.values.reserve(points * input.components);
        for (std::size_t i = 0; i < points; ++i)
          map.read(i, input);
      }
      map.end_of_reading(input, of_points);
      surface.channels.push_back(std::move(input));
    });
  }

  /// Builds what values and triples become. `faces` are numbers of the result, in the order in
  /// which they are written.
  template <class Result>
  auto rewritten(const Result& result, const Array<Index>& faces) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::make_tuple(this->rewritten(result, faces, numbers_[I], std::get<I>(maps_))...);
    }
    (Indices());
  }
  /// Puts that in place, which does not throw.
  template <class Rewritten>
  void swap(Rewritten& rewritten) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (this->swap(std::get<I>(maps_), std::get<I>(rewritten)), ...);
    }
    (Indices());
  }

  /// The values that points will have, of each channel that is a map over them. `vertices` are
  /// numbers of the result, in the order in which they are written, and `inputs` the points that
  /// they were.
  template <class Result>
  auto values(const Result& result, const Array<Index>& vertices,
              const Array<Index>& inputs) const {
    return values_of_all(
        result, vertices.size(), [&](std::size_t i) { return inputs[vertices[i]]; },
        [&](std::size_t, std::size_t i) { return result.first_wedge(vertices[i]); });
  }
  /// This overload is for points that are split.
  template <class Result>
  auto values(const Result& result, const SplitPoints& points) const {
    return values_of_all(
        result, points.size(), [&](std::size_t i) { return points.origin(i); },
        [&](std::size_t c, std::size_t i) {
          return result.wedge(c, points.face(i), points.corner(i));
        });
  }
  /// Writes them to the maps. If anything throws, undo() puts back what there was.
  template <class Values>
  void write(const Values& values) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (this->write(std::get<I>(maps_), std::get<I>(values)), ...);
    }
    (Indices());
  }
  /// Which channels are maps over points.
  std::vector<std::size_t> of_points() {
    std::vector<std::size_t> channels;
    for_each_channel(maps_, [&](auto& map, std::size_t c) {
      if constexpr (!is_indexed<SourceOf<decltype(map)>>)
        channels.push_back(numbers_[c]);
    });
    return channels;
  }
  void undo() { undo_channels(maps_); }

private:
  using Indices = std::make_index_sequence<std::tuple_size_v<Maps>>;

  template <class Map>
  using SourceOf = typename std::remove_cvref_t<Map>::Source;

  template <class Map>
  static void read_indexed(const Map& map, std::size_t triangles, ChannelInput& input) {
    const auto& triples = *map.source().triples;
    const std::size_t count = std::ranges::size(*map.source().values);
    input.values.reserve(count * input.components);
    input.corners.reserve(triangles);
    for (std::size_t i = 0; i < count; ++i)
      map.read(i, input);
    read_triples(triples, triangles, count, input);
  }

  struct Nothing {};

  template <class Result, class Origin, class Wedge>
  auto values_of_all(const Result& result, std::size_t count, Origin origin, Wedge wedge) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::make_tuple(
          values_of(std::get<I>(maps_), numbers_[I], result, count, origin, wedge)...);
    }
    (Indices());
  }
  template <class Map, class Result, class Origin, class Wedge>
  static auto values_of([[maybe_unused]] const Map& map, [[maybe_unused]] std::size_t c,
                        const Result& result, std::size_t count, Origin origin, Wedge wedge) {
    if constexpr (is_indexed<typename Map::Source>) {
      return Nothing{};
    } else {
      std::vector<typename Map::Value> values;
      values.reserve(count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto old = map.raw(std::size_t{origin(i)});
        values.push_back(map.changed(result, c, wedge(c, i), old).value_or(old));
      }
      return values;
    }
  }
  template <class Map, class Values>
  static void write([[maybe_unused]] Map& map, [[maybe_unused]] const Values& values) {
    if constexpr (!is_indexed<typename Map::Source>)
      for (std::size_t i = 0; i < values.size(); ++i)
        map.overwrite(i, values[i]);
  }

  template <class Result, class Map>
  static auto rewritten(const Result& result, const Array<Index>& faces, std::size_t c,
                        const Map& map) {
    if constexpr (is_indexed<typename Map::Source>)
      return rewritten_triples(result, faces, c, map);
    else
      return Nothing{};
  }

  template <class Result, class Map>
  static auto rewritten_triples(const Result& result, const Array<Index>& faces, std::size_t c,
                                const Map& map) {
    using Values = std::remove_cvref_t<decltype(*map.source().values)>;
    using Triples = std::remove_cvref_t<decltype(*map.source().triples)>;
    std::pair<Values, Triples> left{empty_like(*map.source().values),
                                    empty_like(*map.source().triples)};
    if (std::ranges::size(*map.source().triples) == 0)
      return left;
    rewrite_triples(
        result, faces, {c, Map::size}, *map.source().triples, left.second,
        [&](const WedgeUse& use) { left.first.push_back(left_of(map, result, c, use)); });
    return left;
  }

  template <class Map, class Result>
  static auto left_of(const Map& map, const Result& result, std::size_t c, const WedgeUse& use) {
    const auto old = map.raw(std::size_t{use.old});
    return map.changed(result, c, use.wedge, old).value_or(old);
  }

  template <class Map>
  static void swap(Map& map, auto& rewritten) {
    if constexpr (is_indexed<typename Map::Source>) {
      std::swap(*map.source().values, rewritten.first);
      std::swap(*map.source().triples, rewritten.second);
    }
  }

  Maps maps_;
  std::array<std::size_t, std::tuple_size_v<Maps>> numbers_ = {}; // among those that there are
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_SOUP_CHANNELS_H
