// Each filter lets pass what it says, at its limits too.
#include <quadrille/filters.h>
#include <quadrille/vector.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
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
  bool is_fold = false;

  const std::vector<Face>& faces() const { return all; }
  std::size_t highest_degree() const { return degree; }
  bool makes_fold() const { return is_fold; }
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

double quality(double height) {
  return 4 * std::numbers::sqrt3 * (height / 2) / (1 + 2 * (0.25 + height * height));
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
    return Contraction{.all = turned(degrees).all, .is_fold = true};
  };
  CHECK(NormalFlip().allows(folded(19.9)));
  CHECK_FALSE(NormalFlip().allows(folded(20.1)));
  CHECK_FALSE(NormalFlip(135).allows(folded(20.1)));
  CHECK(NormalFlip(90, Folds::allowed).allows(folded(20.1)));
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

TEST_CASE("No sliver is made out of a better triangle") {
  const double limit = quality(0.2);
  CHECK(TriangleShape(limit * 1.01).allows(heightened(0.1, 0.19)));       // bad, but better
  CHECK_FALSE(TriangleShape(limit * 0.99).allows(heightened(0.2, 0.19))); // below the limit
  CHECK(TriangleShape(limit * 0.99).allows(heightened(0.8, 0.2)));        // worse, but good enough
  CHECK_FALSE(TriangleShape(limit * 1.01).allows(heightened(0.8, 0.2)));
  CHECK(TriangleShape(0).allows(heightened(1, 0)));
  CHECK(TriangleShape(1).allows(heightened(0.5, 0.6)));
  CHECK(TriangleShape(1).allows(heightened(0, 0)));
}

TEST_CASE("A vertex gets no more faces than the filter says, or than it had") {
  CHECK(HighestDegree(8).allows(of_degree(8, 5)));
  CHECK_FALSE(HighestDegree(8).allows(of_degree(9, 8)));
  CHECK(HighestDegree(8).allows(of_degree(9, 9)));
  CHECK_FALSE(HighestDegree(8).allows(of_degree(10, 9)));
}
