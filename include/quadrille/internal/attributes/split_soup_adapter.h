#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_SPLIT_SOUP_ADAPTER_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_SPLIT_SOUP_ADAPTER_H

#include <quadrille/internal/attributes/soup_channels.h>
#include <quadrille/internal/core/adapter/soup_base.h>
#include <quadrille/internal/core/adapter/split_points.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <ranges>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Reads a soup whose vertices are split at seams, so that points at one place are one vertex, and
/// splits them again after the simplification: one point for each combination of values at a
/// place. O(n log n) for n points.
template <class Points, class Triangles, class PointMap, class Labels, class Maps>
class SplitSoupAdapter {
public:
  using Point = typename boost::property_traits<PointMap>::value_type;
  using Input = InputOf<3, has_channels_in<Maps>>;

  SplitSoupAdapter(Points& points, Triangles& triangles, PointMap map, Labels labels, Maps channels,
                   Arena& arena)
      : arena_(&arena), points_(points), triangles_(triangles), map_(map), labels_(labels),
        channels_(std::move(channels)), vertex_of_(&arena) {}

  /// Throws as SoupAdapter::read does.
  Input read() {
    TriangleComplex::check_size(std::ranges::size(points_), std::ranges::size(triangles_));
    Input surface(arena_);
    surface.has_duplicate_faces = surface.may_have_reverse_faces = true;
    weld(surface);
    Array<TriangleComplex::Triangle> corners(arena_);
    for (std::size_t face = 0; face < std::ranges::size(triangles_); ++face) {
      corners.push_back(
          read_triangle("quadrille::simplify", triangles_[face], face, vertex_of_.size()));
      const auto [a, b, c] = corners.back();
      surface.triangles.push_back({vertex_of_[a], vertex_of_[b], vertex_of_[c]});
    }
    if constexpr (has_channels_in<Maps>) {
      channels_.read(vertex_of_.size(), corners, *arena_, surface);
      for (ChannelInput& channel : surface.channels)
        if (channel.corners.empty())
          channel.corners = corners;
    }
    return surface;
  }

  /// Calls visit(v, value, i) for the value that a map has of the i-th vertex of the user's, which
  /// is the vertex v of the surface.
  template <class Map, class Visit>
  void for_each_value(Map map, Visit visit) const {
    for (std::size_t i = 0; i < vertex_of_.size(); ++i)
      visit(vertex_of_[i], get(map, i), i);
  }

  /// The input index of a point.
  Index vertex_of(std::size_t point) const { return vertex_of_[point]; }

  /// Rewrites points, triangles and channels; the soup stays as it was if anything throws.
  template <class Result, class AnyReporter>
  std::size_t write(const Result& result, AnyReporter reporter) {
    static_assert(!AnyReporter::asks_for_vertex_map,
                  "quadrille::simplify: vertex_to_vertex_map does not go with SplitVertices: a "
                  "point may become several.");
    const Array<Index> inputs = result.input_faces();
    const Array<Index> faces = ordered_faces(result, inputs, reporter);
    const SplitPoints split(result, faces, inputs, triangles_, channels_.of_points());
    require_room(split);
    auto points = empty_like(points_);
    for (std::size_t i = 0; i < split.size(); ++i) {
      points.push_back(points_[split.origin(i)]);
      reporter.vertex(i, split.vertex(i), result);
    }
    auto triangles = empty_like(triangles_);
    for (std::size_t f = 0; f < faces.size(); ++f)
      triangles.push_back(renumbered(triangles_[inputs[faces[f]]],
                                     [&](std::size_t i) { return split.number(f, i); }));
    auto channels = channels_.rewritten(result, faces);
    const auto values = channels_.values(result, split);
    std::vector<std::pair<std::size_t, Point>> overwritten;
    try {
      move_points(result, split, points, overwritten);
      put_in_place(
          points_, points, [&](std::size_t i) { return split.origin(i); }, triangles_, triangles,
          [&] {
            labels_.write(faces, inputs);
            channels_.write(values);
          },
          [&] {
            labels_.undo();
            channels_.undo();
          });
    } catch (...) {
      for (const auto& [i, p] : overwritten)
        put(map_, points[i], p);
      throw;
    }
    channels_.swap(channels);
    return 0;
  }

private:
  void require_room(const SplitPoints& split) const {
    if (split.size() > vertex_of_.size())
      throw std::length_error(
          "quadrille::simplify: there would be more split vertices than before, " +
          std::to_string(split.size()) + " of " + std::to_string(vertex_of_.size()));
  }

  // Points at one place are one vertex, which has the number of the first among the vertices.
  void weld(SurfaceInput<3>& surface) {
    Array<Vector<3>> places(arena_);
    for (std::size_t i = 0; i < std::ranges::size(points_); ++i) {
      places.push_back(position_of(get(map_, points_[i])));
      require_finite(places.back(), places.size() - 1);
    }
    Array<Index> order(places.size(), arena_);
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](const Index& i) {
      return std::tie(places[i][0], places[i][1], places[i][2], i);
    };
    std::sort(order.begin(), order.end(), [&](Index i, Index j) { return key(i) < key(j); });
    Array<Index> first(places.size(), arena_);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool is_same = k > 0 && places[order[k]] == places[order[k - 1]];
      first[order[k]] = is_same ? first[order[k - 1]] : order[k];
    }
    vertex_of_.resize(places.size());
    for (Index i = 0; i < places.size(); ++i)
      if (first[i] == i) {
        vertex_of_[i] = static_cast<Index>(surface.positions.size());
        surface.positions.push_back(places[i]);
      } else {
        vertex_of_[i] = vertex_of_[first[i]];
      }
  }

  template <class Result, class NewPoints>
  void move_points(const Result& result, const SplitPoints& split, NewPoints& points,
                   std::vector<std::pair<std::size_t, Point>>& overwritten) {
    for (std::size_t i = 0; i < split.size(); ++i) {
      const Vector<3> position = result.position(split.vertex(i));
      const Point old = get(map_, points[i]);
      if (position_of(old) == position)
        continue;
      overwritten.emplace_back(i, old);
      put(map_, points[i], point_at<Point>(position));
    }
  }

  Arena* arena_;
  Points& points_;
  Triangles& triangles_;
  PointMap map_;
  SoupLabels<Labels> labels_;
  SoupChannels<Maps> channels_;
  Array<Index> vertex_of_; // of each point
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_SPLIT_SOUP_ADAPTER_H
