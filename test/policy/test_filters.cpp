// Each filter lets pass what it says, at its limits too.
#include <quadrille/filters.h>
#include <quadrille/quadric_form.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Point = Vector<3>;

struct Face {
  Point before, after, second, third;
};

// What a filter sees of a contraction.
struct Contraction {
  std::vector<Face> all;
  std::size_t degree = 0;
  bool is_fold_over = false;

  const std::vector<Face>& faces() const { return all; }
  std::size_t highest_degree() const { return degree; }
  bool makes_fold_over() const { return is_fold_over; }
};

// The face of the edge from 0 to (1, 0, 0), its corner turned about the edge by so many degrees.
Contraction turned(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const Point corner{{0.5, std::cos(angle), std::sin(angle)}};
  return {{{{{0.5, 1, 0}}, corner, {{0, 0, 0}}, {{1, 0, 0}}}}};
}

// An isosceles triangle over the edge from 0 to (1, 0, 0), its height changed.
Contraction heightened(double before, double after) {
  return {{{{{0.5, before, 0}}, {{0.5, after, 0}}, {{0, 0, 0}}, {{1, 0, 0}}}}};
}

Contraction of_degree(std::size_t after, std::size_t highest_before) {
  return {std::vector<Face>(after), highest_before};
}

} // namespace

TEST_CASE("A normal turns by less than the angle of the filter") {
  for (double limit : {5.0, 45.0, 90.0, 135.0}) {
    CAPTURE(limit);
    CHECK(NormalFlip(limit).allows(turned(0)));
    CHECK(NormalFlip(limit).allows(turned(limit - 0.001)));
    CHECK_FALSE(NormalFlip(limit).allows(turned(limit + 0.001)));
    CHECK_FALSE(NormalFlip(limit).allows(turned(180)));
  }
  CHECK(NormalFlip(180).allows(turned(180)));
}

TEST_CASE("A fold is refused if a face turns by more than 20 degrees") {
  const auto folded = [](double degrees) {
    return Contraction{.all = turned(degrees).all, .is_fold_over = true};
  };
  CHECK(NormalFlip().allows(folded(19.9)));
  CHECK_FALSE(NormalFlip().allows(folded(20.1)));
  CHECK_FALSE(NormalFlip(135).allows(folded(20.1)));
  CHECK(NormalFlip(90, FoldOvers::allowed).allows(folded(20.1)));
  CHECK(NormalFlip(180).allows(folded(20.1)));
}

TEST_CASE("A face must not lose its area, and one without area may do as it likes") {
  const Contraction flattened = heightened(1, 0), raised = heightened(0, 1);
  for (double limit : {45.0, 90.0, 135.0}) {
    CHECK_FALSE(NormalFlip(limit).allows(flattened));
    CHECK(NormalFlip(limit).allows(raised));
  }
}

TEST_CASE("A triangle has a normal unless its points lie on a line up to rounding") {
  const auto has_normal = [](double height, double offset) {
    const Point p{{offset, offset, offset}};
    return squared_length(normal_vector(p, p + Point{{1, 0, 0}}, p + Point{{0.5, height, 0}})) > 0;
  };
  CHECK(has_normal(0x1p-10, 0));
  CHECK(has_normal(0x1p-10, 0x1p40)); // of two bits
  CHECK(has_normal(0x1p-40, 0));
  CHECK_FALSE(has_normal(0x1p-40, 0x1p12)); // one bit: as good as none
  CHECK_FALSE(has_normal(0, 0));
}

TEST_CASE("One face that turns is enough for a refusal") {
  Contraction contraction = turned(10);
  contraction.all.push_back(turned(100).all.front());
  CHECK_FALSE(NormalFlip(90).allows(contraction));
}

TEST_CASE("A vertex gets no more faces than the filter says, or than it had") {
  CHECK(HighestDegree(8).allows(of_degree(8, 5)));
  CHECK_FALSE(HighestDegree(8).allows(of_degree(9, 8)));
  CHECK(HighestDegree(8).allows(of_degree(9, 9)));
  CHECK_FALSE(HighestDegree(8).allows(of_degree(10, 9)));
}

