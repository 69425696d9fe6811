#ifndef QUADRILLE_SIMPLIFY_H
#define QUADRILLE_SIMPLIFY_H

#include <quadrille/internal/core/base/compiler.h> // first, since it tells what compiler this needs

#include <quadrille/buffers.h>
#include <quadrille/channel_options.h>
#include <quadrille/concepts.h>
#include <quadrille/filters.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/call/arguments.h>
#include <quadrille/internal/core/call/compiled_engines.h>
#include <quadrille/internal/core/call/diagnostics.h>
#include <quadrille/internal/core/call/meshes.h>
#include <quadrille/order.h>
#include <quadrille/pairs.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/recorded.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>
#include <quadrille/version.h>

#ifdef QUADRILLE_WITH_COMPILED
namespace quadrille::internal {
QUADRILLE_ENGINES(extern template, Quadric);
} // namespace quadrille::internal
#endif

namespace quadrille {

inline namespace QUADRILLE_THREADING {

/// Simplifies a triangle mesh in place, contracting the cheapest pair of vertices again and again.
///
/// `mesh` models CGAL's MutableFaceGraph and FaceListGraph: Surface_mesh, Polyhedron_3,
/// Linear_cell_complex_for_combinatorial_map, OpenMesh. The arguments are policies, in any order
/// and at most one of a kind, filters, a Topology, and CGAL named parameters:
///
/// - a CostPolicy: what a contraction costs; or as the template argument Cost; Quadric by default
/// - a PlacementPolicy: where the vertex goes; or as the template argument Placement;
///   OptimalPlacement by default
/// - a PairPolicy: which pairs there are; EdgePairs{} by default
/// - a StopPolicy: when to stop; FaceRatio{0.5} by default. Those that bound distances are in
///   <quadrille/distance_limits.h>
/// - an order: GreedyOrder{} by default, or RelaxedOrder or AnyOrder of
///   <quadrille/relaxed_order.h>
/// - FilterPolicy, any number: what to refuse; NormalFlip{90} unless another one is given
/// - guards, any number, each with a header of its own: NoSelfIntersection, of
///   <quadrille/self_intersection.h>: no faces come to intersect; KeepSolid{}, of
///   <quadrille/self_intersection.h>: a closed solid stays one; NormalDeviation, of
///   <quadrille/normal_deviation.h>: normals stay within an angle of the input's; or a GuardPolicy
///   of the user's
/// - Labels: of faces, whose regions are kept
/// - Texture, Normals, Colors, Attributes, of <quadrille/channels.h>, any number: channels of
///   attributes; SplitVertices, for a soup
/// - Topology: kept, free, or parts_may_vanish; kept by default, free with pairs that are not edges
/// - record_into(recorder), of <quadrille/record.h>: a recorder is told of contractions, as Levels
///
/// Each of them may be a std::optional, which tells at run time whether it is given: one that holds
/// nothing is as if it had not been passed, so that the default holds. Costs, placements, channels
/// and SplitVertices can't be, since they are told by their types. Of the named parameters,
/// visitor, bounding_box and these maps may be a std::optional: of what is constrained, shared,
/// selected, a crease or a border, of tolerances, importance and face_patch_map.
///
/// Named parameters:
///
/// - vertex_point_map, vertex_index_map: as in CGAL
/// - visitor: see Visitor
/// - edge_is_constrained_map: such an edge stays, with its ends
/// - vertex_is_constrained_map: such a vertex stays where it is
/// - quadrille::parameters::vertex_tolerance_map: how far points may move: see ToleranceLimit
/// - vertex_importance_map: where more faces stay
/// - vertex_is_shared_map: of a piece of a surface, vertices that another piece has as well, with
///   edge_is_border_map, of a soup border_edges(), for borders between them
/// - coordinates_are_floats: places are rounded to floats before anything is decided about them
/// - bounding_box: the box in the scale of which the surface is simplified, as other pieces are
/// - face_is_selected_map: only such faces are simplified, and counted
/// - edge_is_crease_map: creases, see Quadric
/// - face_patch_map: the same as Labels
/// - vertex_color_map, vertex_texture_map, vertex_normal_map, vertex_attribute_map: the same as
///   Colors, Texture, Normals and Attributes of <quadrille/channels.h>, or what the cost reads: see
///   AttributeQuadric
/// - vertex_quadric_map: written, the quadrics of the vertices that are left
/// - vertex_to_vertex_map: written, what became of each vertex
/// - duplicate_output_iterator: gets the vertices that a non-manifold result is written with
///
/// A name that nothing in the call reads does not compile, but for CGAL's other maps to indices and
/// for geom_traits, which must be of the mesh's points and says no more than they: all is computed
/// with coordinates as doubles. Threads are chosen by the order and not by concurrency_tag.
///
/// Vertices and edges without a face go, constrained or not. What is left keeps its descriptors, so
/// property maps stay right. As in CGAL, meshes that only mark what is removed (Surface_mesh,
/// OpenMesh) are left for the caller to tidy up: `mesh.collect_garbage()`.
///
/// Time O(n log n) for n faces and close to linear, also where vertices have very many faces; such
/// a vertex stays where it is as long as it has more than 128. Memory: about 100 to 150 bytes a
/// face beside the mesh, 190 with ThinFeatureQuadric, more with attributes (see AttributeQuadric).
///
/// Throws std::invalid_argument for a face that is not a triangle, a vertex that is not finite,
/// attributes that are too few or that no weight makes comparable with positions, or a policy that
/// makes no sense, std::length_error above 2³⁰ faces, and what the user's own maps, policies and
/// visitors throw. If it throws, the mesh is as it was; what it has put into maps is put back, as
/// far as they let it (but for vertex_quadric_map and vertex_to_vertex_map, which nobody else
/// fills), and vertices that it had added are removed again, which a mesh that labels what is
/// removed may count as garbage.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::FaceGraph<Mesh> Report simplify(Mesh& mesh, const Arguments&... arguments) {
  if constexpr (internal::Fitting<Cost, Placement, Arguments...>) {
    const auto policies = internal::pick_policies<Cost, Placement>(arguments...);
    const auto carried = internal::pick_carried<internal::CostOf<Cost, Arguments...>>(arguments...);
    const auto named = internal::pick_named(arguments...);
    return internal::simplify_face_graph(mesh, policies, carried, named);
  } else {
    return internal::refuse<2, void(Mesh&), Cost, Placement, Arguments...>();
  }
}

/// The same with nothing but defaults. It is here because CGAL::simplify(x), which is found beside
/// the function above for a mesh of CGAL's, would be preferred to it.
template <class Mesh>
requires internal::FaceGraph<Mesh> Report simplify(Mesh& mesh) {
  return simplify<Quadric, OptimalPlacement>(mesh);
}

/// Simplifies a polygon soup of triangles in place; it may be non-manifold and of any orientation.
///
/// `points` and `triangles` are random-access containers: of points of a CGAL kernel or of three
/// floating-point numbers, as std::array<float, 3> (or of anything, with `point_map`), and of three
/// indices each. Points and triangles that are left keep their order; points of no triangle,
/// degenerate triangles, and those on the vertices of another one that runs the same way round, are
/// dropped. Two that run against each other are the sides of a sheet: both stay, each with what it
/// has, and each counts as a face. Property maps of the named parameters are over the
/// index of a point, CGAL::make_property_map(vector) say, and hold the results at the new indices;
/// the vector behind one keeps its length, with old values at the end. There are no maps over
/// edges, and no duplicates. Otherwise as above.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::PointContainer<Points> && internal::TriangleContainer<Triangles>
    Report simplify(Points& points, Triangles& triangles, const Arguments&... arguments) {
  if constexpr (internal::Fitting<Cost, Placement, Arguments...>) {
    const auto policies = internal::pick_policies<Cost, Placement>(arguments...);
    const auto carried = internal::pick_carried<internal::CostOf<Cost, Arguments...>>(arguments...);
    const auto named = internal::pick_named(arguments...);
    return internal::simplify_soup(points, triangles, policies, carried, named);
  } else {
    return internal::refuse<3, void(Points&, Triangles&), Cost, Placement, Arguments...>();
  }
}

/// Simplifies a soup whose numbers lie one after the other, in a matrix, or in the vertices of a
/// renderer, in place.
///
/// - points: a container of floating-point numbers, x y z x y z …, as std::vector<float>; an Eigen
///   matrix of a row for each and three columns, as Eigen::MatrixXd, or of a column for each and
///   three rows, as Eigen::Matrix3Xd; a Map or another view of one; a std::span of such numbers; a
///   VertexAttribute (see buffers.h); or a container as above
/// - triangles: a container of integers, three for each, as std::vector<std::uint32_t>; a matrix of
///   such rows or columns, as Eigen::MatrixXi; a view; a std::span; or a container as above
///
/// A matrix of three rows and three columns, of a type that does not tell, has a row for each,
/// unless the other one has columns. Containers and matrices get the size of the result. Spans,
/// views and VertexAttributes cannot: what is left is at their beginning, Report::vertices_after
/// points and Report::faces_after triangles; what follows it is unspecified. There is no point_map.
/// The result has the same bits as that of std::array<float, 3>; otherwise as above.
///
/// Throws also std::invalid_argument for numbers that are not three for each point or triangle, and
/// for a matrix of neither three columns nor three rows.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::BufferedSoup<std::remove_reference_t<Points>,
                                std::remove_reference_t<Triangles>> &&
    internal::is_changeable<Points> && internal::is_changeable<Triangles>
        Report simplify(Points&& points, Triangles&& triangles, const Arguments&... arguments) {
  auto&& rows_of_points = internal::as_rows(points, "point", triangles);
  auto&& rows_of_triangles = internal::as_rows(triangles, "triangle", points);
  if constexpr (internal::Fitting<Cost, Placement, Arguments...>) {
    const auto policies = internal::pick_policies<Cost, Placement>(arguments...);
    const auto carried = internal::pick_carried<internal::CostOf<Cost, Arguments...>>(arguments...);
    const auto named = internal::pick_named(arguments...);
    return internal::simplify_soup(rows_of_points, rows_of_triangles, policies, carried, named);
  } else {
    return internal::refuse<3, void(Points&, Triangles&), Cost, Placement, Arguments...>();
  }
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_SIMPLIFY_H
