#ifndef QUADRILLE_SIMPLIFY_H
#define QUADRILLE_SIMPLIFY_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

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

/// Simplifies a triangle mesh in place, by repeatedly contracting the cheapest pair of vertices.
///
/// `mesh` models CGAL's MutableFaceGraph and FaceListGraph: Surface_mesh, Polyhedron_3,
/// Linear_cell_complex_for_combinatorial_map, OpenMesh. The arguments are policies, in any order
/// and at most one of a kind, filters, a Topology, and CGAL named parameters:
///
/// - a CostPolicy: the cost of a contraction; may be the template argument Cost instead; Quadric by
///   default
/// - a PlacementPolicy: the position of the new vertex; may be the template argument Placement
///   instead; OptimalPlacement by default
/// - a PairPolicy: the candidate pairs; EdgePairs{} by default
/// - a StopPolicy: when to stop; FaceRatio{0.5} by default. Those that bound distances are in
///   <quadrille/distance_limits.h>
/// - an order: GreedyOrder{} by default, or RelaxedOrder or AnyOrder of
///   <quadrille/relaxed_order.h>
/// - FilterPolicy, any number: contractions to reject; NormalFlip{90} unless another one is given
/// - guards, any number, of <quadrille/guards.h>: NoSelfIntersection: no faces come to intersect;
///   KeepSolid{}: a closed solid stays one; NormalDeviation: normals stay within an angle of the
///   input's; or a GuardPolicy of the user's
/// - Labels: labels of faces, whose regions are preserved
/// - Texture, Normals, Colors, Attributes, of <quadrille/channels.h>, any number: channels of
///   attributes; SplitVertices, for a soup
/// - KeepPlanes, of <quadrille/keep_planes.h>: plane regions from a size on stay in their planes
/// - VoxelSize, of <quadrille/voxel_size.h>: the stairs of a surface of voxels become smooth
/// - Topology: kept, free, or components_may_vanish; kept by default, free with pairs that are not
/// edges
/// - record_into(recorder), of <quadrille/record.h>: the recorder, such as Levels, receives all
///   contractions
///
/// Each of them may be a std::optional: an empty one is the same as an argument that is not passed,
/// so that the default applies. Costs, placements, channels and SplitVertices cannot be optional,
/// since their types select them. Among the named parameters, visitor, bounding_box and these maps
/// may be a std::optional: the maps of constrained, shared, selected, crease and boundary elements,
/// of tolerances and importance, and face_patch_map.
///
/// Named parameters:
///
/// - vertex_point_map, vertex_index_map: as in CGAL
/// - visitor: see Visitor
/// - edge_is_constrained_map: a constrained edge stays, with its ends
/// - vertex_is_constrained_map: a constrained vertex does not move
/// - quadrille::parameters::vertex_tolerance_map: how far points may move: see ToleranceLimit
/// - vertex_importance_map: more faces stay where it is high
/// - vertex_is_shared_map: for a tile of a surface, the vertices that another tile has too; with
///   edge_is_boundary_map, or boundary_edges() for a soup, for boundary edges between them
/// - coordinates_are_floats: positions are rounded to floats before they are tested
/// - bounding_box: the box that sets the scale of the simplification, common to all tiles
/// - face_is_selected_map: only selected faces are simplified and counted
/// - edge_is_crease_map: creases, see Quadric
/// - face_patch_map: the same as Labels
/// - vertex_color_map, vertex_texture_map, vertex_normal_map, vertex_attribute_map: the same as
///   Colors, Texture, Normals and Attributes of <quadrille/channels.h>, or what the cost reads: see
///   AttributeQuadric
/// - vertex_quadric_map: output, the quadrics of the remaining vertices
/// - vertex_to_vertex_map: output, the vertex that each input vertex has become
/// - face_to_face_map: output, the face that each input face has become, if it is left
/// - duplicate_output_iterator: receives the duplicated vertices of a non-manifold result
///
/// A named parameter that nothing in the call reads is a compile-time error. The exceptions are
/// CGAL's other index maps, and geom_traits, which must fit the mesh's points and has no other
/// effect: all computations use doubles. The order selects the number of threads; concurrency_tag
/// does not.
///
/// Vertices and edges without a face are removed, constrained or not. The remaining elements keep
/// their descriptors, so property maps stay valid. As in CGAL, meshes that only mark removed
/// elements (Surface_mesh, OpenMesh) must be cleaned up by the caller: `mesh.collect_garbage()`.
///
/// Time O(n log n) for n faces, and close to linear in practice, also with high-valence vertices; a
/// vertex does not move as long as it has more than 128 faces. Memory: about 100 to 150 bytes per
/// face in addition to the mesh, 190 with ThinFeatureQuadric, more with attributes (see
/// AttributeQuadric).
///
/// Throws std::invalid_argument for a face that is not a triangle, a vertex that is not finite,
/// missing attributes or attributes whose range is too large or too small to be weighted against
/// positions, or an invalid policy; std::length_error above 2³⁰ faces; and whatever the user's
/// maps, policies and visitors throw. If it throws, the mesh is unchanged. Values written to maps
/// are restored where the maps allow it, except in the pure output maps vertex_quadric_map,
/// vertex_to_vertex_map and face_to_face_map. Added vertices are removed again; a mesh that marks
/// removed elements may count them as garbage.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::FaceGraph<Mesh> Report simplify(Mesh& mesh, const Arguments&... arguments) {
  if constexpr (internal::Fitting<Cost, Placement, Arguments...>) {
    const auto policies = internal::pick_policies<Cost, Placement>(arguments...);
    const auto carried = internal::pick_carried<internal::CostOf<Cost, Arguments...>>(arguments...);
    const auto named = internal::pick_named(arguments...);
    return internal::simplify_face_graph(mesh, policies, carried, named);
  } else {
    return internal::reject<2, void(Mesh&), Cost, Placement, Arguments...>();
  }
}

