#ifndef QUADRILLE_INTERNAL_CORE_CALL_REPORTER_H
#define QUADRILLE_INTERNAL_CORE_CALL_REPORTER_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace quadrille::internal {

/// Reports the result through named parameters, while an adapter writes it. A report that was not
/// requested is Param_not_found, and costs nothing.
template <class QuadricMap, class VertexMap, class FaceMap, class Duplicates>
class Reporter {
public:
  static constexpr bool asks_for_states = is_given<QuadricMap>;
  static constexpr bool asks_for_vertex_map = is_given<VertexMap>;
  static constexpr bool asks_for_face_map = is_given<FaceMap>;

  Reporter(QuadricMap quadrics, VertexMap vertices, FaceMap faces, Duplicates duplicates)
      : quadrics_(quadrics), vertex_map_(vertices), face_map_(faces), duplicates_(duplicates) {}

  /// For each vertex v that is left, with its key in the user's maps.
  void vertex(const auto& key, Index v, const auto& result) const {
    if constexpr (is_given<QuadricMap>)
      put(quadrics_, key, result.mean_quadric(v));
  }

  /// For each vertex of the input, with what it has become.
  void map_vertex(const auto& key, const auto& of_it) const {
    if constexpr (is_given<VertexMap>)
      put(vertex_map_, key, of_it);
  }

  /// For each face of the input, with what it has become.
  void map_face(const auto& key, const auto& of_it) const {
    if constexpr (is_given<FaceMap>)
      put(face_map_, key, of_it);
  }

  /// For each vertex that has been added.
  void duplicate(const auto& added, const auto& original) {
    if constexpr (is_given<Duplicates>)
      *duplicates_++ = std::pair(added, original);
  }

private:
  QUADRILLE_NO_UNIQUE_ADDRESS QuadricMap quadrics_;
  QUADRILLE_NO_UNIQUE_ADDRESS VertexMap vertex_map_;
  QUADRILLE_NO_UNIQUE_ADDRESS FaceMap face_map_;
  QUADRILLE_NO_UNIQUE_ADDRESS Duplicates duplicates_;
};

template <class NamedParameters>
auto reporter(const NamedParameters& named) {
  using CGAL::parameters::get_parameter;
  return Reporter(get_parameter(named, parameters::vertex_quadric),
                  get_parameter(named, parameters::vertex_to_vertex),
                  get_parameter(named, parameters::face_to_face),
                  get_parameter(named, parameters::duplicate_output));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_REPORTER_H
