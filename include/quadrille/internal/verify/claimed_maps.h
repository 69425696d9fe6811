#ifndef QUADRILLE_INTERNAL_VERIFY_CLAIMED_MAPS_H
#define QUADRILLE_INTERNAL_VERIFY_CLAIMED_MAPS_H

#include <quadrille/parameters.h>
#include <quadrille/verdict.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace quadrille::internal {

template <class Map>
inline constexpr bool is_map_given =
    !std::same_as<std::remove_cvref_t<Map>, CGAL::internal_np::Param_not_found>;

/// Adds the vertex_tolerance_map, if it is given.
template <class Mesh, class NamedParameters>
void add_tolerances(const Mesh& input, const NamedParameters& named, Claims& claims) {
  const auto map = CGAL::parameters::get_parameter(named, parameters::vertex_tolerance);
  if constexpr (is_map_given<decltype(map)>) {
    claims.tolerances.clear();
    for (const auto v : vertices(input))
      claims.tolerances.push_back(static_cast<double>(get(map, v)));
  }
}

/// Adds the vertex_to_vertex_map, if it is given, as numbers.
template <class MeshA, class MeshB, class NamedParameters>
void add_vertex_map(const MeshA& input, const MeshB& result, const NamedParameters& named,
                    Claims& claims) {
  const auto map = CGAL::parameters::get_parameter(named, parameters::vertex_to_vertex);
  if constexpr (is_map_given<decltype(map)>) {
    const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), result);
    std::size_t count = 0;
    for (const auto v : vertices(result))
      put(number, v, count++);
    claims.vertex_map.clear();
    for (const auto v : vertices(input)) {
      const auto mapped = get(map, v);
      claims.vertex_map.push_back(mapped == boost::graph_traits<MeshB>::null_vertex()
                                      ? parameters::vanished
                                      : get(number, mapped));
    }
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CLAIMED_MAPS_H
