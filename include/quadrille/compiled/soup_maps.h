#ifndef QUADRILLE_COMPILED_SOUP_MAPS_H
#define QUADRILLE_COMPILED_SOUP_MAPS_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// \file
/// What the options say of points and triangles, as property maps.

namespace quadrille::internal {

/// Which points are fixed.
struct FixedPoints {
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<bool>* is_fixed;

  friend bool get(const FixedPoints& map, std::size_t i) {
    return !map.is_fixed->empty() && (*map.is_fixed)[i];
  }
};

/// How far points may move.
struct PointTolerances {
  using key_type = std::size_t;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const std::vector<double>* tolerance;

  bool is_limited() const { return !tolerance->empty(); }
  friend double get(const PointTolerances& map, std::size_t i) { return (*map.tolerance)[i]; }
};

/// How important points are.
struct PointImportances {
  using key_type = std::size_t;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const std::vector<double>* of;

  bool is_empty() const { return of->empty(); }
  friend double get(const PointImportances& map, std::size_t i) { return (*map.of)[i]; }
};

/// Which points are shared.
struct SharedPoints {
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<bool>* is_shared;

  bool shares_none() const { return is_shared->empty(); }
  friend bool get(const SharedPoints& map, std::size_t i) { return (*map.is_shared)[i]; }
};

/// Which triangles are selected.
struct SelectedTriangles {
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<bool>* is_selected;

  bool selects_all() const { return is_selected->empty(); }
  friend bool get(const SelectedTriangles& map, std::size_t i) { return (*map.is_selected)[i]; }
};

/// What became of each point.
struct PointImages {
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;
  std::vector<std::size_t>* image;

  friend void put(const PointImages& map, std::size_t i, std::size_t of_it) {
    (*map.image)[i] = of_it;
  }
};

/// The labels of triangles. What becomes of them is told by the triangles.
struct SoupLabelMap {
  using key_type = std::size_t;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;
  using category = boost::read_write_property_map_tag;
  std::span<const std::uint32_t> labels;

  friend std::uint32_t get(const SoupLabelMap& map, std::size_t i) {
    return map.labels.empty() ? 0 : map.labels[i];
  }
  friend void put(const SoupLabelMap&, std::size_t, std::uint32_t) {}
};

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_MAPS_H
