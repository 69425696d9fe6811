#ifndef QUADRILLE_PLANAR_PATCHES_H
#define QUADRILLE_PLANAR_PATCHES_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/channel_options.h>
#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/adapter/label_numbers.h>
#include <quadrille/internal/core/base/function_name.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/call/map_keys.h>
#include <quadrille/internal/core/call/meshes.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/call/reporter.h>
#include <quadrille/internal/planar/planar_remesh.h>
#include <quadrille/parameters.h>
#include <quadrille/quadric.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

/// \file
/// Triangulates planar patches again: flat regions get the fewest faces at once, and nothing else
/// changes.

namespace quadrille {

/// The tolerance within which faces are planar, an argument of remesh_planar_patches(). By default
/// it allows for rounding only: 10⁻⁹ of the diagonal of the bounding box. Attributes may be as far
/// from affine on a patch, as a fraction of the range of each component, and by 10⁻⁶ of it at
/// least.
class PlanarTolerance : public internal::DistanceOrFraction {
public:
  /// `distance`, in the mesh's units: how far the surface may move.
  explicit PlanarTolerance(double distance) : PlanarTolerance(distance, false) {}
  /// The distance as a fraction of the diagonal of the bounding box.
  static PlanarTolerance relative(double fraction) { return PlanarTolerance(fraction, true); }

  double degrees = 10; ///< between the normals of a face and of its patch at most, below 90

  /// Throws std::invalid_argument for a number that is negative, not a number, or an angle of 90
  /// degrees or more.
  void validate() const {
    require_distance("quadrille::PlanarTolerance");
    if (!(degrees >= 0 && degrees < 90))
      throw std::invalid_argument("quadrille::PlanarTolerance: degrees " +
                                  internal::text_of(degrees) + " are not from 0 to below 90");
  }

private:
  PlanarTolerance(double number, bool is_relative) : DistanceOrFraction(number, is_relative) {}
};

/// The report of remesh_planar_patches(). It prints itself in one line.
struct PlanarReport {
  std::size_t faces_before = 0;    ///< faces of the input
  std::size_t faces_after = 0;     ///< faces of the result
  std::size_t vertices_before = 0; ///< vertices of the input
  std::size_t vertices_after = 0;  ///< vertices of the result
  std::size_t patches = 0;         ///< planar patches, of one face or more
  /// The number of patches that could be triangulated only with all vertices of their boundaries.
  std::size_t patches_with_boundary = 0;
  /// The number of patches that could not be triangulated at all: their faces are unchanged.
  std::size_t patches_unchanged = 0;
};

/// Prints a report in one line, without an end of line.
inline std::ostream& operator<<(std::ostream& out, const PlanarReport& report) {
  return out << report.faces_before << " -> " << report.faces_after << " faces, "
             << report.vertices_before << " -> " << report.vertices_after << " vertices, "
             << report.patches << " planar patches, " << report.patches_with_boundary
             << " with their entire boundaries, " << report.patches_unchanged << " unchanged";
}

namespace internal {

template <class T>
concept IsPlanarArgument = std::same_as<T, PlanarTolerance> || is_labels<T> || is_channel<T> ||
    std::same_as<T, SplitVertices> || IsNamedParameters<T>::value;

template <class... Arguments>
PlanarTolerance pick_planar_tolerance(const Arguments&... arguments) {
  static_assert(
      (IsPlanarArgument<Arguments> && ...),
      "remesh_planar_patches takes a PlanarTolerance, Labels, channels (Texture, Normals, "
      "Colors, Attributes), SplitVertices, and one chain of named parameters.");
  static_assert((std::same_as<Arguments, PlanarTolerance> + ... + 0) <= 1,
                "remesh_planar_patches takes one PlanarTolerance: pass it only once.");
  static_assert((IsNamedParameters<Arguments>::value + ... + 0) <= 1,
                "remesh_planar_patches takes one chain of named parameters: join them with a dot.");
  PlanarTolerance tolerance = PlanarTolerance::relative(1e-9);
  [[maybe_unused]] const auto pick = [&](const auto& argument) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(argument)>, PlanarTolerance>)
      tolerance = argument;
  };
  (pick(arguments), ...);
  tolerance.validate();
  return tolerance;
}

