#ifndef QUADRILLE_INTERNAL_CORE_CALL_MESHES_H
#define QUADRILLE_INTERNAL_CORE_CALL_MESHES_H

#include <quadrille/internal/core/adapter/face_graph_adapter.h>
#include <quadrille/internal/core/adapter/label_numbers.h>
#include <quadrille/internal/core/adapter/no_channel_maps.h>
#include <quadrille/internal/core/adapter/soup_adapter.h>
#include <quadrille/internal/core/adapter/soup_rows.h>
#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/call/arguments.h>
#include <quadrille/internal/core/call/chunk_parameters.h>
#include <quadrille/internal/core/call/map_keys.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/call/reporter.h>
#include <quadrille/internal/core/call/run.h>
#include <quadrille/internal/core/cost/vertex_importance.h>
#include <quadrille/parameters.h>
#include <quadrille/report.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>
#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <type_traits>
#include <utility>

/// The two kinds of surface that `simplify` takes, from their named parameters to a run.

namespace quadrille::internal {

/// CGAL's MutableFaceGraph and FaceListGraph. vertices, halfedges and faces are asked for first:
/// the graph traits of a type that is no graph are a hard error.
template <class G>
concept FaceGraph = requires(G& g) {
  vertices(g);
  halfedges(g);
  faces(g);
}
&&requires(G& g, typename boost::graph_traits<G>::halfedge_descriptor h,
           typename boost::graph_traits<G>::face_descriptor f) {
  set_next(h, h, g);
  set_face(h, f, g);
  set_halfedge(f, h, g);
  remove_face(f, g);
  get(CGAL::vertex_point, g);
};

template <class P>
concept PointContainer = std::ranges::random_access_range<P> && !FaceGraph<P> && !RowsOfPoints<P> &&
                         requires(P & points) {
  points.push_back(points[0]);
};

/// Points and triangles of which at least one is no container of such: see buffers.h.
template <class Points, class Triangles>
concept BufferedSoup = (RowsOfPoints<Points> &&
                        (RowsOfTriangles<Triangles> || TriangleContainer<Triangles>)) ||
                       (RowsOfTriangles<Triangles> && PointContainer<Points>);

/// Such a soup that is constant and does not refer to what is changed, as spans do.
template <class Points, class Triangles>
concept ConstantBuffers = BufferedSoup<Points, Triangles> &&
    !(is_changeable<const Points&> && is_changeable<const Triangles&>);

/// Fixes the vertices that are constrained, if any are.
template <class Reader, class Input, class NamedParameters>
void fix_vertices(Reader& reader, Input& input, const NamedParameters& named) {
  with_map<CGAL::internal_np::vertex_is_constrained_t>(named, [&](const auto& map) {
    reader.for_each_value(map, [&](Index v, const auto& is_fixed, std::size_t) {
      if (is_fixed)
        input.fix(v);
    });
  });
}

/// Reads how far vertices may move, if it is given. The least value of those at one place counts.
template <class Reader, class Input, class NamedParameters>
void limit_vertices(Reader& reader, Input& input, const NamedParameters& named) {
  with_map<parameters::vertex_tolerance_t>(named, [&](const auto& map) {
    reader.for_each_value(map, [&](Index v, const auto& tolerance, std::size_t vertex) {
      input.limit(v, static_cast<double>(tolerance), vertex);
    });
  });
}

/// Reads the importances of vertices, if they are given. The greatest value of those at one place
/// counts.
template <class Reader, class Input, class NamedParameters>
void weigh_vertices(Reader& reader, Input& input, const NamedParameters& named) {
  with_map<parameters::vertex_importance_t>(named, [&](const auto& map) {
    input.importances.assign(input.positions.size(), 0.0);
    reader.for_each_value(map, [&](Index v, double importance, std::size_t vertex) {
      require_importance(importance, vertex);
      input.importances[v] = (std::max)(input.importances[v], importance);
    });
  });
}

/// Keeps from being changed what is not selected, if faces are. They are in the order of the input.
template <class Faces, class Input, class NamedParameters>
void select_faces(const Faces& faces, Input& input, const NamedParameters& named) {
  with_map<parameters::face_is_selected_t>(named, [&](const auto& map) {
    for (const auto& face : faces) {
      input.is_selected.push_back(get(map, face));
      if (!input.is_selected.back())
        for (Index v : input.triangles[input.is_selected.size() - 1])
          input.fix(v);
    }
  });
}

/// Fixes the edges that are constrained, and makes creases of those that are named so.
template <class Cost, class Reader, class Input, class NamedParameters>
void name_edges(Reader& reader, Input& input, const NamedParameters& named) {
  using Creases = decltype(CGAL::parameters::get_parameter(named, parameters::edge_is_crease));
  static_assert(
      !is_given<Creases> || requires(const Cost cost) { cost.crease_degrees; },
      "quadrille::simplify: edge_is_crease_map needs a cost with creases: use Quadric");
  with_map<CGAL::internal_np::edge_is_constrained_t>(
      named, [&](const auto& map) { reader.fix_edges(map, input); });
  with_map<parameters::edge_is_crease_t>(named,
                                         [&](const auto& map) { reader.name_creases(map, input); });
}

/// Is what a map of points takes as doubles kept as floats? CGAL's map rounds to floats whatever it
/// writes into a mesh of OpenMesh, one of doubles as well, unless CGAL_USE_OM_POINTS is defined.
template <class Map, class Surface>
constexpr bool rounds_to_floats() {
  if constexpr (requires { typename Surface::Scalar; }) {
    if constexpr (std::same_as<typename Surface::Scalar, float>)
      return true;
#ifndef CGAL_USE_OM_POINTS
    else if constexpr (requires {
                         typename boost::property_map<Surface, CGAL::vertex_point_t>::type;
                       })
      return std::same_as<Map, typename boost::property_map<Surface, CGAL::vertex_point_t>::type>;
#endif
  }
  return false;
}

/// Are coordinates written as floats? They are if those of points are, or if a parameter says so.
template <class Map, class Surface, class Input, class NamedParameters>
void note_floats(Input& input, const NamedParameters& named) {
  using Point = typename boost::property_traits<Map>::value_type;
  const auto are_floats =
      CGAL::parameters::get_parameter(named, parameters::coordinates_are_floats_tag);
  input.writes_floats = has_float_coordinates<Point>() || rounds_to_floats<Map, Surface>();
  if constexpr (is_given<decltype(are_floats)>)
    input.writes_floats |= are_floats;
}

template <class Mesh, class Policies, class Carried, class NamedParameters>
Report simplify_mesh_with_maps(Mesh& mesh, const Policies& policies, const Carried& carried,
                               const NamedParameters& named) {
  using CGAL::parameters::choose_parameter, CGAL::parameters::get_parameter;
  using Cost = typename Policies::Cost;
  auto points = choose_parameter(get_parameter(named, CGAL::internal_np::vertex_point),
                                 CGAL::get_property_map(CGAL::vertex_point, mesh));
  check_points<typename boost::property_traits<decltype(points)>::value_type, NamedParameters>();
  auto indices = CGAL::get_initialized_vertex_index_map(mesh, named);
  auto attributes = pick_attributes<Cost>(named);
  Arena arena(memory_needs(policies, Carried::has_labels, num_vertices(mesh), num_faces(mesh)));
  auto channels = channel_maps(carried.channels);
  FaceGraphAdapter<Mesh, decltype(points), decltype(indices), decltype(attributes),
                   decltype(channels)>
      adapter(mesh, points, indices, attributes, arena, std::move(channels));
  const auto read = [&](auto& reader) {
    auto input = reader.read();
    note_floats<decltype(points), Mesh>(input, named);
    fix_vertices(reader, input, named);
    limit_vertices(reader, input, named);
    weigh_vertices(reader, input, named);
    select_faces(faces(mesh), input, named);
    name_edges<Cost>(reader, input, named);
    share_vertices(reader, input, named);
    name_boundaries(reader, input, named);
    give_named_box(input, named);
    read_labels(carried, faces(mesh), input, arena);
    reader.release();
    return input;
  };
  return run(adapter, policies, read, reporter(named));
}

template <class Mesh, class Policies, class Carried, class NamedParameters>
Report simplify_face_graph(Mesh& mesh, const Policies& policies, const Carried& carried,
                           const NamedParameters& named) {
  using Cost = typename Policies::Cost;
  static_assert(!Carried::splits_vertices,
                "quadrille::simplify: SplitVertices is for soups; a mesh has halfedges for maps.");
  namespace np = CGAL::internal_np;
  check_named<Cost, NamedParameters>(
      Names<np::vertex_point_t, np::vertex_index_t, np::halfedge_index_t, np::edge_index_t,
            np::face_index_t, np::face_patch_t, np::edge_is_constrained_t,
            parameters::edge_is_crease_t, parameters::edge_is_boundary_t,
            parameters::vertex_to_vertex_t, parameters::face_to_face_t,
            parameters::duplicate_output_t>());
  if constexpr (check_keys_of_mesh<Mesh, Cost, Carried, NamedParameters>())
    return simplify_mesh_with_maps(mesh, policies, carried, named);
  else
    return {};
}

/// The adapter of a soup, whose vertices may be split.
template <class Points, class Triangles, class Map, class Attributes, class Carried>
auto soup_adapter(Points& points, Triangles& triangles, Map map, Attributes attributes,
                  const Carried& carried, Arena& arena) {
  using Labels = typename Carried::Labels;
  auto channels = channel_maps(carried.channels);
  if constexpr (Carried::splits_vertices) {
    static_assert(
        Attributes::size == 0,
        "quadrille::simplify: SplitVertices needs a cost without attributes: pass attributes "
        "as channels.");
    return SplitSoupAdapter<Points, Triangles, Map, Labels, decltype(channels)>(
        points, triangles, map, carried.labels, std::move(channels), arena);
  } else {
    return SoupAdapter<Points, Triangles, Map, Attributes, Labels, decltype(channels)>(
        points, triangles, map, attributes, carried.labels, std::move(channels), arena);
  }
}

template <class Points, class Triangles, class Policies, class Carried, class NamedParameters>
Report simplify_soup_with_maps(Points& points, Triangles& triangles, const Policies& policies,
                               const Carried& carried, const NamedParameters& named) {
  using CGAL::parameters::choose_parameter, CGAL::parameters::get_parameter;
  using Cost = typename Policies::Cost;
  auto map = choose_parameter(get_parameter(named, CGAL::internal_np::point_map),
                              CGAL::Identity_property_map<ElementOf<Points>>());
  check_points<typename boost::property_traits<decltype(map)>::value_type, NamedParameters>();
  auto attributes = pick_attributes<Cost>(named);
  Arena arena(memory_needs(policies, Carried::has_labels, std::ranges::size(points),
                           std::ranges::size(triangles)));
  auto adapter = soup_adapter(points, triangles, map, attributes, carried, arena);
  const auto read = [&](auto& reader) {
    auto input = reader.read();
    note_floats<decltype(map), Points>(input, named);
    fix_vertices(reader, input, named);
    limit_vertices(reader, input, named);
    weigh_vertices(reader, input, named);
    const auto indices = boost::irange(std::size_t{0}, std::ranges::size(triangles));
    select_faces(indices, input, named);
    share_vertices(reader, input, named);
    list_boundaries(reader, std::ranges::size(points), input, named);
    give_named_box(input, named);
    read_labels(carried, indices, input, arena);
    return input;
  };
  return run(adapter, policies, read, reporter(named));
}

template <class Points, class Triangles, class Policies, class Carried, class NamedParameters>
Report simplify_soup(Points& points, Triangles& triangles, const Policies& policies,
                     const Carried& carried, const NamedParameters& named) {
  using CGAL::parameters::get_parameter;
  using Cost = typename Policies::Cost;
  const auto fixed_edges = get_parameter(named, CGAL::internal_np::edge_is_constrained);
  const auto creases = get_parameter(named, parameters::edge_is_crease);
  const auto boundaries = get_parameter(named, parameters::edge_is_boundary);
  static_assert(!is_given<decltype(fixed_edges)> && !is_given<decltype(creases)> &&
                    !is_given<decltype(boundaries)>,
                "quadrille::simplify: a soup has no edges for a map: pass "
                "vertex_is_constrained_map, or simplify a mesh; for borders pass boundary_edges");
  namespace np = CGAL::internal_np;
  check_named<Cost, NamedParameters>(
      Names<np::point_t, np::face_patch_t, np::edge_is_constrained_t, parameters::edge_is_crease_t,
            parameters::edge_is_boundary_t, parameters::boundary_edges_t,
            parameters::vertex_to_vertex_t, parameters::face_to_face_t>());
  if constexpr (check_keys_of_soup<Cost, Carried, NamedParameters>())
    return simplify_soup_with_maps(points, triangles, policies, carried, named);
  else
    return {};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_MESHES_H