TEST_CASE("No face gets a smaller angle than the filter says, or than it had") {
  const auto angle = [](double height) { return std::atan(height * 2) * 180 / std::numbers::pi; };
  CHECK(SmallestAngle(angle(0.2) - 0.001).allows(heightened(0.8, 0.2)));
  CHECK_FALSE(SmallestAngle(angle(0.2) + 0.001).allows(heightened(0.8, 0.2)));
  CHECK(SmallestAngle(30).allows(heightened(0.1, 0.2)));
  CHECK_FALSE(SmallestAngle(30).allows(heightened(0.2, 0.1)));
  CHECK(SmallestAngle(60).allows(heightened(0, 0)));
  CHECK(SmallestAngle(0).allows(heightened(1, 0)));
  CHECK_FALSE(SmallestAngle(1e-9).allows(heightened(1, 1e-12)));
  CHECK_FALSE(SmallestAngle(60).allows(heightened(3, 4))); // the smallest is at the moving corner
}

TEST_CASE("No edge gets longer than the filter says, or than it was") {
  for (double unit : {1.0, 1e-200, 1e200}) {
    CAPTURE(unit);
    const auto moved = [unit](double before, double after) {
      Contraction contraction = heightened(before, after);
      for (Point* p : {&contraction.all[0].before, &contraction.all[0].after,
                       &contraction.all[0].second, &contraction.all[0].third})
        *p *= unit;
      return contraction;
    };
    const double limit = unit * std::sqrt(1.25); // of the edges where the height is 1
    CHECK(LongestEdge(limit * (1 + 1e-12)).allows(moved(0.1, 1)));
    CHECK_FALSE(LongestEdge(limit * (1 - 1e-12)).allows(moved(0.1, 1)));
    CHECK(LongestEdge(limit / 2).allows(moved(2, 1)));
    CHECK(LongestEdge(limit / 2).allows(moved(1, 1)));
    CHECK_FALSE(LongestEdge(limit / 2).allows(moved(1, 1.001)));
  }
}

TEST_CASE("Seen from above, a face neither turns over nor becomes vertical") {
  const HeightField from_above({{0, 0, 1}});
  // Beside each other on the map, its corner moves to y on the map, and to any height.
  const auto moved = [](double before, double after, double height) {
    return Contraction{{{{{0.5, before, 0}}, {{0.5, after, height}}, {{0, 0, 0}}, {{1, 0, 0}}}}};
  };
  const auto turned_over = [](Contraction contraction) {
    std::swap(contraction.all[0].second, contraction.all[0].third);
    return contraction;
  };
  for (const Contraction& contraction : {moved(1, 0.1, 0), moved(1, 0.1, 1), moved(1, 2, -3)}) {
    CHECK(from_above.allows(contraction));
    CHECK(from_above.allows(turned_over(contraction))); // it was so before
  }
  for (const Contraction& contraction :
       {moved(1, 0, 0), moved(1, 0, 1), moved(1, -0.1, 1), moved(1, 1e-6, 1), moved(1, 1, 1e6)}) {
    CHECK_FALSE(from_above.allows(contraction));
    CHECK_FALSE(from_above.allows(turned_over(contraction)));
    CHECK(HeightField({{1, 0, 0}}).allows(contraction)); // all are vertical from there
  }
  // Vertical before: it may stay so, or show its front, but not its back.
  CHECK(from_above.allows(moved(0, 0, 1)));
  CHECK(from_above.allows(moved(0, 1, 1)));
  CHECK_FALSE(from_above.allows(moved(0, -1e-6, 1)));
  CHECK_FALSE(from_above.allows(moved(0, -1, 1)));
  CHECK(from_above.allows(moved(-1e-6, -1e-6, 0)));
  CHECK_FALSE(from_above.allows(moved(-1e-6, -2e-6, 0)));
}

TEST_CASE("The direction of a height field may have any length, and walls any direction") {
  const auto moved = [](const Point& before, const Point& after) {
    return Contraction{{{before, after, {{0, 0, 0}}, {{1, 0, 0}}}}};
  };
  const Contraction up = moved({{0, 1, 0}}, {{0, 0.5, 1}}), over = moved({{0, 1, 0}}, {{0, -1, 1}});
  for (double length : {1.0, 5e-324, 1e-200, 1e308}) {
    CHECK(HeightField({{0, 0, length}}).allows(up));
    CHECK_FALSE(HeightField({{0, 0, length}}).allows(over));
    CHECK(HeightField({{0, 0, -length}}).allows(up));
    CHECK_FALSE(HeightField({{0, 0, -length}}).allows(over));
  }
  // In a wall that is vertical up to rounding, far away from the origin.
  for (int i = 0; i < 100; ++i) {
    const auto at = [i](double along, double height) {
      const double angle = i * 0.7;
      return Point{{5e5 + along * std::cos(angle), 5e6 + along * std::sin(angle), height}};
    };
    const Contraction wall{{{at(0.1 * i, 1), at(0.3, 2), at(0, 0), at(2, 0)}}};
    CHECK(HeightField().allows(wall));
  }
}
