// A Hausdorff limit keeps its word: the result lies within it of the input, and the input of the
// result, measured apart by CGAL.
#include "farthest.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/bounded_hausdorff.h>
#include <quadrille/channel_options.h>
#include <quadrille/channels.h>
#include <quadrille/distance.h>
#include <quadrille/distance_limits.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/IO/Color.h>
#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::read_model;

constexpr double infinity = std::numeric_limits<double>::infinity();

double farthest(const test::Soup& from, const test::Soup& to) {
  return test::farthest(from, to, from.triangles.size() > 500 ? 3 : 6);
}

struct Within {
  Report report;
  test::Soup result;
};

template <class... Arguments>
Within simplified(const test::Soup& input, const Arguments&... arguments) {
  test::PointSoup soup(input);
  const Report report =
      simplify<Quadric, OptimalPlacement>(soup.points, soup.triangles, arguments...);
  return {report, test::to_soup(soup)};
}

// Holds that the report says no less than is measured, either way.
void check_bounds(const test::Soup& input, const Within& outcome) {
  INFO(outcome.report);
  const double own = 0x1p-50 * test::greatest_coordinate(input); // roundings of what is measured
  CHECK(outcome.report.hausdorff_bound >= outcome.report.distance_bound);
  CHECK(farthest(outcome.result, input) <= outcome.report.distance_bound + own);
  CHECK(farthest(input, outcome.result) <= outcome.report.hausdorff_bound + own);
}

// Simplifies a soup within a limit, and holds that it is.
template <class... Arguments>
Within simplify_within(double limit, const test::Soup& input, const Arguments&... arguments) {
  const Within outcome = simplified(input, HausdorffLimit{limit}, arguments...);
  INFO("limit " << limit);
  CHECK(outcome.report.hausdorff_bound <=
        std::max(limit, 0x1p-40 * test::greatest_coordinate(input)));
  check_bounds(input, outcome);
  return outcome;
}

// Sheets that have one edge line in common.
test::Soup sheets_at_a_line(std::uint32_t count) {
  test::Soup soup;
  const std::uint32_t n = 6;
  for (std::uint32_t j = 0; j <= n; ++j)
    soup.points.push_back({{0, 0, double(j) / n}});
  for (std::uint32_t k = 0; k < count; ++k) {
    const double angle = 0.3 + 2 * std::numbers::pi * k / count;
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return i == 0 ? j : first + (i - 1) * (n + 1) + j;
    };
    for (std::uint32_t i = 1; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        soup.points.push_back({{std::cos(angle) * i / n, std::sin(angle) * i / n, double(j) / n}});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return soup;
}

test::Soup bent_sheet(double degrees) {
  const double turn = (180 - degrees) * std::numbers::pi / 180;
  return test::mapped(test::grid(12, 12), [&](const test::Position& p) {
    const double beyond = std::max(0.0, p[0] - 0.5);
    return test::Position{{p[0] - beyond + beyond * std::cos(turn), p[1], beyond * std::sin(turn)}};
  });
}

// A flat sheet with a needle on it, far thinner than it is high.
test::Soup sheet_with_sliver(double width, double height) {
  test::Soup soup = test::mapped(test::grid(6, 6), [](const test::Position& p) {
    return test::Position{{p[0] - 0.5, p[1] - 0.5, 0}};
  });
  for (test::Position& p : soup.points)
    if (p[0] * p[0] + p[1] * p[1] < 1e-6)
      p[2] = height;
    else if (std::abs(p[0]) < 0.2 && std::abs(p[1]) < 0.2)
      p = (width / 0.2) * p;
  return soup;
}

test::Soup far_away(const test::Soup& soup) {
  return test::mapped(test::tilted(soup), [](const test::Position& p) {
    return p + test::Position{{1000, -400, 300}};
  });
}

std::vector<test::Soup> small_surfaces(std::uint64_t seed) {
  return {test::with_noise(test::sphere(1), seed, 0.2),
          test::with_noise(test::octahedron(), seed, 0.3),
          test::with_noise(test::grid(4, 4), seed, 0.1),
          test::with_noise(test::grid(3, 1), seed, 0.2),
          test::with_noise(test::open_cylinder(6, 3), seed, 0.1),
          test::with_noise(test::cube(2), seed, 0.1),
          test::with_noise(sheets_at_a_line(3), seed, 0.05)};
}

} // namespace