/// Rejects, at compile time, a call with named parameters that are not among `Known`.
template <class NamedParameters, class Known>
constexpr void check_planar_names() {
  namespace np = CGAL::internal_np;
  using All =
      Joined<Known,
             Names<np::all_default_t, np::geom_traits_t, np::face_patch_t,
                   np::vertex_is_constrained_t, np::vertex_color_map_t, np::vertex_texture_map_t,
                   np::vertex_normal_map_t, parameters::vertex_attribute_t>>;
  static_assert(std::same_as<typename OthersThan<NamedParameters, All>::type, Names<>>,
                "A named parameter of remesh_planar_patches has no effect: "
                "<quadrille/planar_patches.h> lists the ones that it uses.");
}

/// Remeshes the surface of an adapter that has been read. A surface may move by as much as two
/// vertices on two sides of a plane may be apart, and as far next to a boundary.
template <class Adapter>
PlanarReport remesh_with(Adapter& adapter, InputWithChannels input,
                         const PlanarTolerance& tolerance) {
  PlanarReport report;
  report.faces_before = input.triangles.size();
  report.vertices_before = input.positions.size();
  const double diagonal = input.box().diagonal(), distance = tolerance.distance(diagonal);
  const auto [surface, patches] =
      remesh(std::move(input),
             {distance / std::sqrt(5.0), std::cos(tolerance.degrees * (std::numbers::pi / 180)),
              (std::max)(1e-6, distance / diagonal)});
  report.faces_after = surface.face_count();
  report.vertices_after = surface.input_vertices().size();
  report.patches = patches.all;
  report.patches_with_boundary = patches.with_boundary;
  report.patches_unchanged = patches.unchanged;
  report.vertices_after += adapter.write(surface, reporter(CGAL::parameters::default_values()));
  return report;
}

template <class Points, class Triangles, class... Arguments>
PlanarReport remesh_soup(Points& points, Triangles& triangles, const Arguments&... arguments) {
  namespace np = CGAL::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const PlanarTolerance tolerance = pick_planar_tolerance(arguments...);
  const auto carried = pick_carried<Quadric>(arguments...);
  using Carried = std::remove_const_t<decltype(carried)>;
  const auto named = pick_named(arguments...);
  using NamedParameters = std::remove_const_t<decltype(named)>;
  check_planar_names<NamedParameters, Names<np::point_t>>();
  check_keys_of_soup<Quadric, Carried, NamedParameters>();
  auto map = choose_parameter(get_parameter(named, np::point_map),
                              CGAL::Identity_property_map<ElementOf<Points>>());
  check_points<typename boost::property_traits<decltype(map)>::value_type, NamedParameters>();
  Arena arena({0, 0});
  auto adapter = soup_adapter(points, triangles, map, NoAttributes{}, carried, arena);
  InputWithChannels input(adapter.read());
  fix_vertices(adapter, input, named);
  read_labels(carried, boost::irange(std::size_t{0}, std::ranges::size(triangles)), input, arena);
  return remesh_with(adapter, std::move(input), tolerance);
}

template <class Mesh, class... Arguments>
PlanarReport remesh_mesh(Mesh& mesh, const Arguments&... arguments) {
  namespace np = CGAL::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const PlanarTolerance tolerance = pick_planar_tolerance(arguments...);
  const auto carried = pick_carried<Quadric>(arguments...);
  using Carried = std::remove_const_t<decltype(carried)>;
  static_assert(
      !Carried::splits_vertices,
      "remesh_planar_patches: SplitVertices is for soups; a mesh has halfedges for maps.");
  const auto named = pick_named(arguments...);
  using NamedParameters = std::remove_const_t<decltype(named)>;
  check_planar_names<NamedParameters,
                     Names<np::vertex_point_t, np::vertex_index_t, np::edge_is_constrained_t>>();
  check_keys_of_mesh<Mesh, Quadric, Carried, NamedParameters>();
  auto points = choose_parameter(get_parameter(named, np::vertex_point),
                                 CGAL::get_property_map(CGAL::vertex_point, mesh));
  auto indices = CGAL::get_initialized_vertex_index_map(mesh, named);
  Arena arena({0, 0});
  auto channels = channel_maps(carried.channels);
  FaceGraphAdapter<Mesh, decltype(points), decltype(indices), NoAttributes, decltype(channels)>
      adapter(mesh, points, indices, {}, arena, std::move(channels));
  InputWithChannels input(adapter.read());
  fix_vertices(adapter, input, named);
  with_map<np::edge_is_constrained_t>(named, [&](const auto& map) {
    adapter.fix_edges(map, input);
    adapter.name_creases(map, input);
  });
  read_labels(carried, faces(mesh), input, arena);
  return remesh_with(adapter, std::move(input), tolerance);
}

} // namespace internal

