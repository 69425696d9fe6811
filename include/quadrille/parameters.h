#ifndef QUADRILLE_PARAMETERS_H
#define QUADRILLE_PARAMETERS_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>

/// Named parameters in addition to CGAL's. They are chained with dots, this library's first and
/// CGAL's after them:
/// `quadrille::parameters::vertex_importance_map(i).edge_is_crease_map(c).vertex_point_map(p)`.
/// CGAL's functions return a CGAL class, which only has CGAL's names. To append a parameter of this
/// library to such a chain, pass the chain as its second argument:
/// `quadrille::parameters::vertex_importance_map(i, CGAL::parameters::vertex_point_map(p))`.
namespace quadrille::parameters {

/// The tag of edge_is_crease_map().
enum edge_is_crease_t { edge_is_crease };
/// The tag of vertex_attribute_map().
enum vertex_attribute_t { vertex_attribute };
/// The tag of vertex_quadric_map().
enum vertex_quadric_t { vertex_quadric };
/// The tag of vertex_to_vertex_map(), which is that of CGAL.
using vertex_to_vertex_t = CGAL::internal_np::vertex_to_vertex_map_t;
/// The value of this tag.
inline constexpr vertex_to_vertex_t vertex_to_vertex = CGAL::internal_np::vertex_to_vertex_map;
/// The tag of face_to_face_map(), which is that of CGAL.
using face_to_face_t = CGAL::internal_np::face_to_face_map_t;
/// The value of this tag.
inline constexpr face_to_face_t face_to_face = CGAL::internal_np::face_to_face_map;
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
/// The tag of edge_is_boundary_map().
enum edge_is_boundary_t { edge_is_boundary };
/// The tag of boundary_edges().
enum boundary_edges_t { boundary_edges_tag };
/// The tag of bounding_box().
enum bounding_box_t { bounding_box_tag };
/// The tag of coordinates_are_floats().
enum coordinates_are_floats_t { coordinates_are_floats_tag };

/// A chain of named parameters that began with one of this library: each of the functions below is
/// a member too, which appends its parameter to the chain, and so is each of CGAL's, in any order.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Chain : public CGAL::Named_function_parameters<T, Tag, Base> {
public:
  using Cgals = CGAL::Named_function_parameters<T, Tag, Base>; ///< the equivalent class of CGAL
  using Cgals::Cgals;

  /// Appends edge_is_crease_map().
  template <class Map>
  auto edge_is_crease_map(const Map& map) const {
    return then<edge_is_crease_t>(map);
  }
  /// Appends face_is_selected_map().
  template <class Map>
  auto face_is_selected_map(const Map& map) const {
    return then<face_is_selected_t>(map);
  }
  /// Appends vertex_tolerance_map().
  template <class Map>
  auto vertex_tolerance_map(const Map& map) const {
    return then<vertex_tolerance_t>(map);
  }
  /// Appends vertex_is_shared_map().
  template <class Map>
  auto vertex_is_shared_map(const Map& map) const {
    return then<vertex_is_shared_t>(map);
  }
  /// Appends edge_is_boundary_map().
  template <class Map>
  auto edge_is_boundary_map(const Map& map) const {
    return then<edge_is_boundary_t>(map);
  }
  /// Appends boundary_edges().
  template <class Edges>
  auto boundary_edges(const Edges& edges) const {
    return then<boundary_edges_t>(edges);
  }
  /// Appends bounding_box().
  auto bounding_box(const CGAL::Bbox_3& box) const { return then<bounding_box_t>(box); }
  /// Appends coordinates_are_floats().
  auto coordinates_are_floats(bool are_floats = true) const {
    return then<coordinates_are_floats_t>(are_floats);
  }
  /// Appends vertex_attribute_map().
  template <class Map>
  auto vertex_attribute_map(const Map& map) const {
    return then<vertex_attribute_t>(map);
  }
  /// Appends vertex_quadric_map().
  template <class Map>
  auto vertex_quadric_map(const Map& map) const {
    return then<vertex_quadric_t>(map);
  }
  /// Appends vertex_importance_map().
  template <class Map>
  auto vertex_importance_map(const Map& map) const {
    return then<vertex_importance_t>(map);
  }
  /// Appends duplicate_output_iterator().
  template <class Iterator>
  auto duplicate_output_iterator(const Iterator& iterator) const {
    return then<duplicate_output_t>(iterator);
  }