TEST_CASE("Each contraction is within what it adds") {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (const test::Soup& input : small_surfaces(seed))
      for (std::size_t faces = input.triangles.size(); faces-- > 2;) {
        INFO("seed " << seed << ", " << input.triangles.size() << " to " << faces << " faces");
        const Within outcome =
            simplified(input, AnyOf{HausdorffLimit{10}, FaceCount{faces}}, Topology::kept);
        check_bounds(input, outcome);
        if (outcome.result.triangles.size() > faces)
          break; // no more can go
      }
}

TEST_CASE("Random surfaces are within the limit, whatever their topology") {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (double limit : {0.003, 0.03, 0.2}) {
      INFO("seed " << seed);
      const test::Soup holes = test::random_with_boundaries(seed);
      const test::Soup noisy = test::with_noise(test::sphere(3), seed, 0.05);
      const test::Soup pages = test::with_noise(sheets_at_a_line(5), seed, 0.02);
      for (const test::Soup& input : {holes, noisy, pages}) {
        simplify_within(limit, input);
        simplify_within(limit, input, RelaxedOrder{});
        simplify_within(limit, input, Topology::kept);
        simplify_within(limit, input, Topology::free);
        simplify_within(limit, input, Topology::free, RelaxedOrder{});
      }
    }
}

TEST_CASE("A Hausdorff limit leaves about as few faces as an error limit") {
  for (const char* name : {"cow", "elephant", "fandisk", "lion-head"})
    for (double fraction : {0.001, 0.01}) {
      Mesh one_way = read_model(name), both_ways = one_way;
      const Report a = simplify(one_way, DistanceLimit::relative(fraction));
      const Report b = simplify(both_ways, HausdorffLimit::relative(fraction));
      INFO(name << ": " << a << "; " << b);
      CHECK(b.contractions * 20 >= a.contractions * 19);
    }
}

TEST_CASE("What is exact costs nothing both ways") {
  for (double limit : {0.0, 1e-9, 1e-4, 0.01}) {
    INFO("limit " << limit);
    for (const test::Soup& sheet :
         {test::grid(16, 16), test::tilted(test::grid(16, 16)), far_away(test::grid(9, 14))})
      CHECK(simplify_within(limit, sheet, Topology::kept).report.faces_after == 2);
    for (const test::Soup& box : {test::cube(8), test::tilted(test::cube(8))})
      CHECK(simplify_within(limit, box, Topology::kept).report.faces_after == 12);
    for (std::uint32_t count : {3u, 5u})
      CHECK(simplify_within(limit, sheets_at_a_line(count), Topology::kept).report.faces_after ==
            2 * count);
    for (double degrees : {170.0, 90.0, 40.0, 15.0}) {
      CHECK(simplify_within(limit, bent_sheet(degrees), Topology::kept).report.faces_after == 4);
      CHECK(simplify_within(limit, far_away(bent_sheet(degrees)), Topology::kept)
                .report.faces_after == 4);
    }
  }
}

namespace {

using namespace quadrille::internal;

// The star of an edge of a surface, contracted to a place, with bounds of its faces of one's own.
class Star {
public:
  Star(const test::Soup& soup, Index a, Index b)
      : complex_(soup.points.size(), to_array<TriangleComplex::Triangle>(soup.triangles)),
        positions_(to_array<Vector<3>>(soup.points)), a_(a), b_(b) {
    star_.gather(complex_, a, b);
  }

  const Array<Vector<3>>& positions() const { return positions_; }
  std::vector<Index> faces() const {
    std::vector<Index> faces;
    star_.for_each_changed([&](const StarFace& f) { faces.push_back(f.face); });
    for (const StarFace& f : star_.shared)
      faces.push_back(f.face);
    return faces;
  }

  // How far input points may be then, if only those of one face were, by that much.
  double measure(const Vector<3>& x, Index face, float bound) {
    const auto never = [](double) { return false; };
    std::vector<float> bounds;
    StarDeviation deviation;
    DistanceBounds(complex_.face_capacity(), 1, true)
        .measure(star_, a_, b_, positions_, x, StarKind::oriented, {}, deviation, bounds, never);
    ReverseDeviation back;
    back.measure(
        star_, deviation, true, true, [&](Index f) { return f == face ? bound : 0; }, never);
    return static_cast<double>(*std::max_element(back.bounds().begin(), back.bounds().end()));
  }

  // How far points of an old face are from the new ones; never more than it is.
  double least_way(const Vector<3>& x, Index face) {
    const auto& [p, q, r] = complex_.vertices(face);
    const int steps = 12;
    double farthest = 0;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vector<3> y =
            1.0 / steps * (i * positions_[p] + j * positions_[q] + (steps - i - j) * positions_[r]);
        double nearest = infinity_;
        star_.for_each_changed([&](const StarFace& f) {
          nearest = std::min(nearest, squared_distance_to_triangle(y, x, positions_[f.second],
                                                                   positions_[f.third]));
        });
        farthest = std::max(farthest, nearest);
      }
    return std::sqrt(farthest);
  }

private:
  static constexpr double infinity_ = std::numeric_limits<double>::infinity();

