// Policies of a user's speak the units of the mesh and of its attributes.
#include "meshes.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

// --- Ten lines each ------------------------------------------------------------------------------

struct NoLongEdge {
  double length;
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      for (const auto& end : {face.second, face.third})
        if (squared_distance(face.after, end) > length * length)
          return false;
    return true;
  }
};

struct OnGrid {
  double step;
  auto operator()(const auto& cost, const auto& pair) const {
    auto x = OptimalPlacement{}(cost, pair);
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = step * std::round(x[i] / step);
    return x;
  }
};

// Long edges are dear, whatever else they would cost.
struct ShortFirst : Quadric {
  double length;
  explicit ShortFirst(double l) : length(l) {}
  double operator()(const auto& pair, const Vector<3>& x) const {
    const bool is_short = squared_distance(pair.first, pair.second) < length * length;
    return is_short ? Quadric::operator()(pair, x) : std::numeric_limits<double>::max();
  }
  double squared_error(const auto& pair, double) const {
    return squared_distance(pair.first, pair.second);
  }
};

// --- What they are tried on ----------------------------------------------------------------------

Soup input(double scale) {
  Soup soup = with_noise(sphere(4), 1, 0.01);
  for (Position& p : soup.points)
    p *= scale;
  return soup;
}

struct Result {
  Soup soup;
  Report report;
};

template <class... Arguments>
Result on_mesh(const Soup& soup, const Arguments&... arguments) {
  Mesh mesh = make_mesh(soup);
  const Report report = simplify(mesh, arguments...);
  mesh.collect_garbage();
  return {to_soup(mesh), report};
}

template <class... Arguments>
Result on_soup(const Soup& soup, const Arguments&... arguments) {
  PointSoup points(soup);
  const Report report = simplify(points.points, points.triangles, arguments...);
  Result result{{{}, points.triangles}, report};
  for (const Point& p : points.points)
    result.soup.points.push_back(to_position(p));
  return result;
}

double longest_edge(const Soup& soup) {
  double longest = 0;
  for (const auto& [a, b, c] : soup.triangles)
    for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      longest = std::max(longest, squared_distance(soup.points[v], soup.points[w]));
  return std::sqrt(longest);
}

bool is_on_grid(const Position& p, double step) {
  return std::ranges::all_of(p.coordinates,
                             [&](double x) { return x == step * std::round(x / step); });
}

} // namespace

TEST_CASE("Policies of a user's speak the mesh's unit of length") {
  const double scale = GENERATE(1e-9, 1e-6, 1.0, 1e6, 1e9);
  CAPTURE(scale);
  const Soup soup = input(scale);
  const auto order = GENERATE(false, true);
  const auto run = [&](const auto&... arguments) {
    const bool is_soup = GENERATE(false, true);
    if (order)
      return is_soup ? on_soup(soup, arguments..., RelaxedOrder{})
                     : on_mesh(soup, arguments..., RelaxedOrder{});
    return is_soup ? on_soup(soup, arguments...) : on_mesh(soup, arguments...);
  };

  SECTION("a filter") {
    const double limit = 0.3 * scale;
    REQUIRE(longest_edge(soup) < limit);
    const auto [result, report] = run(NoLongEdge{limit}, FaceCount{4});
    CHECK(longest_edge(result) <= limit);
    CHECK(longest_edge(result) > 0.9 * limit);
    CHECK(report.stop == StopReason::all_pairs_rejected);
    CHECK(report.faces_after < report.faces_before / 2);
  }
  SECTION("a placement") {
    const double step = 0.01 * scale;
    const auto [result, report] = run(OnGrid{step}, FaceRatio{0.1});
    CHECK(report.contractions > 900);
    std::size_t moved = 0;
    for (const Position& p : result.points)
      moved += is_on_grid(p, step);
    CHECK(10 * moved > 9 * result.points.size());
  }
  SECTION("a cost") {
    const double limit = 0.2 * scale;
    const auto stop = [&](const Status& status) { return status.next_error >= limit; };
    const auto [result, report] = run(ShortFirst(limit), stop);
    CHECK(report.error < limit);
    CHECK(report.error > 0.9 * limit);
    CHECK(report.contractions > 700);
  }
}