  // CGAL's own names, vertex_to_vertex_map and face_to_face_map among them, which its list declares
  // by this macro; those that it declares by others end the members of this library.
  /// \cond
#define CGAL_add_named_parameter(Name, Variable, function)                                         \
  template <class Value>                                                                           \
  auto function(const Value& value) const {                                                        \
    return then<CGAL::internal_np::Name>(value);                                                   \
  }
#define CGAL_add_named_parameter_with_compatibility(Name, Variable, function)
#define CGAL_add_named_parameter_with_compatibility_cref_only(Name, Variable, function)
#define CGAL_add_named_parameter_with_compatibility_ref_only(Name, Variable, function)
#define CGAL_add_extra_named_parameter_with_compatibility(Name, Variable, function)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility
  /// \endcond

private:
  template <class Next, class Value>
  Chain<Value, Next, Cgals> then(const Value& value) const {
    return {value, *this};
  }
};

/// Makes a chain of one value.
template <class Tag, class Value>
Chain<Value, Tag> chain(const Value& value) {
  return {value};
}
/// Appends a value to a chain.
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
/// true are simplified. All vertices of other faces stay in place with all attributes, so these
/// faces are bit-identical and the simplified ones fit to them; degenerate and doubled faces of a
/// soup are still dropped. Counts and ratios of stop policies, and the status that a visitor
/// receives, refer to the selected faces and their vertices. Relative distances refer to the
/// diagonal of the whole surface, and Report to the whole surface.
///
/// The map is read, but not written: in a mesh the face descriptors stay valid; for a soup, pass
/// `Labels` of the same map to get it back in the new order.
template <class Map, class... Before>
auto face_is_selected_map(const Map& map, const Before&... before) {
  return chain<face_is_selected_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to numbers: the distance by which
/// points may move, in the mesh's units, at least 0; infinity where there is no limit. It is linear
/// on faces. It belongs to ToleranceLimit, which documents the guarantee.
template <class Map, class... Before>
auto vertex_tolerance_map(const Map& map, const Before&... before) {
  return chain<vertex_tolerance_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to bool, for a *tile* of a surface
/// that is simplified by itself: where it is true, another tile has this vertex too. The simplified
/// tiles then still fit together, without a gap, a T-junction, or an edge of three faces:
///
/// - A shared vertex stays in place, bit for bit, as if it were constrained.
/// - No new edge between two shared vertices arises, since another tile may have or create the same
///   edge: Rejection::chord.
/// - An edge of one face between two shared vertices is not treated as a boundary, unless
///   edge_is_boundary_map or boundary_edges() names it.
///
/// All tiles should be simplified in the scale of one box (see bounding_box), up to one CostLimit:
/// a target of faces would destroy a tile with many shared vertices. The surface outside the tile
/// is not considered. With MemorylessQuadric this does not reduce accuracy, since a shared vertex
/// does not move and lies on all of its faces. Edges between two tiles are not recognized as
/// creases by their angle, nor as region boundaries of labels.
template <class Map, class... Before>
auto vertex_is_shared_map(const Map& map, const Before&... before) {
  return chain<vertex_is_shared_t>(map, before...);
}

/// A property map from edges of a mesh to bool, in addition to vertex_is_shared_map: edges of one
/// face between two shared vertices that are on the boundary of the whole surface. Other edges of
/// one face are boundaries anyway.
template <class Map, class... Before>
auto edge_is_boundary_map(const Map& map, const Before&... before) {
  return chain<edge_is_boundary_t>(map, before...);
}

/// The boundary edges for a soup: a range of pairs of point indices, as std::array<std::size_t, 2>.
template <class Edges, class... Before>
auto boundary_edges(const Edges& edges, const Before&... before) {
  return chain<boundary_edges_t>(edges, before...);
}

/// A CGAL::Bbox_3 that sets the scale of the simplification in place of the surface's own bounding
/// box: relative limits refer to its diagonal, and costs are bit-identical to those in any other
/// tile with the same box. A surface that extends beyond the box by more than half of its diagonal
/// is rejected with std::invalid_argument; a smaller excess may result from an earlier
/// simplification.
template <class... Before>
auto bounding_box(const CGAL::Bbox_3& box, const Before&... before) {
  return chain<bounding_box_t>(box, before...);
}

/// True if the coordinates of the result will be stored as floats, in a file or an array, although
/// the points passed to `simplify` are doubles. Guarantees about distances, normals, hulls, volumes
/// and intersections then hold for these floats: positions are rounded before they are tested, as
/// they are when the points are floats.
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
/// writes: the quadric of each remaining vertex, accumulated from the planes that contributed to
/// it. Its origin is the vertex, in the units of the mesh and its attributes; its values are mean
/// squared distances to the planes, so the square root of its value at 0 is the error of the vertex
/// in the sense of Report::error. It is for costs whose vertex state is a QuadricForm.
template <class Map, class... Before>
auto vertex_quadric_map(const Map& map, const Before&... before) {
  return chain<vertex_quadric_t>(map, before...);
}

/// A property map from vertices (of a soup: from point indices) to numbers, at least 0: the factor
/// on the costs of contractions at the vertex, so that more faces stay where it is large. Only
/// ratios matter. On a curved surface, 8 times the importance leaves about twice as many faces for
/// the same area, at half the distance; in general a factor f leaves ∛f times as many. Vertices
/// with importance 0 are contracted first, the cheapest ones before the others.
///
/// A pair has the greater importance of its two ends, and the new vertex inherits it. So
/// merged vertices keep their importance, in whatever order they were merged, and important regions
/// do not erode from their boundaries. Placement, distance limits, and all reported errors are the
/// same as without importance. curvature_importance() and view_importance() of
/// <quadrille/importance.h> make such maps.
///
/// The costs in Status::next_cost and for CostLimit are multiplied too, by fractions of the
/// greatest importance of the call: tiles of one surface need the same greatest importance.
///
/// Throws std::invalid_argument for an importance that is negative or not finite. It takes 4 bytes
/// per vertex.
template <class Map, class... Before>
auto vertex_importance_map(const Map& map, const Before&... before) {
  return chain<vertex_importance_t>(map, before...);
}

/// The value that stands for a removed vertex or triangle: see vertex_to_vertex_map and
/// face_to_face_map.
inline constexpr std::size_t vanished = ~std::size_t{0};

/// A property map that `simplify` writes for each vertex of the input: the vertex that it was
/// merged into. For a mesh it maps vertices to vertices, with null_vertex() of its graph traits if
/// the vertex has vanished with all of its faces, or had none. For a soup it maps old to new point
/// indices, both std::size_t, with `vanished` in this case.
///
/// Keys are the vertices of the input, of which most are removed afterwards: for a mesh whose
/// vertices are handles use a map that does not dereference them, as
/// boost::make_assoc_property_map(std_map). If a vertex of a non-manifold result is duplicated, the
/// value is the first one: see duplicate_output_iterator.
template <class Map, class... Before>
auto vertex_to_vertex_map(const Map& map, const Before&... before) {
  return chain<vertex_to_vertex_t>(map, before...);
}

/// A property map that `simplify` writes for each face of the input: the face of the result that
/// it has become. For a mesh it maps faces to faces: a face that is left keeps its descriptor, and
/// one that is not has null_face() of its graph traits. For a soup it maps old to new indices of
/// triangles, both std::size_t, with `vanished` for those that are gone. Its inverse lists the
/// birth face of each face of the result. Keys are as for vertex_to_vertex_map.
template <class Map, class... Before>
auto face_to_face_map(const Map& map, const Before&... before) {
  return chain<face_to_face_t>(map, before...);
}

/// An output iterator that receives the vertices added to a mesh to represent a non-manifold
/// result, each as a std::pair of the new vertex and the one that it duplicates. A duplicate has
/// the same position and attributes and, in a Surface_mesh or a mesh of OpenMesh, all of its
/// properties; the caller must fill other maps.
template <class Iterator, class... Before>
auto duplicate_output_iterator(const Iterator& iterator, const Before&... before) {
  return chain<duplicate_output_t>(iterator, before...);
}

} // namespace quadrille::parameters

#endif // QUADRILLE_PARAMETERS_H