  template <class T, class Range>
  static Array<T> to_array(const Range& range) {
    Array<T> array;
    for (const auto& e : range)
      array.push_back(T{{e[0], e[1], e[2]}});
    return array;
  }

  TriangleComplex complex_;
  Array<Vector<3>> positions_;
  PairStar star_;
  Index a_, b_;
};

} // namespace

TEST_CASE("Of each old face, input points are as far as they were, and as they go") {
  test::Random random(5);
  const auto part = [&] { return double(random.below(2001)) / 1000 - 1; };
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const test::Soup soup = test::with_noise(test::sphere(1), seed, seed % 3 == 0 ? 0.0 : 0.3);
    const Index a = soup.triangles[seed % 20][0], b = soup.triangles[seed % 20][1];
    Star star(soup, a, b);
    const Vector<3> middle = 0.5 * (star.positions()[a] + star.positions()[b]);
    for (const Vector<3>& x :
         {star.positions()[a], middle, middle + Vector<3>{{part(), part(), part()}}, 0.3 * middle,
          2.0 * middle})
      for (Index face : star.faces()) {
        INFO("seed " << seed << ", face " << face);
        const double way = star.least_way(x, face), bound = star.measure(x, face, 7);
        CHECK(bound >= 7 + way - 1e-12);
        CHECK(bound < 12);
      }
  }
}

TEST_CASE("A needle stays that an error limit takes away") {
  const test::Soup input = sheet_with_sliver(0.01, 1);
  const Within one_way = simplified(input, DistanceLimit{0.05});
  INFO(one_way.report);
  CHECK(one_way.report.hausdorff_bound == infinity);
  CHECK(farthest(input, one_way.result) > 0.9);
  const Within both_ways = simplify_within(0.05, input);
  CHECK(both_ways.report.faces_after < input.triangles.size() / 4);
  CHECK(both_ways.report.rejected(Rejection::distance) > 0);
}

TEST_CASE("A part that may vanish stays within a limit both ways, else the bound is infinite") {
  const test::Soup input =
      test::joined(test::sphere(3), test::mapped(test::sphere(1), [](const test::Position& p) {
                     return 0.001 * p + test::Position{{3, 0, 0}};
                   }));
  const Within stays = simplified(input, HausdorffLimit{0.1}, Topology::components_may_vanish);
  CHECK(stays.report.vanished_components == 0);
  CHECK(stays.report.hausdorff_bound <= 0.1);
  const Within goes = simplified(input, AllOf{HausdorffLimit{0.1}, FaceCount{200}},
                                 Topology::components_may_vanish);
  INFO(goes.report);
  CHECK(goes.report.vanished_components == 1);
  CHECK(goes.report.hausdorff_bound == infinity);
  CHECK(goes.report.distance_bound < infinity);
}

TEST_CASE("Faces that vanish with all their points are refused, or known to have") {
  test::Soup pieces = test::grid(4, 4);
  for (std::uint32_t i = 0; i < 20; ++i) // triangles that hang on nothing
    pieces = test::joined(pieces, test::triangle(), {{2.0 + 2 * i, 0, 0}});
  const Within within = simplify_within(0.8, pieces, Topology::free);
  CHECK(within.report.faces_after >= 20);
  const Within beyond =
      simplified(pieces, AllOf{HausdorffLimit{0.8}, FaceCount{4}}, Topology::free);
  INFO(beyond.report);
  CHECK(beyond.report.faces_after < 20);
  CHECK(beyond.report.hausdorff_bound == infinity);
}

TEST_CASE("Doubled faces leave their points to the one that is left") {
  // Two sheets, far apart but for their borders: contractions across make faces that coincide.
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const test::Soup bag =
        test::with_noise(test::mapped(test::sphere(2),
                                      [](const test::Position& p) {
                                        return test::Position{{p[0], p[1], 0.05 * p[2]}};
                                      }),
                         seed, 0.02);
    for (double limit : {0.05, 0.2, 0.6}) {
      INFO("seed " << seed);
      simplify_within(limit, bag, Topology::free);
      simplify_within(limit, bag, Topology::free, RelaxedOrder{});
    }
  }
}

