#ifndef QUADRILLE_COMPILED_SOUP_MAPS_H
#define QUADRILLE_COMPILED_SOUP_MAPS_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// \file
/// Options of points and triangles as property maps.

namespace quadrille::internal {

/// A value for each point or triangle.
template <class Value>
struct SoupValues {
  using key_type = std::size_t;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  const std::vector<Value>* values;

  friend Value get(const SoupValues& map, std::size_t i) { return (*map.values)[i]; }
};

/// Returns the values as a map, or none if there are no values.
template <class Value>
std::optional<SoupValues<Value>> values_if_given(const std::vector<Value>& values) {
  if (values.empty())
    return std::nullopt;
  return SoupValues<Value>{&values};
}

/// The map from each point to the point that it has become.
struct PointMap {
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;
  std::vector<std::size_t>* vertex_map;

  friend void put(const PointMap& map, std::size_t i, std::size_t of_it) {
    (*map.vertex_map)[i] = of_it;
  }
};

/// The labels of triangles. The result gets them through the triangles' input indices.
struct SoupLabelMap {
  using key_type = std::size_t;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::read_write_property_map_tag;
  std::span<const std::uint32_t> labels;

  friend std::uint32_t get(const SoupLabelMap& map, std::size_t i) { return map.labels[i]; }
  friend void put(const SoupLabelMap&, std::size_t, std::uint32_t) {}
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_MAPS_H
