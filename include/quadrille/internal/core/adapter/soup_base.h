#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_BASE_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_BASE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

/// The base of the adapters of soups.

namespace quadrille::internal {

/// The numbers of a result in the order of their inputs, which are below `count`.
inline Array<Index> in_order(const Array<Index>& inputs, std::size_t count) {
  Array<Index> order = places(inputs, count);
  std::erase(order, none);
  return order;
}

/// Returns the faces of a result in the order of their inputs, and reports which of them each face
/// of the input has become.
template <class Result, class AnyReporter>
Array<Index> ordered_faces(const Result& result, const Array<Index>& inputs,
                           AnyReporter& reporter) {
  const Array<Index> faces = in_order(inputs, result.input_face_count());
  if constexpr (AnyReporter::asks_for_face_map) {
    std::vector<std::size_t> map(result.input_face_count(), parameters::vanished);
    for (std::size_t f = 0; f < faces.size(); ++f)
      map[inputs[faces[f]]] = f;
    for (std::size_t input = 0; input < result.input_face_count(); ++input)
      reporter.map_face(input, map[input]);
  }
  return faces;
}

/// Puts points and triangles that have been built in the place of those of a soup, and calls
/// write() in between: maps that it writes to may lie among the points, so these come first. If it
/// throws, undo() puts back what it has written, and the soup is as it was. `origin(i)` is the
/// point of the input that is point i now.
template <class Points, class NewPoints, class Origin, class Triangles, class NewTriangles,
          class Write, class Undo>
void put_in_place(Points& points, NewPoints& new_points, Origin origin, Triangles& triangles,
                  NewTriangles& new_triangles, Write write, Undo undo) {
  auto&& points_left = replacement(points, new_points, origin);
  auto&& triangles_left = replacement(triangles, new_triangles, std::identity());
  swap_in(points, points_left);
  try {
    write();
  } catch (...) {
    undo();
    swap_in(points, points_left);
    throw;
  }
  swap_in(triangles, triangles_left);
}

/// The labels of a soup's triangles.
template <class Labels>
class SoupLabels {
public:
  explicit SoupLabels(Labels labels) : labels_(std::move(labels)) {}

  /// Moves those of the faces that are left to the front; `inputs` are the triangles that these
  /// were, in their order. If anything throws, undo() puts back what there was.
  void write(const Array<Index>& faces, const Array<Index>& inputs) {
    for (std::size_t i = 0; i < faces.size(); ++i) { // a new index is never above the old one
      overwritten_.push_back(get(labels_.map, i));
      put(labels_.map, i, get(labels_.map, std::size_t{inputs[faces[i]]}));
    }
  }
  void undo() {
    for (std::size_t i = 0; i < overwritten_.size(); ++i)
      put(labels_.map, i, overwritten_[i]);
  }

private:
  Labels labels_;
  std::vector<typename boost::property_traits<decltype(Labels::map)>::value_type> overwritten_;
};
template <class Labels>
class SoupLabels<std::optional<Labels>> {
public:
  explicit SoupLabels(const std::optional<Labels>& labels) {
    if (labels)
      labels_.emplace(*labels);
  }
  void write(const Array<Index>& faces, const Array<Index>& inputs) {
    if (labels_)
      labels_->write(faces, inputs);
  }
  void undo() {
    if (labels_)
      labels_->undo();
  }

private:
  std::optional<SoupLabels<Labels>> labels_;
};
template <>
class SoupLabels<NoLabels> {
public:
  explicit SoupLabels(NoLabels) {}
  void write(const Array<Index>&, const Array<Index>&) {}
  void undo() {}
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_SOUP_BASE_H
