#ifndef QUADRILLE_INTERNAL_CORE_CALL_MAP_KEYS_H
#define QUADRILLE_INTERNAL_CORE_CALL_MAP_KEYS_H

#include <quadrille/internal/core/adapter/no_channel_maps.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace quadrille::internal {

/// Can a property map be asked for a key of that type, as far as it says what its keys are?
template <class Map, class Key>
inline constexpr bool takes_key = true;
template <class Map, class Key>
requires requires {
  typename Map::key_type;
}
inline constexpr bool takes_key<Map, Key> = std::convertible_to<Key, typename Map::key_type>;

/// Can all maps of these names be asked for such a key, that are given?
template <class Key, class NamedParameters, class... Tags>
constexpr bool take_key(Names<Tags...>) {
  return (takes_key<Contained<decltype(CGAL::parameters::get_parameter(
                        std::declval<const NamedParameters&>(), Tags{}))>,
                    Key> &&
          ...);
}

/// Rejects a call at compile time if a property map has other keys than those it is read with.
/// Returns whether the map fits, so that it is not read otherwise.
template <class Vertex, class Face, class Cost, class Carried, class NamedParameters>
constexpr bool check_keys() {
  namespace np = CGAL::internal_np;
  using OfVertices = Names<np::vertex_is_constrained_t, np::vertex_point_t, np::vertex_index_t,
                           decltype(attribute_name<Cost>()), parameters::vertex_tolerance_t,
                           parameters::vertex_importance_t, parameters::vertex_is_shared_t,
                           parameters::vertex_to_vertex_t, parameters::vertex_quadric_t>;
  using OfFaces =
      Names<parameters::face_is_selected_t, parameters::face_to_face_t, np::face_patch_t>;
  constexpr bool vertices_fit = take_key<Vertex, NamedParameters>(OfVertices());
  constexpr bool faces_fit = take_key<Face, NamedParameters>(OfFaces());
  constexpr bool labels_fit = [] {
    if constexpr (Carried::has_labels)
      return takes_key<decltype(Contained<typename Carried::Labels>::map), Face>;
    else
      return true;
  }();
  static_assert(vertices_fit,
                "A named parameter vertex_..._map has the wrong keys: they have to be the vertices "
                "of the mesh, or the indices of the points of a soup.");
  static_assert(faces_fit,
                "face_is_selected_map, face_to_face_map or face_patch_map has the wrong keys: they "
                "have to be the faces of the mesh, or the indices of the triangles of a soup.");
  static_assert(
      labels_fit,
      "The map of Labels has the wrong keys: they have to be the faces of the mesh, or the "
      "indices of the triangles of a soup.");
  return vertices_fit && faces_fit && labels_fit;
}

/// Does a channel have such keys? `takes` is called with an object of their type; a list of
/// channels that is known only at run time has none.
template <class Channel>
constexpr bool has_keys([[maybe_unused]] auto takes) {
  if constexpr (requires { typename Channel::Source; })
    return takes(std::type_identity<typename boost::property_traits<
                     typename MapOfSource<typename Channel::Source>::type>::key_type>());
  else
    return true;
}
template <class... Channel>
constexpr bool have_keys(const std::tuple<Channel...>*, [[maybe_unused]] auto takes) {
  return (has_keys<Channel>(takes) && ...);
}

template <class Mesh, class Cost, class Carried, class NamedParameters>
constexpr bool check_keys_of_mesh() {
  using Graph = boost::graph_traits<Mesh>;
  using Vertex = typename Graph::vertex_descriptor;
  using OfEdges = Names<CGAL::internal_np::edge_is_constrained_t, parameters::edge_is_crease_t,
                        parameters::edge_is_boundary_t>;
  constexpr bool others_fit =
      check_keys<Vertex, typename Graph::face_descriptor, Cost, Carried, NamedParameters>();
  constexpr bool edges_fit = take_key<typename Graph::edge_descriptor, NamedParameters>(OfEdges());
  static_assert(
      edges_fit,
      "A named parameter edge_..._map has the wrong keys: they have to be the edges of the "
      "mesh.");
  constexpr auto is_corner = []<class Key>(std::type_identity<Key>) {
    return std::same_as<Key, Vertex> || std::same_as<Key, typename Graph::halfedge_descriptor>;
  };
  constexpr bool channels_fit =
      have_keys(static_cast<typename Carried::Channels*>(nullptr), is_corner);
  static_assert(channels_fit,
                "The map of a channel has the wrong keys: for a mesh, Texture, Normals, Colors and "
                "Attributes take property maps over its vertices or halfedges.");
  return others_fit && edges_fit && channels_fit;
}

template <class Cost, class Carried, class NamedParameters>
constexpr bool check_keys_of_soup() {
  constexpr bool others_fit =
      check_keys<std::size_t, std::size_t, Cost, Carried, NamedParameters>();
  constexpr auto is_index = []<class Key>(std::type_identity<Key>) {
    return std::convertible_to<std::size_t, Key>;
  };
  constexpr bool channels_fit =
      have_keys(static_cast<typename Carried::Channels*>(nullptr), is_index);
  static_assert(channels_fit,
                "The map of a channel has the wrong keys: for a soup, Texture, Normals, Colors and "
                "Attributes take property maps over the indices of its points.");
  return others_fit && channels_fit;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_MAP_KEYS_H
