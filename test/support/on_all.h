#ifndef QUADRILLE_TEST_ON_ALL_H
#define QUADRILLE_TEST_ON_ALL_H

#include "mesh_types.h"
#include "properties.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

/// \file
/// Simplifies a soup as it is, or as any kind of mesh.

namespace test {

/// The attributes of a vertex, by its place.
template <std::size_t N>
std::array<double, N> attributes_at(const Position& p) {
  std::array<double, N> values;
  for (std::size_t i = 0; i < N; ++i)
    values[i] = 0.5 + 0.1 * p[i % 3] * p[(i + 1) % 3];
  return values;
}

template <class Cost>
constexpr quadrille::Attribute attribute_of() {
  if constexpr (requires { Cost::attribute; })
    return Cost::attribute;
  else
    return quadrille::Attribute::any;
}

template <class Cost, class Map>
auto named_attributes(const Map& map) {
  if constexpr (attribute_of<Cost>() == quadrille::Attribute::color)
    return CGAL::parameters::vertex_color_map(map);
  else if constexpr (attribute_of<Cost>() == quadrille::Attribute::texture)
    return CGAL::parameters::vertex_texture_map(map);
  else if constexpr (attribute_of<Cost>() == quadrille::Attribute::normal)
    return CGAL::parameters::vertex_normal_map(map);
  else
    return quadrille::parameters::vertex_attribute_map(map);
}

template <class M>
struct OnMesh {
  static constexpr bool is_mesh = true;

  template <class Cost, class... Policies>
  static Result run(const Soup& soup, const Cost& cost, const Policies&... policies) {
    constexpr std::size_t n = Cost::dimension - 3;
    M mesh = convert<M>(soup);
    Result result;
    if constexpr (n == 0) {
      result.report = quadrille::simplify(mesh, cost, policies...);
    } else {
      const auto points = get(CGAL::vertex_point, mesh);
      std::map<typename boost::graph_traits<M>::vertex_descriptor, std::array<double, n>> values;
      for (const auto v : vertices(mesh))
        values[v] = attributes_at<n>(to_position(get(points, v)));
      result.report = quadrille::simplify(
          mesh, cost, policies..., named_attributes<Cost>(boost::make_assoc_property_map(values)));
      for (const auto v : vertices(mesh))
        result.attributes.emplace_back(values.at(v).begin(), values.at(v).end());
    }
    CHECK(is_valid_triangle_mesh(mesh));
    result.soup = to_soup(mesh);
    return result;
  }
};

struct OnSoup {
  static constexpr bool is_mesh = false;

  template <class Cost, class... Policies>
  static Result run(const Soup& soup, const Cost& cost, const Policies&... policies) {
    constexpr std::size_t n = Cost::dimension - 3;
    std::vector<Point> points = points_of(soup);
    Result result;
    result.soup.triangles = soup.triangles;
    if constexpr (n == 0) {
      result.report = quadrille::simplify(points, result.soup.triangles, cost, policies...);
    } else {
      std::vector<std::array<double, n>> values;
      for (const auto& p : soup.points)
        values.push_back(attributes_at<n>(p));
      result.report = quadrille::simplify(
          points, result.soup.triangles, cost, policies...,
          named_attributes<Cost>(boost::make_iterator_property_map(
              values.begin(), boost::typed_identity_property_map<std::size_t>())));
      for (std::size_t i = 0; i < points.size(); ++i)
        result.attributes.emplace_back(values[i].begin(), values[i].end());
    }
    for (const auto& p : points)
      result.soup.points.push_back(to_position(p));
    return result;
  }
};

/// The faces of a soup, their corners as the first of the given places that is as good as there.
inline std::multiset<Triangle> faces_at(const std::vector<Position>& places, const Soup& soup) {
  const auto place_of = [&](std::uint32_t v) {
    const auto place = std::find_if(places.begin(), places.end(), [&](const auto& p) {
      return squared_distance(p, soup.points[v]) < 1e-10; // CGAL writes OpenMesh's points as floats
    });
    return static_cast<std::uint32_t>(place - places.begin());
  };
  std::multiset<Triangle> faces;
  for (const auto& [a, b, c] : soup.triangles)
    faces.insert(canonical({place_of(a), place_of(b), place_of(c)}));
  return faces;
}

inline bool is_place_of(const Soup& soup, const Position& p) {
  return std::find(soup.points.begin(), soup.points.end(), p) != soup.points.end();
}

/// Two closed surfaces, a little apart; in floats, which every kind of mesh can hold.
inline Soup two_parts(const Soup& a = random_closed(1), const Soup& b = random_closed(2)) {
  const auto highest_x = [](const Soup& soup, double sign) {
    double x = -1e300;
    for (const auto& p : soup.points)
      x = std::max(x, sign * p[0]);
    return x;
  };
  return as_floats(joined(a, b, {{highest_x(a, 1) + highest_x(b, -1) + 0.02, 0, 0}}));
}

} // namespace test

#endif // QUADRILLE_TEST_ON_ALL_H
