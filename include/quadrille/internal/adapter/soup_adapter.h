#ifndef QUADRILLE_INTERNAL_ADAPTER_SOUP_ADAPTER_H
#define QUADRILLE_INTERNAL_ADAPTER_SOUP_ADAPTER_H

#include <quadrille/internal/adapter/attributes.h>
#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/points.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/internal/surface/surface_input.h>
#include <quadrille/parameters.h>
#include <quadrille/vector.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

template <class Labels>
struct LabelValueOf {
  using type = typename boost::property_traits<decltype(Labels::map)>::value_type;
};
template <>
struct LabelValueOf<NoLabels> {
  using type = NoLabels;
};
template <class Labels>
using LabelValue = typename LabelValueOf<Labels>::type;

/// Reads a polygon soup of triangles into flat arrays and rewrites it from the result, in linear
/// time. Points and triangles that are left keep their order.
template <class Points, class Triangles, class PointMap, class Attributes, class Labels>
class SoupAdapter {
public:
  static constexpr std::size_t dimension = 3 + Attributes::size;
  using Point = typename boost::property_traits<PointMap>::value_type;

  SoupAdapter(Points& points, Triangles& triangles, PointMap map, Attributes attributes,
              Labels labels, Workspace& workspace)
      : workspace_(&workspace), points_(points), triangles_(triangles), map_(map),
        attributes_(attributes), labels_(labels) {}

  /// Throws std::invalid_argument for a face that is not a triangle or names a point that is not
  /// there, and for a point that is not finite.
  SurfaceInput<dimension> read() {
    TriangleComplex::check_size(std::ranges::size(points_), std::ranges::size(triangles_));
    SurfaceInput<dimension> surface(workspace_);
    surface.has_duplicate_faces = true;
    surface.reserve(std::ranges::size(points_), std::ranges::size(triangles_));
    for (std::size_t v = 0; v < std::ranges::size(points_); ++v) {
      surface.positions.push_back(read_position(v));
      require_finite(surface.positions.back(), v);
    }
    for (const auto& triangle : triangles_)
      surface.triangles.push_back(read_triangle(triangle, surface));
    if constexpr (Attributes::size > 0)
      attributes_.limit(surface);
    return surface;
  }

  /// Fixes the points of which get(map, index) is true.
  template <class Map>
  void fix_vertices(Map map, SurfaceInput<dimension>& surface) const {
    for (Index v = 0; v < surface.positions.size(); ++v)
      if (get(map, static_cast<std::size_t>(v)))
        surface.fix(v);
  }

  /// Rewrites points, triangles and attributes. The new points and triangles are built apart;
  /// attributes, and points that the map keeps elsewhere, are put back if anything throws, so the
  /// soup stays as it was. Calls tell as Teller says.
  template <class Result, class Tell>
  std::size_t write(const Result& result, Tell tell) {
    Points points = empty_like(points_);
    const Array<Index> inputs = result.input_vertices();
    const Array<Index> vertices = in_order(inputs, result.input_vertex_count());
    const Array<Index> new_index = places(vertices, vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      tell.vertex(i, vertices[i], result);
      points.push_back(points_[inputs[vertices[i]]]);
    }
    if constexpr (Tell::asks_for_images)
      tell_images(result, places(inputs, result.input_vertex_count()), new_index, tell);
    Triangles triangles = empty_like(triangles_);
    const Array<Index> input_faces = result.input_faces();
    const Array<Index> faces = in_order(input_faces, result.input_face_count());
    for (Index face : faces)
      triangles.push_back(
          renumbered(triangles_[input_faces[face]], result.corners(face), new_index));
    Undo undo;
    try {
      move_points(result, vertices, points, undo);
      write_attributes(result, vertices, inputs, undo);
      write_labels(faces, input_faces, undo);
    } catch (...) {
      undo.run(*this, points);
      throw;
    }
    std::swap(points_, points);
    std::swap(triangles_, triangles);
    return 0;
  }

private:
  // What has been overwritten, of each new point.
  struct Undo {
    std::vector<std::pair<std::size_t, Point>> points; // of those that have moved
    std::vector<AttributeValue<Attributes>> attributes;
    std::vector<LabelValue<Labels>> labels;