// --- Attributes ----------------------------------------------------------------------------------

namespace {

using ColorValues = std::vector<std::array<double, 3>>;

ColorValues colors_of(const Soup& soup, double scale) {
  ColorValues colors;
  for (const Position& p : soup.points)
    colors.push_back({0.5 + 0.4 * p[0] / scale, 0.5, 0.3});
  return colors;
}

struct DarkOnly {
  bool* has_looked;
  bool allows(const auto& contraction) const {
    *has_looked = true;
    return contraction.target()[3] <= 0.6;
  }
};

struct RoundedColor {
  auto operator()(const auto& cost, const auto& pair) const {
    auto x = *cost.minimizer(pair);
    x[3] = std::round(x[3] * 10) / 10;
    return x;
  }
};

// Equal values only; remembers the greatest, in the mesh's units.
struct SameValue {
  static constexpr std::size_t dimension = 4;
  struct State {
    double greatest = 0;
    void operator+=(const State& other) { greatest = std::max(greatest, other.greatest); }
  };
  State face(const Vector<4>& p, const Vector<4>&, const Vector<4>&) const { return {p[3]}; }
  double operator()(const auto& pair, const Vector<4>& x) const {
    return squared_distance(pair.first, pair.second) + (pair.state.greatest > 10 ? 1e20 : 0) +
           (x[3] > 10 ? 1e20 : 0);
  }
};

} // namespace

TEST_CASE("Policies of a user's speak the units of attributes") {
  const double scale = GENERATE(1e-6, 1.0, 1e6);
  CAPTURE(scale);
  const Soup soup = input(scale);
  ColorValues colors = colors_of(soup, scale);
  const auto map = CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors));
  PointSoup points(soup);

  SECTION("a filter") {
    bool has_looked = false;
    simplify(points.points, points.triangles, ColorQuadric{}, FaceRatio{0.1}, map,
             DarkOnly{&has_looked});
    CHECK(has_looked);
    CHECK(points.points.size() < soup.points.size() * 3 / 4);
    const PointSoup before(soup);
    for (std::size_t i = 0; i < points.points.size(); ++i)
      CHECK((colors[i][0] <= 0.6 + 1e-12 || // else it has not moved
             std::ranges::count(before.points, points.points[i]) > 0));
  }
  SECTION("a placement") {
    const Report report = simplify(points.points, points.triangles, ColorQuadric{}, FaceRatio{0.1},
                                   map, RoundedColor{});
    CHECK(report.contractions > 900);
    std::size_t rounded = 0;
    for (std::size_t i = 0; i < points.points.size(); ++i)
      rounded += std::abs(colors[i][0] * 10 - std::round(colors[i][0] * 10)) < 1e-9;
    CHECK(10 * rounded > 9 * points.points.size());
  }
  SECTION("a placement that stays at an end keeps all bits there") {
    const auto at_first = [](const auto&, const auto& pair) { return pair.first; };
    const auto before = colors;
    AttributeQuadric<3> cost; // its weights are no powers of two, so weighing rounds
    cost.weights = Vector<3>{{0.3 * scale, 0.7 * scale, 1.1 * scale}};
    simplify(points.points, points.triangles, cost, FaceRatio{0.1}, at_first,
             quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(colors)));
    for (std::size_t i = 0; i < points.points.size(); ++i)
      CHECK(std::ranges::count(before, colors[i]) > 0);
  }
  SECTION("a cost") {
    std::vector<double> values;
    for (const Position& p : soup.points)
      values.push_back(p[0] > 0 ? 11 : 9);
    const Report report = simplify(
        points.points, points.triangles, SameValue{}, MidpointPlacement{},
        [&](const Status& status) { return status.next_error > 1e9; },
        quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(values)));
    CHECK(report.stop == StopReason::target_met);
    CHECK(report.contractions > 100);
    CHECK(std::ranges::count(values.begin(), values.begin() + std::ptrdiff_t(points.points.size()),
                             11.0) ==
          std::ranges::count_if(soup.points, [](const Position& p) { return p[0] > 0; }));
  }
}
