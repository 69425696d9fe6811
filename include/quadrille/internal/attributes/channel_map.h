#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_MAP_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_MAP_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/adapter/attributes.h>
#include <quadrille/internal/core/adapter/linear_light.h>
#include <quadrille/internal/core/adapter/no_channel_maps.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/attribute_values.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The values of a container as a property map over their indices.
template <class Values>
struct ValueMap {
  using key_type = std::size_t;
  using value_type = std::ranges::range_value_t<Values>;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Values* values;

  friend value_type get(const ValueMap& map, std::size_t i) { return (*map.values)[i]; }
  friend void put(const ValueMap& map, std::size_t i, const value_type& value) {
    (*map.values)[i] = value;
  }
};

template <class Source>
inline constexpr bool is_indexed = false;
template <class Values, class Triples>
inline constexpr bool is_indexed<IndexedValues<Values, Triples>> = true;

template <class Source>
struct MapOfSource {
  using type = Source;
  static const type& of(const Source& source) { return source; }
};
template <class Values, class Triples>
struct MapOfSource<IndexedValues<Values, Triples>> {
  using type = ValueMap<Values>;
  static type of(const IndexedValues<Values, Triples>& source) { return {source.values}; }
};

/// The attributes of a kind of channel, and the number of components, for the kinds in
/// <quadrille/channels.h>.
template <class Channel>
struct ChannelKind;

/// The values of a channel of the user's, read and written by key.
template <class Channel>
class ChannelMap {
public:
  using Source = typename Channel::Source;
  using Map = typename MapOfSource<Source>::type;
  using Key = typename boost::property_traits<Map>::key_type;
  using Value = typename boost::property_traits<Map>::value_type;
  static constexpr Attribute attribute = ChannelKind<Channel>::attribute;
  static constexpr std::size_t size = ChannelKind<Channel>::template components<Value>;
  static_assert(size < (std::numeric_limits<std::size_t>::max)(),
                "quadrille: the type of these values does not determine how many components they "
                "have: use std::array<double, n>, for example.");
  using Values = AttributeMap<Map, size, attribute>;

  explicit ChannelMap(const Channel& channel)
      : channel_(channel), values_(MapOfSource<Source>::of(channel.source)) {}

  const Source& source() const { return channel_.source; }

  /// With all but values and corners. Throws std::invalid_argument for options that do not go with
  /// the channel.
  ChannelInput input(Arena& arena) const {
    require_fit(channel_.options);
    return {channel_.options, size, attribute, arena};
  }

  void read(const Key& key, ChannelInput& input) const {
    const Vector<size> value = components(values_.raw(key));
    for (double component : value.coordinates) // not so much work as to insert all of them
      input.values.push_back(component);
  }
  /// Limits written values to the range of the values that faces had.
  void end_of_reading(ChannelInput& input, const Array<TriangleComplex::Triangle>& triangles) {
    input.require_finite();
    Vector<size> low, high;
    low.coordinates.fill((std::numeric_limits<double>::max)());
    high.coordinates.fill(std::numeric_limits<double>::lowest());
    for (const auto& value_triple : input.corners.empty() ? triangles : input.corners)
      for (Index value : value_triple)
        for (std::size_t c = 0; c < size; ++c) {
          const double component = input.values[value * size + c];
          low[c] = (std::min)(low[c], component);
          high[c] = (std::max)(high[c], component);
        }
    values_.limit_to(low, high);
    input.as_written = [map = *this](std::span<double> values, bool has_changed) {
      return map.bring_to_range(values, has_changed);
    };
  }

  /// Returns the new value of a wedge of a result, with its properties; nothing if it is the same.
  /// A value that a simplification has changed is clamped to the range of its type.
  template <class Result>
  std::optional<Value> changed(const Result& result, std::size_t channel, Index wedge,
                               const Value& old) const {
    Vector<size> value;
    for (std::size_t c = 0; c < size; ++c)
      value[c] = result.value(channel, wedge, c);
    if (components(old) == value)
      return std::nullopt;
    const bool is_new = result.origin(channel, wedge) == none;
    const std::optional<Vector<size>> inside = is_new ? in_range(value) : value;
    return inside ? with_components(old, *inside) : old;
  }

