// Sheets that are modelled with a back: two faces on the same vertices, the other way round.
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/channel_options.h>
#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/pairs.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/stop.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using Place = std::array<double, 3>;
using Value = std::array<double, 2>;

// A soup in containers that simplify takes.
template <class Number>
struct Sheet {
  std::vector<std::array<Number, 3>> points;
  std::vector<Triangle> triangles;
  std::vector<int> labels; // 0 in front, 1 on the back

  std::size_t count(int label) const {
    return static_cast<std::size_t>(std::count(labels.begin(), labels.end(), label));
  }
};

Triangle turned(const Triangle& t) {
  return {t[2], t[1], t[0]};
}

// A bumpy surface with backs where `has_back(middle)`; and if `interleaved`, each behind its front,
// or before it, by turns.
template <class Number = double, class HasReverse>
Sheet<Number> two_sided(const Soup& soup, HasReverse has_back, bool interleaved = false) {
  Sheet<Number> sheet;
  for (const Position& p : soup.points)
    sheet.points.push_back(
        {static_cast<Number>(p[0]), static_cast<Number>(p[1]), static_cast<Number>(p[2])});
  std::vector<Triangle> backs;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    const Position middle = (1.0 / 3) * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
    const bool is_doubled = has_back(middle);
    const bool is_reverse_first = interleaved && is_doubled && f % 3 == 0;
    if (is_reverse_first) {
      sheet.triangles.push_back(turned(t));
      sheet.labels.push_back(1);
    }
    sheet.triangles.push_back(t);
    sheet.labels.push_back(0);
    if (interleaved && is_doubled && !is_reverse_first) {
      sheet.triangles.push_back(turned(t));
      sheet.labels.push_back(1);
    } else if (!interleaved && is_doubled) {
      backs.push_back(turned(t));
    }
  }
  sheet.triangles.insert(sheet.triangles.end(), backs.begin(), backs.end());
  sheet.labels.resize(sheet.triangles.size(), 1);
  return sheet;
}

constexpr auto everywhere = [](const Position&) { return true; };
constexpr auto on_the_left = [](const Position& p) { return p[0] < 0.5; };

Soup bumps(std::uint32_t n = 24) {
  Soup soup = grid(n, n);
  for (Position& p : soup.points)
    p[2] = 0.1 * std::sin(9 * p[0]) * std::cos(7 * p[1]);
  return soup;
}

// A triangle that begins at its lowest corner: which way round it goes is left.
Triangle rotated(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// Of the faces on the same vertices as another one, turned round, how many? Fails if two run the
// same way.
template <class Number>
std::size_t count_sides(const Sheet<Number>& sheet) {
  std::set<Triangle> faces;
  for (const Triangle& t : sheet.triangles)
    REQUIRE(faces.insert(rotated(t)).second);
  return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](const Triangle& t) {
    return faces.contains(rotated(turned(t)));
  }));
}

// Does a face look up?
template <class Number>
double up(const Sheet<Number>& sheet, const Triangle& t) {
  const auto& a = sheet.points[t[0]];
  const auto& b = sheet.points[t[1]];
  const auto& c = sheet.points[t[2]];
  return static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

// Fronts look up, and backs down.
template <class Number>
bool is_wound_as_it_was(const Sheet<Number>& sheet) {
  for (std::size_t f = 0; f < sheet.triangles.size(); ++f)
    if ((up(sheet, sheet.triangles[f]) > 0) != (sheet.labels[f] == 0))
      return false;
  return true;
}

template <class Number, class... Arguments>
Report simplify_with_labels(Sheet<Number>& sheet, const Arguments&... arguments) {
  const Report report = simplify(sheet.points, sheet.triangles,
                                 Labels{CGAL::make_property_map(sheet.labels)}, arguments...);
  sheet.labels.resize(sheet.triangles.size());
  CAPTURE(report);
  REQUIRE(report.faces_after == sheet.triangles.size());
  REQUIRE(report.vertices_after == sheet.points.size());
  return report;
}

template <class Number>
void require_both_sides(FaceRatio ratio, auto... arguments) {
  for (const bool interleaved : {false, true}) {
    Sheet<Number> sheet = two_sided<Number>(bumps(), everywhere, interleaved);
    const std::size_t before = sheet.triangles.size();
    const Report report = simplify_with_labels(sheet, ratio, arguments...);
    CHECK(report.doubled_faces == 0);
    CHECK(report.counted_faces == before);
    CHECK(std::abs(double(sheet.triangles.size()) - ratio.ratio * double(before)) <=
          4); // a contraction takes four
    CHECK(sheet.count(0) == sheet.count(1));
    CHECK(count_sides(sheet) == sheet.triangles.size());
    CHECK(is_wound_as_it_was(sheet));
  }
}

} // namespace

