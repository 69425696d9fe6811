#ifndef QUADRILLE_PARAMETERS_H
#define QUADRILLE_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

/// Named parameters that CGAL has no name for. CGAL's own chain behind them:
/// `quadrille::parameters::edge_is_crease_map(creases).vertex_point_map(points)`.
namespace quadrille::parameters {

enum edge_is_crease_t { edge_is_crease };
enum vertex_attribute_t { vertex_attribute };
enum vertex_quadric_t { vertex_quadric };

/// A property map from edges to bool: where it is true, the edge is a crease for `Quadric`.
template <class Map>
auto edge_is_crease_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, edge_is_crease_t>(map);
}
template <class Map, class Before>
auto edge_is_crease_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, edge_is_crease_t, Before>(map, before);
}

/// A property map from vertices (of a soup: from point indices) to N numbers, for
/// AttributeQuadric<N>.
template <class Map>
auto vertex_attribute_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_attribute_t>(map);
}
template <class Map, class Before>
auto vertex_attribute_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_attribute_t, Before>(map, before);
}

/// A property map from vertices (of a soup: from point indices) to QuadricForm, which `simplify`
/// writes: for each vertex that is left, what it remembers of the planes that have gone into it.
/// The form is about the vertex, in the units of the mesh and its attributes; its values are mean
/// squared distances to the planes, so its square root at 0 is the error of the vertex in the sense
/// of Report::error. For costs whose memory is a QuadricForm.
template <class Map>
auto vertex_quadric_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_quadric_t>(map);
}
template <class Map, class Before>
auto vertex_quadric_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_quadric_t, Before>(map, before);
}

} // namespace quadrille::parameters

#endif // QUADRILLE_PARAMETERS_H
