#ifndef QUADRILLE_INTERNAL_CORE_CALL_CHUNK_PARAMETERS_H
#define QUADRILLE_INTERNAL_CORE_CALL_CHUNK_PARAMETERS_H

#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The named parameters of a chunk of a surface: see vertex_is_shared_map.

namespace quadrille::internal {

/// Fixes the vertices that other chunks have as well, if there are any.
template <class Reader, class Input, class NamedParameters>
void share_vertices(Reader& reader, Input& input, const NamedParameters& named) {
  with_map<parameters::vertex_is_shared_t>(named, [&](const auto& map) {
    reader.for_each_value(map, [&](Index v, const auto& is_shared, std::size_t) {
      if (is_shared)
        input.share(v);
    });
  });
}

/// Marks the boundary edges of a mesh between vertices that are shared.
template <class Reader, class Input, class NamedParameters>
void name_boundaries(Reader& reader, Input& input, const NamedParameters& named) {
  with_map<parameters::edge_is_boundary_t>(named, [&](const auto& map) {
    auto creases = std::exchange(input.creases, {});
    reader.name_creases(map, input);
    input.boundaries = std::exchange(input.creases, std::move(creases));
  });
}

/// Reads the edges of a soup of that many points. Throws std::invalid_argument for an edge of a
/// point that does not exist.
template <class Reader, class Input, class NamedParameters>
void list_boundaries(const Reader& reader, std::size_t points, Input& input,
                     const NamedParameters& named) {
  const auto boundaries = CGAL::parameters::get_parameter(named, parameters::boundary_edges_tag);
  if constexpr (is_given<decltype(boundaries)>) {
    for (const auto& edge : boundaries) {
      for (std::size_t i = 0; i < 2; ++i)
        if (std::cmp_greater_equal(edge[i], points) || std::cmp_less(edge[i], 0))
          throw std::invalid_argument("quadrille::simplify: edge " +
                                      std::to_string(input.boundaries.size()) +
                                      " of boundary_edges refers to point " +
                                      std::to_string(edge[i]) + " of " + std::to_string(points));
      input.boundaries.push_back({reader.vertex_of(static_cast<std::size_t>(edge[0])),
                                  reader.vertex_of(static_cast<std::size_t>(edge[1]))});
    }
  }
}

/// Reads a box in space, to which the attributes of the surface are added.
template <class Input>
void give_box(const CGAL::Bbox_3& box, Input& input) {
  input.given_box = input.box();
  for (int i = 0; i < 3; ++i) {
    input.given_box->low[static_cast<std::size_t>(i)] = (box.min)(i);
    input.given_box->high[static_cast<std::size_t>(i)] = (box.max)(i);
  }
}

/// The box of the units, if one is given.
template <class Input, class NamedParameters>
void give_named_box(Input& input, const NamedParameters& named) {
  const auto box = CGAL::parameters::get_parameter(named, parameters::bounding_box_tag);
  if constexpr (is_given<decltype(box)>)
    if_given(box, [&](const auto& given) { give_box(given, input); });
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_CHUNK_PARAMETERS_H