TEST_CASE("Both sides of a sheet stay, with their labels and their way round") {
  for (const double ratio : {0.5, 0.1, 0.03}) {
    CAPTURE(ratio);
    require_both_sides<double>(FaceRatio{ratio});
    require_both_sides<float>(FaceRatio{ratio});
    require_both_sides<double>(FaceRatio{ratio}, Topology::free);
    require_both_sides<double>(FaceRatio{ratio}, RelaxedOrder{});
  }
}

TEST_CASE("Without labels both sides stay as well, as the front alone would be") {
  for (const double ratio : {0.5, 0.1, 0.03}) {
    Sheet<double> sheet = two_sided(bumps(), everywhere),
                  front = two_sided(bumps(), [](auto&) { return false; });
    const std::size_t faces = front.triangles.size();
    const auto left = static_cast<std::size_t>(std::llround(ratio * double(faces)));
    const Report report = simplify(sheet.points, sheet.triangles, FaceCount{2 * left});
    simplify(front.points, front.triangles, FaceCount{left});
    CHECK(report.faces_after == 2 * left);
    CHECK(sheet.points == front.points);
    CHECK(std::equal(front.triangles.begin(), front.triangles.end(), sheet.triangles.begin()));
    CHECK(count_sides(sheet) == sheet.triangles.size());
  }
}

TEST_CASE(
    "Where only a part has a back, no other face gets one, and the border between them stays") {
  for (const bool interleaved : {false, true})
    for (const double ratio : {0.5, 0.1, 0.03}) {
      CAPTURE(interleaved, ratio);
      Sheet<double> sheet = two_sided(bumps(), on_the_left, interleaved);
      sheet.labels.clear();
      simplify(sheet.points, sheet.triangles, FaceRatio{ratio});
      double area_of_forward_faces = 0, area_of_reverse_faces = 0;
      for (const Triangle& t : sheet.triangles)
        (up(sheet, t) > 0 ? area_of_forward_faces : area_of_reverse_faces) +=
            0.5 * std::abs(up(sheet, t));
      CHECK(count_sides(sheet) > 0);
      CHECK(area_of_forward_faces == Approx(1).margin(0.01));
      CHECK(area_of_reverse_faces == Approx(0.5).margin(0.01));
      for (const Triangle& t : sheet.triangles)
        if (up(sheet, t) < 0)
          for (std::uint32_t v : t)
            CHECK(sheet.points[v][0] < 0.52);
    }
}

TEST_CASE("Fronts run the same way round, in whatever order the faces come") {
  // Memoryless costs keep the volume below a sheet: faces that run against each other would not.
  const auto error_of = [](bool interleaved, auto has_back) {
    Sheet<double> sheet = two_sided(bumps(), has_back, interleaved);
    sheet.labels.clear();
    const Report report = simplify<MemorylessQuadric, OptimalPlacement>(
        sheet.points, sheet.triangles,
        [](const Status& status) { return status.contractions >= 500; }, NormalFlip{180});
    return report.error;
  };
  for (const auto& has_back : {+everywhere, +on_the_left})
    CHECK(error_of(true, has_back) == Approx(error_of(false, has_back)).epsilon(0.01));
}

TEST_CASE("A closed surface may have an inside") {
  const Soup ball = sphere(3);
  for (const double ratio : {0.5, 0.1, 0.03}) {
    Sheet<double> sheet = two_sided(ball, everywhere);
    const std::size_t before = sheet.triangles.size();
    const Report report = simplify_with_labels(sheet, FaceRatio{ratio});
    CHECK(std::abs(double(report.faces_after) - ratio * double(before)) <= 4);
    CHECK(sheet.count(0) == sheet.count(1));
    CHECK(count_sides(sheet) == sheet.triangles.size());
    CHECK(report.components_after == 1);
  }
}

TEST_CASE("Of three faces on the same vertices, one of the two that run the same way goes") {
  Sheet<double> sheet = two_sided(bumps(), everywhere);
  const std::size_t faces = sheet.triangles.size() / 2;
  for (std::size_t f = 0; f < faces; f += 2) {
    sheet.triangles.push_back(sheet.triangles[f]);
    sheet.labels.push_back(7);
  }
  const Report report = simplify_with_labels(sheet, FaceRatio{0.5});
  CHECK(report.faces_before == 2 * faces + faces / 2);
  CHECK(report.counted_faces == 2 * faces);
  CHECK(report.doubled_faces == faces / 2);
  CHECK(report.doubled_labels == faces / 2);
  CHECK(report.faces_after == faces);
  CHECK(sheet.count(0) == faces / 2);
  CHECK(sheet.count(1) == faces / 2);
  CHECK(sheet.count(7) == 0);
}

