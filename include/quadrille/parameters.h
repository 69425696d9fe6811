#ifndef QUADRILLE_PARAMETERS_H
#define QUADRILLE_PARAMETERS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>

/// Named parameters that CGAL has no name for. They are joined with a dot, ours first and CGAL's
/// after them:
/// `quadrille::parameters::vertex_importance_map(i).edge_is_crease_map(c).vertex_point_map(p)`.
/// What CGAL's functions return is a class of CGAL's, which knows no names but its own: behind such
/// a chain one of ours takes it as a second argument,
/// `quadrille::parameters::vertex_importance_map(i, CGAL::parameters::vertex_point_map(p))`.
namespace quadrille::parameters {

/// The tag of edge_is_crease_map().
enum edge_is_crease_t { edge_is_crease };
/// The tag of vertex_attribute_map().
enum vertex_attribute_t { vertex_attribute };
/// The tag of vertex_quadric_map().
enum vertex_quadric_t { vertex_quadric };
/// The tag of vertex_to_vertex_map().
enum vertex_to_vertex_t { vertex_to_vertex };
/// The tag of duplicate_output_iterator().
enum duplicate_output_t { duplicate_output };
/// The tag of face_is_selected_map().
enum face_is_selected_t { face_is_selected };
/// The tag of vertex_tolerance_map().
enum vertex_tolerance_t { vertex_tolerance };
/// The tag of vertex_importance_map().
enum vertex_importance_t { vertex_importance };

/// The tag of vertex_is_shared_map().
enum vertex_is_shared_t { vertex_is_shared };
/// The tag of edge_is_border_map().
enum edge_is_border_t { edge_is_border };
/// The tag of border_edges().
enum border_edges_t { border_edges_tag };
/// The tag of bounding_box().
enum bounding_box_t { bounding_box_tag };
/// The tag of coordinates_are_floats().
enum coordinates_are_floats_t { coordinates_are_floats_tag };

/// A chain of named parameters of which the last is one of ours: each of the functions below is a
/// member too, which puts its parameter behind this one, and so are those of CGAL.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Chain : public CGAL::Named_function_parameters<T, Tag, Base> {
public:
  using Cgals = CGAL::Named_function_parameters<T, Tag, Base>; ///< the same as CGAL has it
  using Cgals::Cgals;

  /// edge_is_crease_map() after this.
  template <class Map>
  auto edge_is_crease_map(const Map& map) const {
    return then<edge_is_crease_t>(map);
  }
  /// face_is_selected_map() after this.
  template <class Map>
  auto face_is_selected_map(const Map& map) const {
    return then<face_is_selected_t>(map);
  }
  /// vertex_tolerance_map() after this.
  template <class Map>
  auto vertex_tolerance_map(const Map& map) const {
    return then<vertex_tolerance_t>(map);
  }
  /// vertex_is_shared_map() after this.
  template <class Map>
  auto vertex_is_shared_map(const Map& map) const {
    return then<vertex_is_shared_t>(map);
  }
  /// edge_is_border_map() after this.
  template <class Map>
  auto edge_is_border_map(const Map& map) const {
    return then<edge_is_border_t>(map);
  }
  /// border_edges() after this.
  template <class Edges>
  auto border_edges(const Edges& edges) const {
    return then<border_edges_t>(edges);
  }
  /// bounding_box() after this.
  auto bounding_box(const CGAL::Bbox_3& box) const { return then<bounding_box_t>(box); }
  /// coordinates_are_floats() after this.
  auto coordinates_are_floats(bool are_floats = true) const {
    return then<coordinates_are_floats_t>(are_floats);
  }
  /// vertex_attribute_map() after this.
  template <class Map>
  auto vertex_attribute_map(const Map& map) const {
    return then<vertex_attribute_t>(map);
  }
  /// vertex_quadric_map() after this.
  template <class Map>
  auto vertex_quadric_map(const Map& map) const {
    return then<vertex_quadric_t>(map);
  }
  /// vertex_importance_map() after this.
  template <class Map>
  auto vertex_importance_map(const Map& map) const {
    return then<vertex_importance_t>(map);
  }
  /// vertex_to_vertex_map() after this.
  template <class Map>
  auto vertex_to_vertex_map(const Map& map) const {
    return then<vertex_to_vertex_t>(map);
  }
  /// duplicate_output_iterator() after this.
  template <class Iterator>
  auto duplicate_output_iterator(const Iterator& iterator) const {
    return then<duplicate_output_t>(iterator);
  }

private:
  template <class Next, class Value>
  Chain<Value, Next, Cgals> then(const Value& value) const {
    return {value, *this};
  }
};

/// The chain of a value, which is the first one or comes after others.
template <class Tag, class Value>
Chain<Value, Tag> chain(const Value& value) {
  return {value};
}
/// The same, after others.
template <class Tag, class Value, class T, class OtherTag, class Base>
Chain<Value, Tag, CGAL::Named_function_parameters<T, OtherTag, Base>>
chain(const Value& value, const CGAL::Named_function_parameters<T, OtherTag, Base>& before) {
  return {value, before};
}

