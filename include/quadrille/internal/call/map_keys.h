#ifndef QUADRILLE_INTERNAL_CALL_MAP_KEYS_H
#define QUADRILLE_INTERNAL_CALL_MAP_KEYS_H

#include <quadrille/internal/call/named_parameters.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <boost/graph/graph_traits.hpp>

#include <concepts>
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
  return (takes_key<std::remove_cvref_t<decltype(CGAL::parameters::get_parameter(
                        std::declval<const NamedParameters&>(), Tags{}))>,
                    Key> &&
          ...);
}

/// Refuses to compile a call with a property map over something else than what it is read for.
template <class Vertex, class Face, class NamedParameters, class Labels>
constexpr void check_keys() {
  namespace np = CGAL::internal_np;
  using OfVertices = Names<np::vertex_is_constrained_t, parameters::vertex_tolerance_t,
                           parameters::vertex_importance_t, parameters::vertex_is_shared_t,
                           parameters::vertex_image_t, parameters::vertex_quadric_t>;
  static_assert(
      take_key<Vertex, NamedParameters>(OfVertices()),
      "A named parameter vertex_..._map is a map over something else: its keys have to be "
      "the vertices of the mesh, of a soup the indices of points.");
  static_assert(
      take_key<Face, NamedParameters>(Names<parameters::face_is_selected_t, np::face_patch_t>()),
      "face_is_selected_map or face_patch_map is a map over something else: its keys have to be "
      "the faces of the mesh, of a soup the indices of triangles.");
  if constexpr (!std::same_as<Labels, NoLabels>)
    static_assert(takes_key<decltype(Labels::map), Face>,
                  "The map of Labels is over something else: its keys have to be the faces of the "
                  "mesh, of a soup the indices of triangles.");
}

template <class Mesh, class NamedParameters, class Labels>
constexpr void check_keys_of_mesh() {
  using Graph = boost::graph_traits<Mesh>;
  check_keys<typename Graph::vertex_descriptor, typename Graph::face_descriptor, NamedParameters,
             Labels>();
  static_assert(take_key<typename Graph::edge_descriptor, NamedParameters>(
                    Names<CGAL::internal_np::edge_is_constrained_t, parameters::edge_is_crease_t,
                          parameters::edge_is_border_t>()),
                "A named parameter edge_..._map is a map over something else: its keys have to be "
                "the edges of the mesh.");
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CALL_MAP_KEYS_H
