#ifndef QUADRILLE_INTERNAL_CORE_CALL_CARRIED_H
#define QUADRILLE_INTERNAL_CORE_CALL_CARRIED_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <concepts>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

/// The attributes that a call carries in addition to the shape: labels and channels.

namespace quadrille {
struct SplitVertices;
}

namespace quadrille::internal {

template <class T>
inline constexpr bool is_labels = false;
template <class Map>
inline constexpr bool is_labels<Labels<Map>> = true;
template <class Map>
inline constexpr bool is_labels<std::optional<Labels<Map>>> = true;

template <class T>
inline constexpr bool is_channel = false; // see <quadrille/channels.h>

/// The arguments of which is_wanted holds, as a tuple.
#define QUADRILLE_PICK(is_wanted)                                                                  \
  std::tuple_cat([](const auto& argument) {                                                        \
    if constexpr (is_wanted<std::remove_cvref_t<decltype(argument)>>)                              \
      return std::tuple(argument);                                                                 \
    else                                                                                           \
      return std::tuple();                                                                         \
  }(arguments)...)

/// The labels of a call: an argument, or the named parameter face_patch_map.
template <class... Arguments>
auto pick_labels(const Arguments&... arguments) {
  const auto patches =
      CGAL::parameters::get_parameter(pick_named(arguments...), CGAL::internal_np::face_patch);
  constexpr bool are_patches = is_given<decltype(patches)>;
  const auto labels = QUADRILLE_PICK(is_labels);
  constexpr auto count = std::tuple_size_v<std::remove_const_t<decltype(labels)>>;
  static_assert(
      count + are_patches <= 1,
      "simplify takes one map of face labels: pass either Labels{map} or face_patch_map.");
  if constexpr (count > 0)
    return std::get<0>(labels);
  else if constexpr (are_patches && IsOptional<decltype(patches)>)
    return patches ? std::optional(Labels{*patches}) : std::nullopt;
  else if constexpr (are_patches)
    return Labels{patches};
  else
    return NoLabels{};
}

/// Channels that are named parameters, as `of(named)` gives them: <quadrille/channels.h> defines
/// it.
template <class Named>
struct NamedChannels;
template <class Named>
concept AreChannelsIncluded = requires {
  sizeof(NamedChannels<Named>);
};

/// Are any attributes among the named parameters?
template <class Named, class... Tags>
constexpr bool names_any(Tags... tags) {
  return (is_given<decltype(CGAL::parameters::get_parameter(std::declval<const Named&>(), tags))> ||
          ...);
}

/// Attributes that are named parameters are channels with defaults for a cost in space; other costs
/// read them themselves.
template <class Cost, class Named>
auto named_channels([[maybe_unused]] const Named& named) {
  namespace np = CGAL::internal_np;
  if constexpr (Cost::dimension == 3 &&
                names_any<Named>(np::vertex_color_map, np::vertex_texture_map,
                                 np::vertex_normal_map, parameters::vertex_attribute)) {
    static_assert(
        AreChannelsIncluded<Named>,
        "vertex_color_map, vertex_texture_map, vertex_normal_map and vertex_attribute_map "
        "become channels if the cost has no attributes: include <quadrille/channels.h>.");
    if constexpr (AreChannelsIncluded<Named>)
      return NamedChannels<Named>::of(named);
    else
      return std::tuple();
  } else {
    return std::tuple();
  }
}

/// The channels of a call, as a tuple.
template <class Cost, class... Arguments>
auto pick_channels(const Arguments&... arguments) {
  static_assert(Cost::dimension == 3 || (!is_channel<Arguments> && ...),
                "This cost has its own attributes: channels (Texture, Normals, Colors, Attributes) "
                "need a cost without attributes, such as Quadric.");
  return std::tuple_cat(QUADRILLE_PICK(is_channel), named_channels<Cost>(pick_named(arguments...)));
}

#undef QUADRILLE_PICK

/// All that a call carries.
template <class Cost, class... Arguments>
auto pick_carried(const Arguments&... arguments) {
  const auto labels = pick_labels(arguments...);
  const auto channels = pick_channels<Cost>(arguments...);
  constexpr bool splits_vertices = (std::same_as<Arguments, SplitVertices> || ...);
  validate(labels);
  std::apply([](const auto&... channel) { (validate(channel), ...); }, channels);
  return Carried<std::remove_const_t<decltype(labels)>, std::remove_const_t<decltype(channels)>,
                 splits_vertices>{labels, channels};
}

/// The weight of boundaries between labels.
template <class Carried>
double region_boundary_weight([[maybe_unused]] const Carried& carried) {
  double weight = 1;
  if constexpr (Carried::has_labels)
    if_given(carried.labels, [&](const auto& labels) { weight = labels.region_boundary_weight; });
  return weight;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_CARRIED_H
