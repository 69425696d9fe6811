#ifndef QUADRILLE_INTERNAL_CORE_CALL_NAMED_PARAMETERS_H
#define QUADRILLE_INTERNAL_CORE_CALL_NAMED_PARAMETERS_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/adapter/attributes.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/version.h>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

/// CGAL's named parameters: which there are in a call, and which of them it reads.

namespace quadrille::internal {

template <class T>
struct IsNamedParameters : std::false_type {};
template <class T, class Tag, class Base>
struct IsNamedParameters<CGAL::Named_function_parameters<T, Tag, Base>> : std::true_type {};
template <class T, class Tag, class Base>
struct IsNamedParameters<parameters::Chain<T, Tag, Base>> : std::true_type {};

/// A chain of named parameters as CGAL has it.
template <class T, class Tag, class Base>
CGAL::Named_function_parameters<T, Tag, Base>
as_cgals(const CGAL::Named_function_parameters<T, Tag, Base>& named) {
  return named;
}

/// The named parameters of a call.
inline auto pick_named() {
  return CGAL::parameters::default_values();
}
template <class First, class... Rest>
auto pick_named(const First& first, const Rest&... rest) {
  if constexpr (IsNamedParameters<First>::value)
    return as_cgals(first);
  else
    return pick_named(rest...);
}

template <class Parameter>
inline constexpr bool is_given =
    !std::same_as<std::remove_cvref_t<Parameter>, CGAL::internal_np::Param_not_found>;

/// Calls use(map) with the property map of that name, if it is given. It may be a std::optional.
template <class Tag, class NamedParameters, class Use>
void with_map(const NamedParameters& named, Use use) {
  const auto map = CGAL::parameters::get_parameter(named, Tag{});
  if constexpr (is_given<decltype(map)>)
    if_given(map, use);
}

/// Names of parameters: their tags.
template <class... Tags>
struct Names {
  template <class Tag>
  static constexpr bool contains = (std::same_as<Tag, Tags> || ...);
};

template <class One, class Other>
struct JoinedNames;
template <class... Tags, class... Others>
struct JoinedNames<Names<Tags...>, Names<Others...>>
    : std::type_identity<Names<Tags..., Others...>> {};
template <class One, class Other>
using Joined = typename JoinedNames<One, Other>::type;

/// The named parameters of a chain that are not among those.
template <class NamedParameters, class Known, class... Found>
struct OthersThan : std::type_identity<Names<Found...>> {}; // at the end of the chain
template <class T, class Tag, class Base, class Known, class... Found>
struct OthersThan<CGAL::Named_function_parameters<T, Tag, Base>, Known, Found...>
    : std::conditional_t<Known::template contains<Tag>, OthersThan<Base, Known, Found...>,
                         OthersThan<Base, Known, Found..., Tag>> {};

template <class... Tags, class... Others>
constexpr bool have_in_common(Names<Tags...>, Names<Others...> others) {
  return (decltype(others)::template contains<Tags> || ...);
}

/// Which property the attributes of a cost are.
template <class Cost>
constexpr Attribute attribute_of() {
  if constexpr (requires { Cost::attribute; })
    return Cost::attribute;
  else
    return Attribute::any;
}

/// The name of the attributes that a cost reads; of none if it reads none.
template <class Cost>
auto attribute_name() {
  if constexpr (Cost::dimension == 3)
    return CGAL::internal_np::all_default_t{};
  else if constexpr (attribute_of<Cost>() == Attribute::color)
    return CGAL::internal_np::vertex_color_map_t{};
  else if constexpr (attribute_of<Cost>() == Attribute::texture)
    return CGAL::internal_np::vertex_texture_map_t{};
  else if constexpr (attribute_of<Cost>() == Attribute::normal)
    return CGAL::internal_np::vertex_normal_map_t{};
  else
    return parameters::vertex_attribute_t{};
}

/// The attributes that a cost looks at, in the property map that is their named parameter.
template <class Cost, class NamedParameters>
auto pick_attributes(const NamedParameters& named) {
  if constexpr (Cost::dimension == 3) {
    return NoAttributes{};
  } else {
    const auto map = CGAL::parameters::get_parameter(named, attribute_name<Cost>());
    using Map = std::remove_cvref_t<decltype(map)>;
    static_assert(
        is_given<Map>,
        "This cost needs attributes: pass their property map as a named parameter, "
        "vertex_color_map, vertex_texture_map or vertex_normal_map of CGAL::parameters, or "
        "vertex_attribute_map of quadrille::parameters.");
    return AttributeMap<Map, Cost::dimension - 3, attribute_of<Cost>()>(map);
  }
}

/// Rejects, at compile time, a call with points that cannot be read, or with geom_traits that are
/// not of them. Traits that are say nothing that the points do not: all is computed with their
/// coordinates as doubles.
template <class Point, class NamedParameters>
constexpr void check_points() {
  static_assert(
      ReadablePoint<Point>,
      "quadrille: a point has to be a point of a CGAL kernel, or three numbers by index "
      "such as std::array<double, 3>; for other types pass a property map to such points, "
      "point_map");
  using Traits = std::remove_cvref_t<decltype(CGAL::parameters::get_parameter(
      std::declval<const NamedParameters&>(), CGAL::internal_np::geom_traits))>;
  if constexpr (is_given<Traits>)
    static_assert(
        requires { requires std::same_as<typename Traits::Point_3, Point>; },
        "The points of this surface are not those of geom_traits: simplify computes with "
        "their coordinates as doubles, whatever the kernel; leave geom_traits out.");
}

#if CGAL_VERSION_NR >= 1060000000
using ConcurrencyTag = CGAL::internal_np::concurrency_tag_t;
#else
struct ConcurrencyTag {}; // there is none
#endif

/// Rejects, at compile time, a call with named parameters that are neither among `Read` nor read by
/// the cost nor harmless.
template <class Cost, class NamedParameters, class... Read>
constexpr void check_named(Names<Read...>) {
  namespace np = CGAL::internal_np;
  using Known =
      Names<np::all_default_t, np::geom_traits_t, np::visitor_t, np::vertex_is_constrained_t,
            parameters::vertex_quadric_t, parameters::face_is_selected_t,
            parameters::vertex_is_shared_t, parameters::bounding_box_t,
            parameters::coordinates_are_floats_t, parameters::vertex_importance_t,
            parameters::vertex_tolerance_t, decltype(attribute_name<Cost>()), Read...>;
  using Attributes = Names<np::vertex_color_map_t, np::vertex_texture_map_t,
                           np::vertex_normal_map_t, parameters::vertex_attribute_t>;
  // Attributes that a cost in space does not read are channels.
  constexpr auto attributes = std::conditional_t<Cost::dimension == 3, Names<>, Attributes>();
  constexpr typename OthersThan<
      NamedParameters,
      std::conditional_t<Cost::dimension == 3, Joined<Known, Attributes>, Known>>::type unread;
  constexpr Names<np::get_cost_policy_t, np::get_placement_policy_t, np::filter_t> cgals;
  constexpr bool are_attributes = have_in_common(unread, attributes);
  constexpr bool are_cgals = have_in_common(unread, cgals);
  constexpr bool is_concurrency = have_in_common(unread, Names<ConcurrencyTag>());
  static_assert(!are_attributes,
                "The cost of this call does not read these attributes: vertex_color_map goes with "
                "ColorQuadric, vertex_texture_map with TextureQuadric, vertex_normal_map with "
                "NormalQuadric and vertex_attribute_map with AttributeQuadric<N>.");
  static_assert(!are_cgals,
                "get_cost, get_placement and filter are for CGAL's own policies: pass policies of "
                "quadrille as arguments, as in simplify(mesh, Quadric{}, OptimalPlacement{}).");
  static_assert(!is_concurrency,
                "concurrency_tag has no effect: choose threads by RelaxedOrder{.threads = n}.");
  static_assert(
      are_attributes || are_cgals || is_concurrency ||
          std::same_as<decltype(unread), const Names<>>,
      "A named parameter of this call has no effect: <quadrille/simplify.h> lists the ones "
      "that simplify uses.");
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_NAMED_PARAMETERS_H
