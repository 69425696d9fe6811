#ifndef QUADRILLE_TEST_CASES_ENGINE_H
#define QUADRILLE_TEST_CASES_ENGINE_H

#include "cases.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/edge_length.h>
#include <quadrille/internal/core/policy/built_in_placement.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>

/// \file
/// simplify_soup and simplify_mesh: every combination of policies that a case may ask for. Each
/// cost is compiled by itself.

namespace test {

namespace detail {

// A built-in placement by its name: of all of them the engines in quadrille::compiled are made.
// Where a cost has no minimizer, the midpoint stands for it.
template <class Cost>
quadrille::internal::BuiltInPlacement placement_of(PlacementName name) {
  using Kind = quadrille::internal::BuiltInPlacement::Kind;
  if (name == PlacementName::endpoint)
    return quadrille::internal::BuiltInPlacement(Kind::endpoint);
  constexpr bool has_minimizer = !std::is_same_v<Cost, quadrille::EdgeLength>;
  return quadrille::internal::BuiltInPlacement(
      has_minimizer && name == PlacementName::optimal ? Kind::optimal : Kind::midpoint);
}

class CancelAt {
public:
  explicit CancelAt(std::size_t call) : call_(call) {}
  bool proceed(const quadrille::Status&) const { return ++calls_ < call_; }

private:
  std::size_t call_;
  mutable std::size_t calls_ = 0;
};

// Calls simplify(policy...) with the policies of a call.
template <class Cost, class Pairs, class Simplify>
quadrille::Report with_policies(const Call& call, const Pairs& pairs, Simplify simplify) {
  const auto with_order = [&](const auto& order) {
    return simplify(placement_of<Cost>(call.placement), pairs, call.stop, order, call.topology,
                    quadrille::NormalFlip(call.flip_degrees),
                    quadrille::SmallestAngle(call.smallest_angle),
                    quadrille::HighestDegree(call.degree));
  };
  return call.relaxed ? with_order(*call.relaxed) : with_order(quadrille::GreedyOrder{});
}

// The attributes that a cost looks at, if any.
template <class Cost, class Numbers, class Colors, class Parameters>
auto with_attributes(const Numbers& numbers, const Colors& colors, const Parameters& parameters) {
  if constexpr (std::is_same_v<Cost, quadrille::TextureQuadric>)
    return parameters.vertex_texture_map(numbers);
  else if constexpr (Cost::dimension == 6)
    return parameters.vertex_color_map(colors);
  else
    return parameters;
}

} // namespace detail

template <class Cost>
void simplify_soup(const Case& input, Outcome& outcome, const Cost& cost) {
  const auto is_fixed = boost::make_function_property_map<std::size_t>(
      [&](std::size_t v) -> bool { return input.is_fixed[v]; });
  const detail::CancelAt visitor(input.call.cancel_at);
  const auto named = detail::with_attributes<Cost>(
      CGAL::make_property_map(outcome.numbers), CGAL::make_property_map(outcome.colors),
      CGAL::parameters::vertex_is_constrained_map(is_fixed).visitor(visitor));
  const quadrille::ThresholdPairs pairs(input.call.threshold);
  outcome.report = detail::with_policies<Cost>(input.call, pairs, [&](const auto&... policy) {
    return quadrille::simplify(outcome.points, outcome.triangles, cost, policy..., named);
  });
}

template <class Cost>
void simplify_mesh(const Case& input, Outcome& outcome, const Cost& cost) {
  Mesh mesh = make_mesh(input.soup);
  auto colors = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("color").first;
  auto numbers = mesh.add_property_map<Mesh::Vertex_index, Numbers>("numbers").first;
  for (const auto v : mesh.vertices()) {
    colors[v] = input.colors[v];
    numbers[v] = input.numbers[v];
  }
  const auto is_fixed = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) -> bool { return input.is_fixed[v]; });
  const std::set<std::array<std::uint32_t, 2>> kept(input.kept.begin(), input.kept.end());
  const auto is_kept = boost::make_function_property_map<Mesh::Edge_index>([&](Mesh::Edge_index e) {
    const std::uint32_t v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    return kept.contains({std::min(v, w), std::max(v, w)});
  });
  const detail::CancelAt visitor(input.call.cancel_at);
  const auto named =
      detail::with_attributes<Cost>(numbers, colors,
                                    CGAL::parameters::vertex_is_constrained_map(is_fixed)
                                        .edge_is_constrained_map(is_kept)
                                        .visitor(visitor));
  const quadrille::ThresholdPairs pairs(input.call.threshold);
  outcome.report = detail::with_policies<Cost>(input.call, pairs, [&](const auto&... policy) {
    return quadrille::simplify(mesh, cost, policy..., named);
  });
  if (!is_valid_triangle_mesh(mesh))
    throw std::logic_error("the mesh is not valid");
  mesh.collect_garbage();
  outcome.points.clear();
  outcome.colors.clear();
  outcome.numbers.clear();
  for (const auto v : mesh.vertices()) {
    outcome.points.push_back(mesh.point(v));
    outcome.colors.push_back(colors[v]);
    outcome.numbers.push_back(numbers[v]);
  }
  outcome.triangles = to_soup(mesh).triangles;
}

} // namespace test

#endif // QUADRILLE_TEST_CASES_ENGINE_H
