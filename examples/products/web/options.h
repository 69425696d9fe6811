#ifndef QUADRILLE_EXAMPLES_WEB_OPTIONS_H
#define QUADRILLE_EXAMPLES_WEB_OPTIONS_H

#include <quadrille/compiled.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace quadrille_examples {

/// A value of an enumeration by its name.
template <class Enum>
struct Named {
  std::string_view name;
  Enum value;
};

using Options = quadrille::SoupOptions;

inline constexpr std::array<Named<Options::Cost>, 4> costs{
    {{"quadric", Options::Cost::quadric},
     {"memoryless_quadric", Options::Cost::memoryless_quadric},
     {"thin_feature_quadric", Options::Cost::thin_feature_quadric},
     {"edge_length", Options::Cost::edge_length}}};
inline constexpr std::array<Named<Options::Placement>, 3> placements{
    {{"optimal", Options::Placement::optimal},
     {"endpoint", Options::Placement::endpoint},
     {"midpoint", Options::Placement::midpoint}}};
inline constexpr std::array<Named<Options::Order>, 2> orders{
    {{"greedy", Options::Order::greedy}, {"relaxed", Options::Order::relaxed}}};
inline constexpr std::array<Named<quadrille::Topology>, 3> topologies{
    {{"kept", quadrille::Topology::kept},
     {"free", quadrille::Topology::free},
     {"components_may_vanish", quadrille::Topology::components_may_vanish}}};
inline constexpr std::array<Named<quadrille::Weighting>, 3> weightings{
    {{"by_area", quadrille::Weighting::by_area},
     {"uniform", quadrille::Weighting::uniform},
     {"by_squared_area", quadrille::Weighting::by_squared_area}}};
inline constexpr std::array<Named<quadrille::SoupChannelView::Kind>, 4> kinds{
    {{"texture", quadrille::SoupChannelView::Kind::texture},
     {"normals", quadrille::SoupChannelView::Kind::normals},
     {"colors", quadrille::SoupChannelView::Kind::colors},
     {"attributes", quadrille::SoupChannelView::Kind::attributes}}};
inline constexpr std::array<Named<quadrille::Seams>, 4> all_seams{
    {{"kept", quadrille::Seams::kept},
     {"soft", quadrille::Seams::soft},
     {"priced", quadrille::Seams::priced},
     {"free", quadrille::Seams::free}}};
inline constexpr std::array<Named<quadrille::NewValues>, 4> all_new_values{
    {{"optimal", quadrille::NewValues::optimal},
     {"weights", quadrille::NewValues::weights},
     {"existing", quadrille::NewValues::existing},
     {"recomputed", quadrille::NewValues::recomputed}}};

/// The value of that name. Throws std::invalid_argument, which tells all names, if there is none.
template <class Enum, std::size_t n>
Enum chosen(const std::array<Named<Enum>, n>& choices, std::string_view option,
            std::string_view name) {
  std::string names;
  for (const Named<Enum>& choice : choices) {
    if (choice.name == name)
      return choice.value;
    names += (names.empty() ? "" : ", ") + std::string(choice.name);
  }
  throw std::invalid_argument(std::string(option) + " is \"" + std::string(name) +
                              "\", which is not one of " + names);
}

[[noreturn]] inline void reject_option(std::string_view name) {
  throw std::invalid_argument("there is no option " + std::string(name));
}

/// Sets a field that is or holds a number or a boolean.
template <class Field>
void set_field(Field& field, double value) {
  if constexpr (requires { field.emplace(); })
    set_field(field.emplace(), value);
  else if constexpr (std::is_same_v<Field, bool>)
    field = value != 0;
  else
    field = static_cast<Field>(value);
}

/// A number or a boolean of the options, by the name of its field.
inline void set_number(Options& options, std::string_view name, double value) {
  const auto set = [&](std::string_view field_name, auto Options::*field) {
    if (field_name == name)
      set_field(options.*field, value);
    return field_name == name;
  };
  const bool is_known =
      set("faces", &Options::faces) || set("ratio", &Options::ratio) ||
      set("vertices", &Options::vertices) || set("error", &Options::error) ||
      set("relative_error", &Options::relative_error) || set("both_ways", &Options::both_ways) ||
      set("cost_limit", &Options::cost_limit) ||
      set("boundary_weight", &Options::boundary_weight) ||
      set("crease_weight", &Options::crease_weight) ||
      set("crease_degrees", &Options::crease_degrees) ||
      set("line_weight", &Options::line_weight) || set("normal_noise", &Options::normal_noise) ||
      set("position_noise", &Options::position_noise) ||
      set("pairs_closer_than", &Options::pairs_closer_than) ||
      set("normal_flip", &Options::normal_flip) ||
      set("normal_deviation", &Options::normal_deviation) ||
      set("no_self_intersection", &Options::no_self_intersection) ||
      set("keep_solid", &Options::keep_solid) || set("manifold", &Options::manifold) ||
      set("simplified_topology", &Options::simplified_topology) ||
      set("region_boundary_weight", &Options::region_boundary_weight) ||
      set("split_vertices", &Options::split_vertices) || set("share", &Options::share) ||
      set("refresh", &Options::refresh);
  if (!is_known)
    reject_option(name);
}

/// A choice by name.
inline void set_choice(Options& options, std::string_view name, std::string_view value) {
  if (name == "cost")
    options.cost = chosen(costs, name, value);
  else if (name == "placement")
    options.placement = chosen(placements, name, value);
  else if (name == "order")
    options.order = chosen(orders, name, value);
  else if (name == "topology")
    options.topology = chosen(topologies, name, value);
  else if (name == "weighting")
    options.weighting = chosen(weightings, name, value);
  else
    reject_option(name);
}

/// The same of a channel. `weights` are set one by one.
inline void set_number(quadrille::ChannelOptions& options, std::string_view name, double value) {
  if (name == "importance")
    options.importance = value;
  else if (name == "weights")
    options.weights.push_back(value);
  else if (name == "chart_boundary_weight")
    options.chart_boundary_weight = value;
  else if (name == "linear_light")
    options.linear_light = value != 0;
  else
    reject_option(name);
}
inline void set_choice(quadrille::ChannelOptions& options, std::string_view name,
                       std::string_view value) {
  if (name == "seams")
    options.seams = chosen(all_seams, name, value);
  else if (name == "new_values")
    options.new_values = chosen(all_new_values, name, value);
  else
    reject_option(name);
}

} // namespace quadrille_examples

#endif
