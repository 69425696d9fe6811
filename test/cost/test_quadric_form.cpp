// The quadric as a value: sums, origins and least values.

#include "soups.h"

#include <quadrille/internal/core/evaluation/two_quadrics.h>
#include <quadrille/quadric_form.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace {

using quadrille::QuadricForm;
using quadrille::Vector;
using test::Random;

template <std::size_t N>
Vector<N> random_vector(Random& random) {
  Vector<N> v;
  for (double& x : v.coordinates)
    x = random(-1, 1);
  return v;
}

template <std::size_t N>
Vector<N> random_direction(Random& random) {
  const Vector<N> v = random_vector<N>(random);
  return 1 / std::sqrt(squared_length(v)) * v;
}

// The plane through p, as a form about the origin.
template <std::size_t N>
QuadricForm<N> plane_through(const Vector<N>& p, const Vector<N>& normal, double weight = 1) {
  QuadricForm<N> form = QuadricForm<N>::plane(normal, weight);
  form.move_origin(-1.0 * p);
  return form;
}

} // namespace

TEMPLATE_TEST_CASE_SIG("A plane's quadric is the weighted squared distance to it", "",
                       ((std::size_t N), N), 3, 5, 6) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector<N> normal = random_direction<N>(random), x = random_vector<N>(random);
    const double weight = random(0, 10), distance = dot(normal, x);
    CHECK(QuadricForm<N>::plane(normal, weight)(x) == Approx(weight * distance * distance));
    CHECK(QuadricForm<N>::plane(normal, weight).trace() == Approx(weight));
    CHECK(QuadricForm<N>::point(weight)(x) == Approx(weight * squared_length(x)));
  }
}

TEMPLATE_TEST_CASE_SIG("A quadric about another point is the same function", "",
                       ((std::size_t N), N), 3, 5, 6) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    QuadricForm<N> form = QuadricForm<N>::point(0.5);
    for (int k = 0; k < 4; ++k)
      form += plane_through(random_vector<N>(random), random_direction<N>(random));
    const Vector<N> d = random_vector<N>(random), x = random_vector<N>(random);
    QuadricForm<N> moved = form;
    moved.move_origin(d);
    CHECK(moved(x - d) == Approx(form(x)));
    CHECK(moved.constant() == Approx(form(d)));
  }
}

TEMPLATE_TEST_CASE_SIG("Sums of quadrics, about one point or two, are sums of their values", "",
                       ((std::size_t N), N), 3, 6) {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const auto away = [&] { // neither a gradient nor a constant of zero
      return plane_through(random_vector<N>(random), random_direction<N>(random), random(1, 2));
    };
    const QuadricForm<N> a = away(), b = away();
    const Vector<N> d = random_vector<N>(random), x = random_vector<N>(random);
    CHECK((a + b)(x) == Approx(a(x) + b(x)));
    CHECK(QuadricForm<N>::sum_about_first(a, b, d)(x) == Approx(a(x) + b(x - d)));
  }
}

TEST_CASE("Two sums of quadrics at a time have the least values of each") {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const auto away = [&] { // neither a gradient nor a constant of zero
      QuadricForm<3> form;
      for (int plane = 0; plane < 3; ++plane)
        form += plane_through(random_vector<3>(random), random_direction<3>(random));
      return form;
    };
    const QuadricForm<3> first = away(), second = away(), third = away(), fourth = away();
    const Vector<3> d = random_vector<3>(random), e = random_vector<3>(random);
    const auto values = quadrille::internal::least_values(
        {&first, &second}, {&third, &fourth}, {d, e}, quadrille::internal::Lanes{1e9, 1e9},
        quadrille::internal::NothingAdded{});
    const auto left = QuadricForm<3>::sum_about_first(first, third, d);
    const auto right = QuadricForm<3>::sum_about_first(second, fourth, e);
    CHECK(values[0] == Approx(left(*left.minimizer())));
    CHECK(values[1] == Approx(right(*right.minimizer())));
  }
}

TEST_CASE("The least value of three planes lies where they meet") {
  // x = 1, y = 2, z = 3 and x + y + z = 6
  QuadricForm<3> form = plane_through<3>({{1, 0, 0}}, {{1, 0, 0}});
  form += plane_through<3>({{0, 2, 0}}, {{0, 1, 0}});
  form += plane_through<3>({{0, 0, 3}}, {{0, 0, 1}});
  form += plane_through<3>({{6, 0, 0}}, {{1, 1, 1}});
  const std::optional<Vector<3>> x = form.minimizer();
  REQUIRE(x);
  CHECK(squared_distance(*x, {{1, 2, 3}}) < 1e-28);
  CHECK(std::abs(form(*x)) < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("No position costs less than the minimizer", "", ((std::size_t N), N), 3, 5,
                       6) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    QuadricForm<N> form;
    for (std::size_t k = 0; k < N + 3; ++k)
      form += plane_through(random_vector<N>(random), random_direction<N>(random), random(0, 2));
    const std::optional<Vector<N>> x = form.minimizer();
    REQUIRE(x);
    CHECK(form(*x) >= 0);
    for (int k = 0; k < 20; ++k)
      CHECK(form(*x + 1e-3 * random_vector<N>(random)) >= form(*x));
  }
}