TEST_CASE("Faces doubled the same way round are counted, and no part of a share") {
  Sheet<double> sheet = two_sided(bumps(), [](auto&) { return false; });
  const std::size_t faces = sheet.triangles.size();
  for (std::size_t f = 0; f < faces / 2; ++f)
    sheet.triangles.push_back(sheet.triangles[f]);
  const Report report = simplify(sheet.points, sheet.triangles, FaceRatio{0.1});
  CHECK(report.doubled_faces == faces / 2);
  CHECK(report.counted_faces == faces);
  CHECK(report.faces_after == static_cast<std::size_t>(std::llround(0.1 * double(faces))));
}

TEST_CASE("A pair of faces alone is a sheet of two sides, and a manifold") {
  std::vector<Place> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Triangle> triangles{{0, 1, 2}, {1, 0, 2}};
  const Report report = simplify(points, triangles, FaceCount{1});
  CHECK(triangles == std::vector<Triangle>{{0, 1, 2}, {1, 0, 2}});
  CHECK(report.faces_after == 2);
  CHECK(report.non_manifold_edges == 0);
  CHECK(report.non_manifold_vertices == 0);
}

TEST_CASE("Edges inside of a sheet of two sides have four faces, and are reported as such") {
  Sheet<double> sheet = two_sided(bumps(3), everywhere);
  const Report report = simplify(sheet.points, sheet.triangles, FaceRatio{1});
  CHECK(report.non_manifold_edges == 2 * 3 * 2 + 9);
  CHECK(report.non_manifold_vertices == 16 - 2); // two corners have one face and its back
}

namespace {

// Values at corners: those of the back are others at the same place, and linear on each side.
struct CornerValues {
  std::vector<Value> values;
  std::vector<Triangle> triples;
};

Value value_at(const Place& p, bool is_reverse) {
  return is_reverse ? Value{3 - p[0], 2 + p[1]} : Value{p[0], p[1]};
}

template <class IsReverse>
CornerValues values_of(const Sheet<double>& sheet, IsReverse is_reverse) {
  CornerValues result;
  for (const bool back : {false, true})
    for (const Place& p : sheet.points)
      result.values.push_back(value_at(p, back));
  const auto n = static_cast<std::uint32_t>(sheet.points.size());
  for (std::size_t f = 0; f < sheet.triangles.size(); ++f) {
    Triangle t = sheet.triangles[f];
    if (is_reverse(f))
      for (std::uint32_t& v : t)
        v += n;
    result.triples.push_back(t);
  }
  return result;
}

template <class MakeChannel>
void require_values_of_sides(MakeChannel make_channel, auto... arguments) {
  for (const bool is_partial : {false, true})
    for (const double ratio : {0.5, 0.1, 0.03}) {
      CAPTURE(is_partial, ratio);
      Sheet<double> sheet =
          two_sided(bumps(), [&](const Position& p) { return !is_partial || p[0] < 0.5; });
      CornerValues corners = values_of(sheet, [&](std::size_t f) { return sheet.labels[f] == 1; });
      simplify(sheet.points, sheet.triangles, FaceRatio{ratio}, make_channel(corners),
               arguments...);
      REQUIRE(corners.triples.size() == sheet.triangles.size());
      REQUIRE(count_sides(sheet) > 0);
      for (std::size_t f = 0; f < sheet.triangles.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
          const Value expected =
              value_at(sheet.points[sheet.triangles[f][i]], up(sheet, sheet.triangles[f]) < 0);
          const Value is = corners.values[corners.triples[f][i]];
          CHECK(is[0] == Approx(expected[0]).margin(0.02));
          CHECK(is[1] == Approx(expected[1]).margin(0.02));
        }
    }
}

} // namespace

TEST_CASE("Texture coordinates and attributes of each side stay on their side") {
  const auto texture = [](CornerValues& c) { return Texture{c.values, c.triples}; };
  const auto attributes = [](CornerValues& c) { return Attributes{c.values, c.triples}; };
  require_values_of_sides(texture);
  require_values_of_sides(attributes);
  require_values_of_sides(texture, RelaxedOrder{});
  require_values_of_sides(attributes, Topology::free);
}