  Value raw(const Key& key) const { return values_.raw(key); }
  void put_raw(const Key& key, const Value& value) { values_.put_raw(key, value); }
  /// Writes a value so that undo() can put back what there was.
  void overwrite(const Key& key, const Value& value) {
    overwritten_.emplace_back(key, raw(key));
    put_raw(key, value);
  }
  void undo() {
    for (const auto& [key, value] : overwritten_)
      put_raw(key, value);
  }

private:
  static void require_fit(const ChannelOptions& options) {
    const auto require = [](bool fits, const std::string& what) {
      if (!fits)
        throw std::invalid_argument("quadrille::simplify: " + what);
    };
    require(options.weights.empty() || options.weights.size() == size,
            "a channel of " + std::to_string(size) + " components has " +
                std::to_string(options.weights.size()) + " weights");
    require(options.new_values != NewValues::existing || attribute != Attribute::texture,
            "NewValues::existing does not go with a Texture, which would tear");
    require(options.new_values != NewValues::recomputed || attribute == Attribute::normal,
            "NewValues::recomputed goes with Normals only");
    require(options.new_values != NewValues::weights || attribute == Attribute::any,
            "NewValues::weights goes with Attributes only");
    require(!options.linear_light || attribute == Attribute::color,
            "linear_light goes with Colors only");
  }

  /// The components of a value, in linear light if that is asked for.
  Vector<size> components(const Value& value) const {
    Vector<size> components = Values::components(value);
    if (channel_.options.linear_light)
      for (std::size_t c = 0; c < size; ++c)
        components[c] = c < 3 ? light_of_srgb(components[c] / whole) : components[c] / whole;
    return components;
  }
  /// A value with components, in linear light if that is asked for, and what else the old one has.
  Value with_components(const Value& old, const Vector<size>& components) const {
    return Values::value(old, of_user(components));
  }
  /// From linear light, if that was asked for.
  Vector<size> of_user(Vector<size> components) const {
    if (channel_.options.linear_light)
      for (std::size_t c = 0; c < size; ++c)
        components[c] = whole * (c < 3 ? srgb_of_light(components[c]) : components[c]);
    return components;
  }
  // See ChannelInput::as_written.
  bool bring_to_range(std::span<double> values, bool has_changed) const {
    Vector<size> value;
    std::copy(values.begin(), values.end(), value.coordinates.begin());
    const std::optional<Vector<size>> inside = has_changed ? in_range(value) : value;
    if (inside) {
      const Vector<size> written = of_user(*inside);
      std::copy(written.coordinates.begin(), written.coordinates.end(), values.begin());
    }
    return inside.has_value();
  }

  std::optional<Vector<size>> in_range(const Vector<size>& value) const {
    return channel_.options.new_values == NewValues::weights ? as_weights(value)
                                                             : values_.in_range(value);
  }
  static std::optional<Vector<size>> as_weights(Vector<size> value) {
    double sum = 0;
    for (double& weight : value.coordinates)
      sum += weight = (std::max)(weight, 0.0);
    if (!(sum > 0))
      return std::nullopt;
    return (1 / sum) * value;
  }

  using Component = ComponentOf<Value>;
  /// The integer value that represents 1 in linear light.
  static constexpr double whole = [] {
    if constexpr (std::integral<Component>)
      return static_cast<double>((std::numeric_limits<Component>::max)());
    else
      return 1;
  }();

  Channel channel_;
  Values values_;
  std::vector<std::pair<Key, Value>> overwritten_;
};

/// Calls visit(map, c) for each of a tuple.
template <class Maps, class Visit>
void for_each_channel(Maps& maps, Visit visit) {
  std::size_t c = 0;
  std::apply([&](auto&... map) { (visit(map, c++), ...); }, maps);
}
/// Puts back what has been overwritten in each.
template <class Maps>
void undo_channels(Maps& maps) {
  for_each_channel(maps, [](auto& map, std::size_t) { map.undo(); });
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_CHANNEL_MAP_H