/// Simplifies a mesh with all defaults. Without this overload CGAL::simplify(x), which
/// argument-dependent lookup finds for a CGAL mesh, would be preferred to the function above.
template <class Mesh>
requires internal::FaceGraph<Mesh> Report simplify(Mesh& mesh) {
  return simplify<Quadric, OptimalPlacement>(mesh);
}

/// Simplifies a polygon soup of triangles in place; it may be non-manifold and of any orientation.
///
/// `points` and `triangles` are random-access containers: points are those of a CGAL kernel or
/// three floating-point numbers, as std::array<float, 3> (or anything, with `point_map`), and
/// triangles have three indices each. The remaining points and triangles keep their order. Points
/// without a triangle, degenerate triangles, and triangles with the vertices and the orientation of
/// another one are dropped. Two triangles of opposite orientation are the sides of a double-sided
/// face: both stay with their attributes, and each counts as a face. Property maps of the named
/// parameters are over the index of a point, for example CGAL::make_property_map(vector), and
/// contain the results at the new indices. The underlying vector keeps its length, with old values
/// at the end. There are no maps over edges, and no duplicated vertices. Otherwise as above.
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
    return internal::reject<3, void(Points&, Triangles&), Cost, Placement, Arguments...>();
  }
}

/// Simplifies in place a soup in flat arrays, in matrices, or in a renderer's vertex buffer.
///
/// - points: a container of floating-point numbers, x y z x y z …, as std::vector<float>; an Eigen
///   matrix with one row per point and three columns, as Eigen::MatrixXd, or with one column per
///   point and three rows, as Eigen::Matrix3Xd; a Map or another view of one; a std::span of such
///   numbers; a VertexAttribute (see buffers.h); or a container as above
/// - triangles: a container of integers, three for each, as std::vector<std::uint32_t>; a matrix of
///   such rows or columns, as Eigen::MatrixXi; a view; a std::span; or a container as above
///
/// A matrix with three rows and three columns, whose type leaves it open, has one row per element,
/// unless the other matrix has one column per element. Containers and matrices get the size of the
/// result. Spans, views and VertexAttributes cannot be resized: the result is at their beginning,
/// with Report::vertices_after points and Report::faces_after triangles, and the content after it
/// is unspecified. There is no point_map. The result has the same bits as that of std::array<float,
/// 3>; otherwise as above.
///
/// It also throws std::invalid_argument for an array whose size is not a multiple of three, and for
/// a matrix with neither three columns nor three rows.
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
    return internal::reject<3, void(Points&, Triangles&), Cost, Placement, Arguments...>();
  }
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_SIMPLIFY_H
