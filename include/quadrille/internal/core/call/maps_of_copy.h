#ifndef QUADRILLE_INTERNAL_CORE_CALL_MAPS_OF_COPY_H
#define QUADRILLE_INTERNAL_CORE_CALL_MAPS_OF_COPY_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <string>
#include <type_traits>

/// Arguments of `simplified` for the copy of a mesh: maps over the mesh become those of the copy.

namespace quadrille::internal {

/// Is it a property of such a mesh, as those of Surface_mesh are?
template <class Map, class Mesh>
concept PropertyOf = requires(Map map, const Mesh& mesh) {
  requires std::same_as<
      Map, typename Mesh::template Property_map<typename Map::key_type, typename Map::value_type>>;
  mesh.template properties<typename Map::key_type>();
  map.begin();
};

/// Are its vertices the same numbers in a copy?
template <class Mesh>
concept IndexedMesh = requires(typename boost::graph_traits<Mesh>::vertex_descriptor v) {
  v.idx();
};

/// A property of the mesh as that of the copy; of another mesh as it is.
template <class Map, class Mesh>
Map property_of_copy(Map map, const Mesh& mesh, Mesh& copy) {
  using Key = typename Map::key_type;
  const auto property = [](auto& owner, const std::string& name) {
    const auto found = owner.template property_map<Key, typename Map::value_type>(name);
    if constexpr (requires { found.second; })
      return found.second ? found.first : Map();
    else
      return found ? *found : Map(); // of CGAL 6
  };
  for (const std::string& name : mesh.template properties<Key>())
    if (Map of_mesh = property(mesh, name); of_mesh && of_mesh.begin() == map.begin())
      return property(copy, name);
  return map;
}

/// A map of the user's, if it is given, as one over the copy. Without state it is both.
template <bool is_written, class Map, class Mesh>
Map map_of_copy(const Map& map, [[maybe_unused]] const Mesh& mesh, [[maybe_unused]] Mesh& copy) {
  if constexpr (IsOptional<Map>) {
    return map ? Map(map_of_copy<is_written>(*map, mesh, copy)) : Map();
  } else if constexpr (PropertyOf<Map, Mesh>) {
    return property_of_copy(map, mesh, copy);
  } else {
    static_assert(
        std::is_empty_v<Map> || (IndexedMesh<Mesh> && !is_written),
        "quadrille::simplified: this map is over the mesh, but the copy has its own "
        "vertices, halfedges, edges and faces: copy the mesh and call simplify with a map "
        "over the copy.");
    return map;
  }
}

using ReadNames =
    Names<CGAL::internal_np::vertex_is_constrained_t, CGAL::internal_np::edge_is_constrained_t,
          CGAL::internal_np::face_patch_t, CGAL::internal_np::vertex_index_t,
          parameters::edge_is_crease_t, parameters::edge_is_boundary_t,
          parameters::face_is_selected_t, parameters::vertex_tolerance_t,
          parameters::vertex_importance_t, parameters::vertex_is_shared_t>;
using WrittenNames = Names<CGAL::internal_np::vertex_point_t, CGAL::internal_np::vertex_color_map_t,
                           CGAL::internal_np::vertex_texture_map_t,
                           CGAL::internal_np::vertex_normal_map_t, parameters::vertex_attribute_t>;
using NamesOfResult = Names<parameters::vertex_to_vertex_t, parameters::face_to_face_t,
                            parameters::vertex_quadric_t, parameters::duplicate_output_t>;

template <class Tag, class T, class Mesh>
T value_of_copy(const T& value, const Mesh& mesh, Mesh& copy) {
  static_assert(
      !NamesOfResult::contains<Tag>,
      "quadrille::simplified: vertex_to_vertex_map, face_to_face_map, vertex_quadric_map and "
      "duplicate_output_iterator refer to elements that are renumbered when garbage is "
      "collected from the copy: copy the mesh and call simplify.");
  if constexpr (ReadNames::contains<Tag> || WrittenNames::contains<Tag>)
    return map_of_copy<WrittenNames::contains<Tag>>(value, mesh, copy);
  else
    return value;
}

/// Named parameters: a chain of the same names.
template <class T, class Tag, class Base, class Mesh>
auto of_copy(const CGAL::Named_function_parameters<T, Tag, Base>& named, const Mesh& mesh,
             Mesh& copy) {
  if constexpr (!std::is_copy_constructible_v<T>)
    return named; // a visitor
  else if constexpr (std::same_as<Base, CGAL::internal_np::No_property>)
    return CGAL::Named_function_parameters<T, Tag>(value_of_copy<Tag>(named.v, mesh, copy));
  else {
    const auto before = of_copy(static_cast<const Base&>(named), mesh, copy);
    return CGAL::Named_function_parameters<T, Tag, std::remove_const_t<decltype(before)>>(
        value_of_copy<Tag>(named.v, mesh, copy), before);
  }
}
template <class T, class Tag, class Base, class Mesh>
auto of_copy(const parameters::Chain<T, Tag, Base>& named, const Mesh& mesh, Mesh& copy) {
  return of_copy(as_cgals(named), mesh, copy);
}
/// Channels, labels, policies.
template <class Argument, class Mesh>
Argument of_copy(Argument argument, const Mesh& mesh, Mesh& copy) {
  if constexpr (is_channel<Argument>)
    argument.source = map_of_copy<true>(argument.source, mesh, copy);
  else if constexpr (is_labels<Argument> && IsOptional<Argument>)
    return argument ? Argument(of_copy(*argument, mesh, copy)) : Argument();
  else if constexpr (is_labels<Argument>)
    argument.map = map_of_copy<false>(argument.map, mesh, copy);
  return argument;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_MAPS_OF_COPY_H