TEST_CASE("Points that are split between the sides are split again") {
  for (const double ratio : {0.5, 0.1, 0.03}) {
    Sheet<double> sheet = two_sided(bumps(), everywhere);
    const auto n = static_cast<std::uint32_t>(sheet.points.size());
    std::vector<Value> values;
    std::vector<Place> points;
    for (const bool back : {false, true})
      for (const Place& p : sheet.points) {
        points.push_back(p);
        values.push_back(value_at(p, back));
      }
    sheet.points = points;
    for (std::size_t f = 0; f < sheet.triangles.size(); ++f)
      for (std::uint32_t& v : sheet.triangles[f])
        v += sheet.labels[f] == 1 ? n : 0;
    const Report report = simplify(sheet.points, sheet.triangles, FaceRatio{ratio}, SplitVertices{},
                                   Attributes{CGAL::make_property_map(values)});
    CHECK(report.faces_after == sheet.triangles.size());
    std::set<std::array<Place, 3>> places;
    std::size_t ups = 0;
    for (const Triangle& t : sheet.triangles) {
      const bool is_reverse = up(sheet, t) < 0;
      ups += !is_reverse;
      std::array<Place, 3> at{sheet.points[t[0]], sheet.points[t[1]], sheet.points[t[2]]};
      for (std::uint32_t v : t)
        CHECK(values[v][0] == Approx(value_at(sheet.points[v], is_reverse)[0]).margin(0.02));
      std::sort(at.begin(), at.end());
      places.insert(at);
    }
    CHECK(2 * ups == sheet.triangles.size());
    CHECK(places.size() == ups);
  }
}

TEST_CASE("A cost that reads colours of points takes both sides along") {
  Sheet<double> sheet = two_sided(bumps(), everywhere);
  std::vector<Place> colors = sheet.points;
  simplify<ColorQuadric, OptimalPlacement>(
      sheet.points, sheet.triangles, FaceRatio{0.1},
      CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)));
  CHECK(count_sides(sheet) == sheet.triangles.size());
}

TEST_CASE("A limit of the error holds for both sides") {
  Sheet<double> sheet = two_sided(bumps(), everywhere),
                front = two_sided(bumps(), [](auto&) { return false; });
  const Report both = simplify_with_labels(sheet, DistanceLimit{0.01});
  const Report one = simplify_with_labels(front, DistanceLimit{0.01});
  CHECK(both.faces_after == 2 * one.faces_after);
  CHECK(both.distance_bound == one.distance_bound);
  CHECK(count_sides(sheet) == sheet.triangles.size());
}

TEST_CASE("A recording has both sides, with their values") {
  for (const bool is_partial : {false, true}) {
    CAPTURE(is_partial);
    Sheet<double> sheet =
        two_sided(bumps(), [&](const Position& p) { return !is_partial || p[0] < 0.5; });
    CornerValues corners = values_of(sheet, [&](std::size_t f) { return sheet.labels[f] == 1; });
    Levels levels;
    const Report report =
        simplify(sheet.points, sheet.triangles, FaceRatio{0.05},
                 Attributes{corners.values, corners.triples}, record_into(levels));
    CHECK(levels.at(FaceCount{0}).faces == report.faces_after);
    for (const std::size_t faces : {report.faces_after, 3 * report.faces_after}) {
      const Level level = levels.at(FaceCount{faces});
      CHECK(level.faces <= faces);
      CHECK(level.faces + 4 > faces);
      Sheet<double> at_level;
      for (std::size_t v = 0; v < level.vertices; ++v)
        at_level.points.push_back({level.points[v][0], level.points[v][1], level.points[v][2]});
      at_level.triangles.assign(level.triangles.begin(), level.triangles.end());
      CHECK((count_sides(at_level) == level.faces) == !is_partial);
      CHECK(count_sides(at_level) > 0);
      const LevelChannel& channel = level.channels.at(0);
      REQUIRE(channel.triangles.size() == level.faces);
      for (std::size_t f = 0; f < level.faces; ++f)
        for (std::size_t i = 0; i < 3; ++i) {
          const Value expected = value_at(at_level.points[level.triangles[f][i]],
                                          up(at_level, at_level.triangles[f]) < 0);
          const std::size_t at = 2 * channel.triangles[f][i];
          CHECK(channel.values.at(at) == Approx(expected[0]).margin(0.02));
          CHECK(channel.values.at(at + 1) == Approx(expected[1]).margin(0.02));
        }
    }
  }
}