/// A property map from edges to bool: where it is true, the edge is a crease for `Quadric`.
template <class Map, class... Before>
auto edge_is_crease_map(const Map& map, const Before&... before) {
  return chain<edge_is_crease_t>(map, before...);
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
template <class Map, class... Before>
auto face_is_selected_map(const Map& map, const Before&... before) {
  return chain<face_is_selected_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to numbers: how far points may
/// move, in the mesh's units, at least 0; infinity where that does not matter. Linear on faces. For
/// ToleranceLimit, which says what it promises.
template <class Map, class... Before>
auto vertex_tolerance_map(const Map& map, const Before&... before) {
  return chain<vertex_tolerance_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to bool, for a *piece* of a
/// surface that is simplified by itself: where it is true, another piece has this vertex as well.
/// Pieces fit after that as they did before, without a gap, a T-junction, or an edge of three
/// faces:
///
/// - A shared vertex stays where it is, bit by bit, as if it was constrained.
/// - No edge between two shared vertices comes about that this piece has not, since another piece
///   may have it, or make it, as well: Rejection::chord.
/// - An edge of one face between two shared vertices is no border, and nothing holds it like one,
///   but for those that edge_is_border_map or border_edges() names.
///
/// All pieces should be simplified in the scale of one box, see bounding_box, up to one
/// CostLimit: a target of faces would destroy a piece that has many shared vertices. Nothing of
/// the surface beyond the piece is looked at, which costs no accuracy beside MemorylessQuadric: a
/// shared vertex does not move, and lies on all of its faces. Creases that cost policies find by
/// angles, and labels' borders, are not seen at edges of two pieces.
template <class Map, class... Before>
auto vertex_is_shared_map(const Map& map, const Before&... before) {
  return chain<vertex_is_shared_t>(map, before...);
}

/// A property map from edges of a mesh to bool, beside vertex_is_shared_map: edges of one face
/// between two shared vertices that are borders of the whole surface. Others of one face are
/// borders anyway.
template <class Map, class... Before>
auto edge_is_border_map(const Map& map, const Before&... before) {
  return chain<edge_is_border_t>(map, before...);
}

/// The same of a soup: a range of pairs of point indices, as std::array<std::size_t, 2>.
template <class Edges, class... Before>
auto border_edges(const Edges& edges, const Before&... before) {
  return chain<border_edges_t>(edges, before...);
}

/// A CGAL::Bbox_3 in the scale of which the surface is simplified, instead of that of its own
/// bounding box: relative limits are of its diagonal, and costs have the bits that they have
/// in any other piece with the same box. A surface that reaches out of it by more than half of
/// its diagonal is refused by std::invalid_argument; less may come of an earlier simplification.
template <class... Before>
auto bounding_box(const CGAL::Bbox_3& box, const Before&... before) {
  return chain<bounding_box_t>(box, before...);
}

/// Will the coordinates of the result become floats, though the points that `simplify` is given
/// are of doubles, since a file or an array has them so? Then what is promised of distances,
/// normals, hulls, volumes and intersections holds of those floats: places are rounded before
/// anything is decided about them, as they are where the points are of floats.
template <class... Before>
auto coordinates_are_floats(bool are_floats, const Before&... before) {
  return chain<coordinates_are_floats_t>(are_floats, before...);
}

/// A property map from vertices (of a soup: from point indices) to N numbers, for
/// AttributeQuadric<N>.
template <class Map, class... Before>
auto vertex_attribute_map(const Map& map, const Before&... before) {
  return chain<vertex_attribute_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to QuadricForm, which `simplify`
/// writes: for each vertex that is left, what it remembers of the planes that have gone into it.
/// The form is about the vertex, in the units of the mesh and its attributes; its values are mean
/// squared distances to the planes, so its square root at 0 is the error of the vertex in the
/// sense of Report::error. For costs whose memory is a QuadricForm.
template <class Map, class... Before>
auto vertex_quadric_map(const Map& map, const Before&... before) {
  return chain<vertex_quadric_t>(map, before...);
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
/// Costs that are told, as Status::next_cost and to CostLimit, are multiplied too, by parts of the
/// greatest importance of the call: pieces of a surface that are to fit need the same greatest one.
///
/// Throws std::invalid_argument for one that is negative or not finite. Takes 4 bytes a vertex.
template <class Map, class... Before>
auto vertex_importance_map(const Map& map, const Before&... before) {
  return chain<vertex_importance_t>(map, before...);
}

/// In the place of an index: see vertex_to_vertex_map.
inline constexpr std::size_t vanished = ~std::size_t{0};

/// A property map that `simplify` writes for each vertex of the input: which vertex it has become
/// part of. From vertices of a mesh to vertices: null_vertex() of its graph traits where the
/// vertex has vanished with all of its faces, or had none. Of a soup from the old to the new
/// indices of points, both std::size_t: `vanished` in that case.
///
/// Keys are the vertices of the input, of which most are removed afterwards: for a mesh whose
/// vertices are handles use a map that does not look at them, as
/// boost::make_assoc_property_map(std_map). Of a vertex that a non-manifold result is written
/// with several times, it is the first one: see duplicate_output_iterator.
template <class Map, class... Before>
auto vertex_to_vertex_map(const Map& map, const Before&... before) {
  return chain<vertex_to_vertex_t>(map, before...);
}

/// An output iterator that takes the vertices that a mesh gets so that it can hold a non-manifold
/// result, each as a std::pair of the new vertex and the one that it is a duplicate of.
/// Duplicates have the position of that, its attributes and, in a Surface_mesh or a mesh of
/// OpenMesh, all of its properties; other maps are for the caller to fill.
template <class Iterator, class... Before>
auto duplicate_output_iterator(const Iterator& iterator, const Before&... before) {
  return chain<duplicate_output_t>(iterator, before...);
}

} // namespace quadrille::parameters

#endif // QUADRILLE_PARAMETERS_H