/// Finds the planar patches of a triangle mesh and triangulates each again, in place, between the
/// vertices that its shape needs: flat regions of CAD models, of voxels and of buildings get at
/// once the fewest faces that vertices of the input allow.
///
/// A *patch* is a set of faces that are connected by edges and lie in one plane. Its boundary keeps
/// the vertices where it bends, where more or fewer than two patches meet, and where it touches
/// another vertex; the other boundary vertices are removed, in the same way from the patches on
/// both sides, and so are the vertices inside. The rest is triangulated by a constrained Delaunay
/// triangulation. No vertex moves. A patch without removable vertices stays as it is.
///
/// `mesh` is as in `simplify`. The arguments, in any order, are
///
/// - PlanarTolerance: which faces count as planar; by default those that are, up to rounding
/// - Labels, for faces; boundaries of labels are boundaries of patches
/// - Texture, Normals, Colors, Attributes, any number: channels, see channels.h. A patch ends where
///   a channel is not affine, or has a seam. The options for the weight of a channel are ignored
/// - CGAL's named parameters vertex_point_map, vertex_index_map, vertex_is_constrained_map (such a
///   vertex stays), edge_is_constrained_map (such an edge stays, with its ends), face_patch_map,
///   vertex_color_map, vertex_texture_map, vertex_normal_map, geom_traits, and
///   quadrille::parameters::vertex_attribute_map, as in `simplify`; others do not compile
///
/// The result has these guarantees, with a tolerance of `distance`, at least 18 units of rounding
/// of the largest coordinate:
///
/// - each point of either surface is within that distance of the other
/// - topology is kept, closed surfaces stay closed, faces keep their orientation, labels and
///   descriptors, and the edge descriptors of the result are some of the input's
/// - each vertex is a vertex of the input, at the same position, with the same values
/// - with the default tolerance, if the surface touches itself only at vertices, the vertices are
///   exactly the corners of patches: no triangulation of the same patches has fewer faces
///
/// If a patch cannot be triangulated, because boundaries would cross or close up once they are
/// made straight, it keeps all vertices of its boundary; or, if that is not sufficient, its faces:
/// PlanarReport counts both. The triangles of one patch cannot intersect, but with a large
/// tolerance patches of several planes may.
///
/// Time O(n log n) for n faces as a rule. Memory: about 200 bytes per face in addition to the mesh.
///
/// Throws as `simplify` does, before anything is changed. The same input gives the same result.
///
/// Source: the patches of CGAL 6, remesh_planar_patches(); boundaries are straightened as by
/// Douglas and Peucker, 1973.
template <class Mesh, class... Arguments>
requires internal::FaceGraph<Mesh>
    PlanarReport remesh_planar_patches(Mesh& mesh, const Arguments&... arguments) {
  return internal::in_name_of("remesh_planar_patches",
                              [&] { return internal::remesh_mesh(mesh, arguments...); });
}

/// Remeshes a polygon soup of triangles, in any of the forms that `simplify` takes: containers of
/// points and triangles, with point_map and SplitVertices as there, matrices, spans and other
/// buffers. It may be non-manifold: an edge that does not have exactly two faces is a boundary of
/// patches. So is an edge of two faces with opposite orientation, so the double-sided faces that
/// `simplify` recognises stay as they are. The remaining points and triangles keep their order;
/// points of no triangle, and triangles that name a point twice, are removed. There are no maps
/// over edges.
template <class Points, class Triangles, class... Arguments>
requires(internal::PointContainer<Points>&& internal::TriangleContainer<Triangles>) ||
    internal::BufferedSoup<std::remove_reference_t<Points>,
                           std::remove_reference_t<Triangles>> PlanarReport
    remesh_planar_patches(Points&& points, Triangles&& triangles, const Arguments&... arguments) {
  static_assert(internal::is_changeable<Points> && internal::is_changeable<Triangles>,
                "remesh_planar_patches changes the soup: pass a variable that is not const.");
  return internal::in_name_of("remesh_planar_patches", [&] {
    auto&& rows_of_points = internal::as_rows(points, "point", triangles);
    auto&& rows_of_triangles = internal::as_rows(triangles, "triangle", points);
    return internal::remesh_soup(rows_of_points, rows_of_triangles, arguments...);
  });
}

} // namespace quadrille

#endif // QUADRILLE_PLANAR_PATCHES_H
