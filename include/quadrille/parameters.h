#ifndef QUADRILLE_PARAMETERS_H
#define QUADRILLE_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

/// Named parameters that CGAL has no name for. CGAL's own chain after them:
/// `quadrille::parameters::edge_is_crease_map(creases).vertex_point_map(points)`.
namespace quadrille::parameters {

/// The tag of edge_is_crease_map().
enum edge_is_crease_t { edge_is_crease };
/// The tag of vertex_attribute_map().
enum vertex_attribute_t { vertex_attribute };
/// The tag of vertex_quadric_map().
enum vertex_quadric_t { vertex_quadric };
/// The tag of vertex_image_map().
enum vertex_image_t { vertex_image };
/// The tag of duplicate_output_iterator().
enum duplicate_output_t { duplicate_output };
/// The tag of face_is_selected_map().
enum face_is_selected_t { face_is_selected };
/// The tag of vertex_tolerance_map().
enum vertex_tolerance_t { vertex_tolerance };
/// The tag of vertex_importance_map().
enum vertex_importance_t { vertex_importance };

/// A property map from edges to bool: where it is true, the edge is a crease for `Quadric`.
template <class Map>
auto edge_is_crease_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, edge_is_crease_t>(map);
}
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto edge_is_crease_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, edge_is_crease_t, Before>(map, before);
}

/// A property map from faces (of a soup: from indices of triangles) to bool: only faces where it is
/// true are simplified. All vertices of other faces stay where they are, with all attributes, so
/// these faces are left bit by bit and what is simplified fits to them; a soup's degenerate and
/// doubled ones are dropped as ever. Counts and ratios of stop policies, and what a visitor is
/// told, are of the selected faces and their vertices; distances relative to a diagonal are of that
/// of all, and Report tells of all.
///
/// The map is read, and not written: in a mesh descriptors of faces stay; of a soup, `Labels` of
/// the same map come back in order.
template <class Map>
auto face_is_selected_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, face_is_selected_t>(map);
}
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto face_is_selected_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, face_is_selected_t, Before>(map, before);
}

/// A property map from vertices (of a soup: from point indices) to numbers: how far points may
/// move, in the mesh's units, at least 0; infinity where that does not matter. Linear on faces. For
/// ToleranceLimit, which says what it promises.
template <class Map>
auto vertex_tolerance_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_tolerance_t>(map);
}
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto vertex_tolerance_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_tolerance_t, Before>(map, before);
}

/// A property map from vertices (of a soup: from point indices) to N numbers, for
/// AttributeQuadric<N>.
template <class Map>
auto vertex_attribute_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_attribute_t>(map);
}
/// The same parameter, after others in a chain.
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
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto vertex_quadric_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_quadric_t, Before>(map, before);
}

/// A property map from vertices (of a soup: from point indices) to numbers, at least 0: by how much
/// what a contraction at the vertex costs is multiplied, so that more faces stay where it is large.
/// Only ratios matter. On a curved surface 8 times the importance leaves about twice as many faces
/// for the same area, with half of the distance; in general f times leaves the cube root of f. What
/// has 0 goes first, the cheapest before the others.
///
/// A pair counts as the more important of its two ends, and the vertex that it becomes as well: so
/// what has become part of a vertex counts on, in whatever order that came about, and important
/// parts do not fade from their rims. Where the vertex goes, limits of distances, and all errors
/// that are told are as they were without. curvature_importance() and view_importance() of
/// <quadrille/importance.h> make such maps.
///
/// Throws std::invalid_argument for one that is negative or not finite. Takes 4 bytes a vertex.
template <class Map>
auto vertex_importance_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_importance_t>(map);
}
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto vertex_importance_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_importance_t, Before>(map, before);
}

/// In the place of an index: see vertex_image_map.
inline constexpr std::size_t vanished = ~std::size_t{0};

/// A property map that `simplify` writes for each vertex of the input: which vertex it has become
/// part of. From vertices of a mesh to vertices: null_vertex() of its graph traits where the vertex
/// has vanished with all of its faces, or had none. Of a soup from the old to the new indices of
/// points, both std::size_t: `vanished` in that case.
///
/// Keys are the vertices of the input, of which most are removed afterwards: for a mesh whose
/// vertices are handles use a map that does not look at them, as
/// boost::make_assoc_property_map(std_map). Of a vertex that a non-manifold result is written with
/// several times, it is the first one: see duplicate_output_iterator.
template <class Map>
auto vertex_image_map(const Map& map) {
  return CGAL::Named_function_parameters<Map, vertex_image_t>(map);
}
/// The same parameter, after others in a chain.
template <class Map, class Before>
auto vertex_image_map(const Map& map, const Before& before) {
  return CGAL::Named_function_parameters<Map, vertex_image_t, Before>(map, before);
}

/// An output iterator that takes the vertices that a mesh gets so that it can hold a non-manifold
/// result, each as a std::pair of the new vertex and the one that it is a duplicate of. Duplicates
/// have the position of that, its attributes and, in a Surface_mesh or a mesh of OpenMesh, all of
/// its properties; other maps are for the caller to fill.
template <class Iterator>
auto duplicate_output_iterator(const Iterator& iterator) {
  return CGAL::Named_function_parameters<Iterator, duplicate_output_t>(iterator);
}
/// The same parameter, after others in a chain.
template <class Iterator, class Before>
auto duplicate_output_iterator(const Iterator& iterator, const Before& before) {
  return CGAL::Named_function_parameters<Iterator, duplicate_output_t, Before>(iterator, before);
}

} // namespace quadrille::parameters

#endif // QUADRILLE_PARAMETERS_H