    void run(SoupAdapter& adapter, Points& new_points) const {
      for (const auto& [i, p] : points)
        put(adapter.map_, new_points[i], p);
      if constexpr (Attributes::size > 0)
        for (std::size_t i = 0; i < attributes.size(); ++i)
          adapter.attributes_.put_raw(i, attributes[i]);
      if constexpr (has_labels<Labels>)
        for (std::size_t i = 0; i < labels.size(); ++i)
          put(adapter.labels_.map, i, labels[i]);
    }
  };

  // The numbers of the result in the order of their inputs, which are below `count`.
  static Array<Index> in_order(const Array<Index>& inputs, std::size_t count) {
    Array<Index> order = places(inputs, count);
    std::erase(order, none);
    return order;
  }

  // `numbers` are those of the result, by inputs.
  template <class Result, class Tell>
  static void tell_images(const Result& result, const Array<Index>& numbers,
                          const Array<Index>& new_index, Tell& tell) {
    for (Index input = 0; input < numbers.size(); ++input) {
      const Index number = numbers[result.image(input)];
      tell.image(std::size_t{input},
                 number == none ? parameters::vanished : std::size_t{new_index[number]});
    }
  }

  // With the same allocator, else they can't be swapped.
  template <class Container>
  static Container empty_like(const Container& container) {
    if constexpr (requires { Container(container.get_allocator()); })
      return Container(container.get_allocator());
    else
      return Container();
  }

  Vector<dimension> read_position(std::size_t v) {
    const Vector<3> position = position_of(get(map_, points_[v]));
    if constexpr (Attributes::size > 0)
      return join(position, attributes_.read(v));
    else
      return position;
  }

  template <class Triangle>
  TriangleComplex::Triangle read_triangle(const Triangle& triangle,
                                          const SurfaceInput<dimension>& surface) const {
    const auto refuse = [&](const std::string& what) {
      throw std::invalid_argument("quadrille::simplify: face " +
                                  std::to_string(surface.triangles.size()) + what);
    };
    if (std::ranges::size(triangle) != 3)
      refuse(" is not a triangle; CGAL::Polygon_mesh_processing::triangulate_polygons makes it so");
    TriangleComplex::Triangle result;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!std::in_range<Index>(triangle[i]) ||
          std::cmp_greater_equal(triangle[i], surface.positions.size()))
        refuse(" names point " + std::to_string(triangle[i]) + " of " +
               std::to_string(surface.positions.size()));
      result[i] = static_cast<Index>(triangle[i]);
    }
    return result;
  }

  template <class Triangle>
  static Triangle renumbered(Triangle triangle, const TriangleComplex::Triangle& corners,
                             const Array<Index>& new_index) {
    using Integer = std::ranges::range_value_t<Triangle>;
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<Integer>(new_index[corners[i]]);
    return triangle;
  }

  template <class Result>
  void move_points(const Result& result, const Array<Index>& vertices, Points& points, Undo& undo) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (result.is_moved(vertices[i])) {
        undo.points.emplace_back(i, get(map_, points[i]));
        put(map_, points[i], point_at<Point>(space(result.position(vertices[i]))));
      }
  }

  // A new index is never above the old one, so going up nothing is overwritten that is still
  // needed.
  template <class Result>
  void write_attributes(const Result& result, const Array<Index>& vertices,
                        const Array<Index>& inputs, Undo& undo) {
    if constexpr (Attributes::size > 0)
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        undo.attributes.push_back(attributes_.raw(i));
        attributes_.put_raw(i, attributes_.raw(std::size_t{inputs[vertices[i]]}));
        if (result.is_moved(vertices[i]))
          attributes_.write(i, attributes_of(result.position(vertices[i])));
      }
  }

  // The labels of the faces that are left, in front. A new index is never above the old one.
  void write_labels([[maybe_unused]] const Array<Index>& faces,
                    [[maybe_unused]] const Array<Index>& inputs, [[maybe_unused]] Undo& undo) {
    if constexpr (has_labels<Labels>)
      for (std::size_t i = 0; i < faces.size(); ++i) {
        undo.labels.push_back(get(labels_.map, i));
        put(labels_.map, i, get(labels_.map, std::size_t{inputs[faces[i]]}));
      }
  }

  Workspace* workspace_;
  Points& points_;
  Triangles& triangles_;
  PointMap map_;
  QUADRILLE_NO_UNIQUE_ADDRESS Attributes attributes_;
  QUADRILLE_NO_UNIQUE_ADDRESS Labels labels_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ADAPTER_SOUP_ADAPTER_H