TEST_CASE("A quadric that leaves a direction free has no minimizer") {
  Random random(4);
  CHECK_FALSE(QuadricForm<3>{}.minimizer());
  for (int i = 0; i < 200; ++i) {
    const Vector<3> p = random_vector<3>(random), axis = random_direction<3>(random);
    CHECK_FALSE(plane_through(p, axis, random(0.1, 10)).minimizer());
    QuadricForm<3> planes_along_axis;
    for (int k = 0; k < 6; ++k) {
      const Vector<3> normal = cross(axis, random_direction<3>(random));
      planes_along_axis += plane_through(p, normal, random(0.1, 10));
    }
    CHECK_FALSE(planes_along_axis.minimizer());
  }
}

TEST_CASE("A quadric with numbers that are not finite has no minimizer") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(QuadricForm<3>::point(nan).minimizer());
  CHECK_FALSE((QuadricForm<3>::point(1) + QuadricForm<3>::plane({{nan, 0, 0}}, 1)).minimizer());
}

TEMPLATE_TEST_CASE_SIG("Whether there is a minimizer does not depend on the unit", "",
                       ((std::size_t N), N), 3, 5) {
  // Powers of two, so that nothing is rounded: lengths times s, weights (areas) times s².
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vector<N>> points, normals;
    for (std::size_t k = 0; k < N + 1; ++k) {
      points.push_back(random_vector<N>(random));
      normals.push_back(random_direction<N>(random));
    }
    if (i % 2 == 0) // a free direction
      for (Vector<N>& n : normals)
        n[2] = n[0] + n[1];
    std::optional<Vector<N>> at_one;
    for (double s : {1.0, 0x1p-60, 0x1p60}) {
      QuadricForm<N> form;
      for (std::size_t k = 0; k < N + 1; ++k)
        form += plane_through(s * points[k], normals[k], s * s);
      const std::optional<Vector<N>> x = form.minimizer();
      if (s == 1)
        at_one = x;
      REQUIRE(x.has_value() == at_one.has_value());
      if (x)
        CHECK(*x == s * *at_one);
    }
    CHECK(at_one.has_value() == (i % 2 == 1));
  }
}

TEST_CASE("A point quadric of a billionth of the planes makes a system regular") {
  // The straight crease x = y = 0 along z, remembered by two vertices of it: their middle is best.
  QuadricForm<3> form =
      QuadricForm<3>::plane({{1, 0, 0}}, 1) + QuadricForm<3>::plane({{0, 1, 0}}, 1);
  for (double z : {-1.0, 3.0}) {
    QuadricForm<3> point = QuadricForm<3>::point(1e-9);
    point.move_origin({{0, 0, -z}});
    form += point;
  }
  const std::optional<Vector<3>> x = form.minimizer();
  REQUIRE(x);
  CHECK(squared_distance(*x, {{0, 0, 1}}) < 1e-12);
}

TEST_CASE("A quadric kept near its planes is as exact a million units away") {
  // Two planes that meet at right angles in a line, and a third across it, all near a far point.
  const Vector<3> far{{1e6, -2e6, 3e6}}, apex{{0.25, 0.5, -0.125}};
  QuadricForm<3> form = plane_through<3>(apex, {{1, 0, 0}}) + plane_through<3>(apex, {{0, 1, 0}}) +
                        plane_through<3>(apex, {{0, 0, 1}});
  CHECK(form(apex) == 0);
  // About zero, what is left of the cost of a thousandth is noise of the size of ε · |far|².
  QuadricForm<3> about_zero = form;
  about_zero.move_origin(-1.0 * far);
  const Vector<3> near = apex + Vector<3>{{1e-3, 0, 0}};
  CHECK(form(near) == Approx(1e-6).epsilon(1e-9));
  CHECK(about_zero(far + near) != Approx(1e-6).epsilon(1e-3));
}

TEST_CASE("A quadric is a value") {
  const QuadricForm<3> a = plane_through<3>({{1, 2, 3}}, {{0, 0, 1}}, 2);
  const QuadricForm<3> b = plane_through<3>({{4, 5, 6}}, {{0, 1, 0}}, 3);
  const Vector<3> x{{-1, 7, 0.5}};
  const double a_at_x = a(x), b_at_x = b(x);
  QuadricForm<3> c = a + b;
  CHECK(c(x) == a_at_x + b_at_x);
  c -= b;
  CHECK(c(x) == a_at_x);
  c *= 4;
  CHECK(c(x) == 4 * a_at_x);
  CHECK(a(x) == a_at_x);
  CHECK(b(x) == b_at_x);

  quadrille::SymmetricMatrix<3> m;
  m.set(2, 0, 2.5);
  m.set(1, 1, 4);
  CHECK(m(0, 2) == 2.5);
  CHECK(m(2, 0) == 2.5);
  const QuadricForm<3> d(m);
  CHECK(d({{1, 0, 1}}) == 5);
  CHECK(b.gradient() == Vector<3>{{0, -15, 0}});
  CHECK(b.constant() == 75);
  static_assert(QuadricForm<3>::plane({{0, 0, 1}}, 2)({{5, 5, 3}}) == 18);
}

TEST_CASE("A quadric takes no more memory than its coefficients") {
  CHECK(sizeof(QuadricForm<3>) == 10 * sizeof(double));
  CHECK(sizeof(QuadricForm<5>) == 21 * sizeof(double));
  CHECK(sizeof(QuadricForm<6>) == 28 * sizeof(double));
}