TEST_CASE("Labels and channels go along within a limit of both ways") {
  const test::Soup input = test::with_noise(test::torus(30, 16), 2, 0.02);
  std::vector<int> labels;
  for (const auto& t : input.triangles)
    labels.push_back(input.points[t[0]][0] > 0);
  std::vector<CGAL::IO::Color> colors;
  for (const test::Position& p : input.points)
    colors.emplace_back(p[0] > 0 ? 250 : 10, static_cast<unsigned char>(100 + 20 * p[1]), 0);
  const auto run = [&](const auto& order) {
    test::PointSoup soup(input);
    std::vector<int> left = labels;
    const Report report =
        simplify(soup.points, soup.triangles, HausdorffLimit{0.05}, order,
                 Labels{CGAL::make_property_map(left)}, Colors{CGAL::make_property_map(colors)});
    check_bounds(input, {report, test::to_soup(soup)});
    CHECK(report.hausdorff_bound <= 0.05);
    CHECK(report.contractions > 200);
    CHECK(report.rejected(Rejection::distance) > 0);
  };
  const auto colors_of_input = colors;
  run(GreedyOrder{});
  colors = colors_of_input;
  run(RelaxedOrder{});
}

TEST_CASE("Only who asks is told of both ways") {
  const test::Soup input = test::sphere(3);
  CHECK(simplified(input, DistanceLimit{0.1}).report.hausdorff_bound == infinity);
  CHECK(simplified(input, FaceCount{100}).report.hausdorff_bound == infinity);
  const auto silent = [](const Status& status) { return HausdorffLimit{1e9}(status); };
  CHECK(simplified(input, silent).report.contractions == 0);
  const auto any = simplified(input, AnyOf{FaceCount{100}, HausdorffLimit{1}}).report;
  CHECK(any.faces_after == 100);
  CHECK(any.hausdorff_bound < 1);
  CHECK(simplified(input, AllOf{DistanceLimit{0.1}, HausdorffLimit{0.1}}).report.hausdorff_bound <
        infinity);
  test::PointSoup soup(input);
  for (double distance : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(simplify(soup.points, soup.triangles, HausdorffLimit{distance}),
                    std::invalid_argument);
    CHECK_THROWS_AS(simplify(soup.points, soup.triangles, HausdorffLimit::relative(distance)),
                    std::invalid_argument);
  }
}

TEST_CASE("A Hausdorff limit holds of floats as they are written, far from the origin") {
  // A step of floats is a five hundredth of the diagonal there.
  const test::Soup input = test::as_floats(
      test::mapped(test::with_noise(test::torus(24, 12), 3, 0.01), [](const test::Position& p) {
        return p + test::Position{{1e5, 1e5, 1e5}};
      }));
  for (const double limit : {0.004, 0.1}) {
    std::vector<std::array<float, 3>> points;
    for (const test::Position& p : input.points)
      points.push_back({float(p[0]), float(p[1]), float(p[2])});
    Within outcome{{}, {{}, input.triangles}};
    outcome.report = simplify(points, outcome.result.triangles, HausdorffLimit{limit});
    for (const auto& p : points)
      outcome.result.points.push_back({{double{p[0]}, double{p[1]}, double{p[2]}}});
    CHECK(outcome.report.hausdorff_bound <= limit);
    check_bounds(input, outcome);
  }
}

TEST_CASE("A Hausdorff limit does not depend on the unit") {
  const test::Soup input = test::with_noise(test::torus(30, 16), 3, 0.02);
  const auto scaled = [&](double unit) {
    return test::mapped(input, [&](const test::Position& p) { return unit * p; });
  };
  const Within plain = simplified(input, HausdorffLimit{0.05});
  const Within small = simplified(scaled(0x1p-30), HausdorffLimit{0.05 * 0x1p-30});
  CHECK(plain.report.faces_after == small.report.faces_after);
  CHECK(plain.report.hausdorff_bound == 0x1p30 * small.report.hausdorff_bound);
}

TEMPLATE_TEST_CASE("Models are within the limit both ways", "[hausdorff_limit]", GreedyOrder,
                   RelaxedOrder) {
  for (const char* name : {"cow", "bones", "nefertiti", "blobby_3cc", "pinion", "elephant"})
    for (double fraction : {0.002, 0.02}) {
      const Mesh input = read_model(name);
      const double limit = fraction * bounding_box_diagonal(input);
      Mesh mesh = input;
      const Report report = simplify(mesh, HausdorffLimit::relative(fraction), TestType{});
      mesh.collect_garbage();
      INFO(name << ": " << report);
      CHECK(report.hausdorff_bound <= limit);
      CHECK(report.contractions > 20);
      const double error = limit / 10; // of the measure
      CHECK(bounded_hausdorff(input, mesh, error) <= report.hausdorff_bound + error);
    }
}
