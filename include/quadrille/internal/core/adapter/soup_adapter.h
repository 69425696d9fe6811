#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ADAPTER_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ADAPTER_H

#include <quadrille/internal/core/adapter/attributes.h>
#include <quadrille/internal/core/adapter/no_channel_maps.h>
#include <quadrille/internal/core/adapter/soup_base.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/parameters.h>
#include <quadrille/quadric_form.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Reads a polygon soup of triangles into flat arrays and rewrites it from the result, in linear
/// time. Points and triangles that are left keep their order.
template <class Points, class Triangles, class PointMap, class Attributes, class Labels, class Maps>
class SoupAdapter {
public:
  static constexpr std::size_t dimension = 3 + Attributes::size;
  using Input = InputOf<dimension, has_channels_in<Maps>>;
  using Point = typename boost::property_traits<PointMap>::value_type;

  SoupAdapter(Points& points, Triangles& triangles, PointMap map, Attributes attributes,
              Labels labels, Maps channels, Arena& arena)
      : arena_(&arena), points_(points), triangles_(triangles), map_(map), attributes_(attributes),
        labels_(labels), channels_(std::move(channels)) {}

  /// Throws std::invalid_argument for a face that is not a triangle or names a point that is not
  /// there, and for a point that is not finite.
  Input read() {
    TriangleComplex::check_size(std::ranges::size(points_), std::ranges::size(triangles_));
    Input surface(arena_);
    surface.has_duplicate_faces = surface.may_have_reverse_faces = true;
    surface.reserve(std::ranges::size(points_), std::ranges::size(triangles_));
    for (std::size_t v = 0; v < std::ranges::size(points_); ++v) {
      surface.positions.push_back(read_position(v));
      require_finite(surface.positions.back(), v);
    }
    for (std::size_t face = 0; face < std::ranges::size(triangles_); ++face)
      surface.triangles.push_back(
          read_triangle("quadrille::simplify", triangles_[face], face, surface.positions.size()));
    if constexpr (Attributes::size > 0)
      attributes_.limit(surface);
    if constexpr (has_channels_in<Maps>)
      channels_.read(std::ranges::size(points_), surface.triangles, *arena_, surface);
    return surface;
  }

  /// Calls visit(v, value, i) for the value that a map has of the i-th vertex of the user's, which
  /// is the vertex v of the surface.
  template <class Map, class Visit>
  void for_each_value(Map map, Visit visit) const {
    for (Index v = 0; v < std::ranges::size(points_); ++v)
      visit(v, get(map, static_cast<std::size_t>(v)), v);
  }

  /// The input index of a point.
  Index vertex_of(std::size_t point) const { return static_cast<Index>(point); }

  /// Rewrites points, triangles and attributes. The new points and triangles are built apart;
  /// attributes, and points that the map stores elsewhere, are restored if anything throws, so the
  /// soup stays as it was. It calls `reporter` as described for Reporter.
  template <class Result, class AnyReporter>
  std::size_t write(const Result& result, AnyReporter reporter) {
    auto points = empty_like(points_);
    const Array<Index> inputs = result.input_vertices();
    const Array<Index> vertices = in_order(inputs, result.input_vertex_count());
    const Array<Index> new_index = places(vertices, vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      reporter.vertex(i, vertices[i], result);
      points.push_back(points_[inputs[vertices[i]]]);
    }
    if constexpr (AnyReporter::asks_for_vertex_map)
      report_vertex_map(result, places(inputs, result.input_vertex_count()), new_index, reporter);
    auto triangles = empty_like(triangles_);
    const Array<Index> input_faces = result.input_faces();
    const Array<Index> faces = ordered_faces(result, input_faces, reporter);
    for (Index face : faces)
      triangles.push_back(renumbered(
          triangles_[input_faces[face]],
          [&, corners = result.corners(face)](std::size_t i) { return new_index[corners[i]]; }));
    auto channels = channels_.rewritten(result, faces);
    const auto values = channels_.values(result, vertices, inputs);
    const auto attributes = attributes_left(result, vertices, inputs);
    Undo undo;
    try {
      move_points(result, vertices, points, undo);
      put_in_place(
          points_, points, [&](std::size_t i) { return inputs[vertices[i]]; }, triangles_,
          triangles,
          [&] {
            write_attributes(attributes, undo);
            labels_.write(faces, input_faces);
            channels_.write(values);
          },
          [&] { undo.values(*this); });
    } catch (...) {
      undo.positions(*this, points);
      throw;
    }
    channels_.swap(channels);
    return 0;
  }

private:
  // The overwritten data of each new point.
  struct Undo {
    std::vector<std::pair<std::size_t, Point>> points; // of those that have moved
    std::vector<AttributeValue<Attributes>> attributes;

    template <class NewPoints>
    void positions(SoupAdapter& adapter, NewPoints& new_points) const {
      for (const auto& [i, p] : points)
        put(adapter.map_, new_points[i], p);
    }
    void values(SoupAdapter& adapter) const {
      if constexpr (Attributes::size > 0)
        for (std::size_t i = 0; i < attributes.size(); ++i)
          adapter.attributes_.put_raw(i, attributes[i]);
      adapter.labels_.undo();
      adapter.channels_.undo();
    }
  };

  // `numbers` are those of the result, by inputs.
  template <class Result, class AnyReporter>
  static void report_vertex_map(const Result& result, const Array<Index>& numbers,
                                const Array<Index>& new_index, AnyReporter& reporter) {
    for (Index input = 0; input < numbers.size(); ++input) {
      const Index number = numbers[result.merged_vertex(input)];
      reporter.map_vertex(std::size_t{input},
                          number == none ? parameters::vanished : std::size_t{new_index[number]});
    }
  }

  Vector<dimension> read_position(std::size_t v) {
    const Vector<3> position = position_of(get(map_, points_[v]));
    if constexpr (Attributes::size > 0)
      return join(position, attributes_.read(v));
    else
      return position;
  }

  template <class Result, class NewPoints>
  void move_points(const Result& result, const Array<Index>& vertices, NewPoints& points,
                   Undo& undo) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (result.is_moved(vertices[i])) {
        undo.points.emplace_back(i, get(map_, points[i]));
        put(map_, points[i], point_at<Point>(space(result.position(vertices[i]))));
      }
  }

  // The attributes of the new points.
  template <class Result>
  auto attributes_left(const Result& result, const Array<Index>& vertices,
                       const Array<Index>& inputs) const {
    std::vector<AttributeValue<Attributes>> left;
    if constexpr (Attributes::size > 0)
      for (Index v : vertices) {
        const auto old = attributes_.raw(std::size_t{inputs[v]});
        left.push_back(
            result.is_moved(v) ? attributes_.changed(old, attributes_of(result.position(v))) : old);
      }
    return left;
  }
  void write_attributes(const std::vector<AttributeValue<Attributes>>& attributes, Undo& undo) {
    if constexpr (Attributes::size > 0)
      for (std::size_t i = 0; i < attributes.size(); ++i) {
        undo.attributes.push_back(attributes_.raw(i));
        attributes_.put_raw(i, attributes[i]);
      }
  }

  Arena* arena_;
  Points& points_;
  Triangles& triangles_;
  PointMap map_;
  QUADRILLE_NO_UNIQUE_ADDRESS Attributes attributes_;
  SoupLabels<Labels> labels_;
  SoupChannels<Maps> channels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_ADAPTER_H
