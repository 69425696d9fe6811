// The attributes of wedges can be eliminated from a quadric in space and attributes: what is left
// are sums of squares in space, and the best attributes are affine maps of the position.

#include "channel_reference.h"
#include "soups.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using test::LeastSquares;
using Real = LeastSquares::Real;
using Point = std::array<Real, 3>;
using Row = std::array<Real, 4>; // an affine function in space: its gradient and its value at 0

Real at(const Row& row, const Point& x) {
  return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
}

Row operator+(Row a, const Row& b) {
  for (std::size_t i = 0; i < 4; ++i)
    a[i] += b[i];
  return a;
}
Row operator*(Real factor, Row a) {
  for (Real& x : a)
    x *= factor;
  return a;
}
Row operator-(const Row& a, const Row& b) {
  return a + Real(-1) * b;
}

struct Square {
  Row row;
  Real weight;
};
using Squares = std::vector<Square>;

// A weight W and two affine maps of x: the attributes s cost (s - maps(x))ᵀ W (s - maps(x)).
struct Maps {
  std::array<Real, 3> weight; // xx, xy, yy
  std::array<Row, 2> maps;
};

std::array<Row, 2> product(const std::array<Real, 3>& w, const std::array<Row, 2>& maps) {
  return {w[0] * maps[0] + w[1] * maps[1], w[1] * maps[0] + w[2] * maps[1]};
}
std::array<Row, 2> inverse_product(const std::array<Real, 3>& w, const std::array<Row, 2>& maps) {
  const Real determinant = w[0] * w[2] - w[1] * w[1];
  return product({w[2] / determinant, -w[1] / determinant, w[0] / determinant}, maps);
}

// Adds rowsᵀ W rows.
void add(const std::array<Real, 3>& w, const std::array<Row, 2>& rows, Squares& squares) {
  squares.push_back({rows[0] + rows[1], w[1]});
  squares.push_back({rows[0], w[0] - w[1]});
  squares.push_back({rows[1], w[2] - w[1]});
}

// The maps of both, L = (W₁ + W₂)⁻¹ (W₁L₁ + W₂L₂), and what these disagree about, the square of L₁
// - L₂ with the weight W₁(W₁ + W₂)⁻¹W₂.
Maps joined(const Maps& a, const Maps& b, Squares& squares) {
  const std::array sum{a.weight[0] + b.weight[0], a.weight[1] + b.weight[1],
                       a.weight[2] + b.weight[2]};
  const auto wa = product(a.weight, a.maps), wb = product(b.weight, b.maps);
  const std::array<Row, 2> unit{Row{1, 0, 0, 0}, Row{0, 1, 0, 0}}; // columns, as rows
  const auto parallel = product(a.weight, inverse_product(sum, product(b.weight, unit)));
  add({parallel[0][0], parallel[0][1], parallel[1][1]},
      {a.maps[0] - b.maps[0], a.maps[1] - b.maps[1]}, squares);
  return {sum, inverse_product(sum, {wa[0] + wb[0], wa[1] + wb[1]})};
}

// The same sums with s as two unknowns more, from number `first`.
void add(const Maps& maps, std::size_t first, LeastSquares& all) {
  const auto add = [&](const std::array<Real, 2>& direction, Real weight) {
    std::vector<LeastSquares::Term> terms;
    const Row row = direction[0] * maps.maps[0] + direction[1] * maps.maps[1];
    for (std::size_t i = 0; i < 3; ++i)
      terms.push_back({i, -row[i]});
    terms.push_back({first, direction[0]});
    terms.push_back({first + 1, direction[1]});
    all.add(terms, row[3], weight);
  };
  add({1, 1}, maps.weight[1]);
  add({1, 0}, maps.weight[0] - maps.weight[1]);
  add({0, 1}, maps.weight[2] - maps.weight[1]);
}

void add(const Squares& squares, LeastSquares& all) {
  for (const auto& [row, weight] : squares)
    all.add({{0, row[0]}, {1, row[1]}, {2, row[2]}}, -row[3], weight);
}

Real cost(const Maps& maps, const std::array<Real, 2>& s, const Point& x) {
  const Real u = s[0] - at(maps.maps[0], x), v = s[1] - at(maps.maps[1], x);
  return maps.weight[0] * u * u + 2 * maps.weight[1] * u * v + maps.weight[2] * v * v;
}

Real cost(const Squares& squares, const Point& x) {
  Real sum = 0;
  for (const auto& [row, weight] : squares)
    sum += weight * at(row, x) * at(row, x);
  return sum;
}

Row random_row(test::Random& random) {
  Row row{};
  for (Real& x : row)
    x = random(-1, 1);
  return row;
}

// Of a face, which has one weight for both attributes.
Maps random_maps(test::Random& random) {
  const Real weight = random(0.1, 1);
  return {{weight, 0, weight}, {random_row(random), random_row(random)}};
}

// Of the edge of a chart: constant, and with a weight across the edge only.
Maps random_boundary(test::Random& random) {
  const Real angle = random(0, 3), weight = random(1, 100);
  const Real u = std::cos(angle), v = std::sin(angle);
  return {{weight * u * u, weight * u * v, weight * v * v},
          {Row{0, 0, 0, random(-1, 1)}, Row{0, 0, 0, random(-1, 1)}}};
}

// A wedge of some faces, and of edges of its chart: as it is, and with its attributes eliminated.
struct Wedge {
  std::vector<Maps> all;
  Maps maps;
  Squares squares;

  Wedge(test::Random& random, int faces, int borders) {
    for (int i = 0; i < faces; ++i)
      all.push_back(random_maps(random));
    for (int i = 0; i < borders; ++i)
      all.push_back(random_boundary(random));
    maps = all.front();
    for (std::size_t i = 1; i < all.size(); ++i)
      maps = joined(maps, all[i], squares);
  }
};

} // namespace

TEST_CASE("Attributes eliminated from a quadric leave sums of squares") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  CAPTURE(seed);
  test::Random random(seed);
  const auto is = [](Real x) { return Approx(double(x)).epsilon(1e-12).margin(1e-12); };
  // Wedges at two ends, of which two pairs join, and one goes on by itself.
  const int borders = seed % 2 == 0 ? 0 : 2;
  const std::vector<Wedge> wedges{{random, 5, borders},
                                  {random, 3, borders},
                                  {random, 4, 0},
                                  {random, 2, borders},
                                  {random, 1, borders}};
  const std::vector<std::vector<std::size_t>> groups{{0, 2}, {1, 3}, {4}};
  LeastSquares full(3 + 2 * groups.size()), in_space(3);
  std::vector<Maps> best;
  Squares squares;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    best.push_back(wedges[groups[g][0]].maps);
    for (std::size_t w : groups[g]) {
      for (const Maps& maps : wedges[w].all)
        add(maps, 3 + 2 * g, full);
      squares.insert(squares.end(), wedges[w].squares.begin(), wedges[w].squares.end());
      if (w != groups[g][0])
        best[g] = joined(best[g], wedges[w].maps, squares);
    }
  }
  add(squares, in_space);

  full.eliminate(3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(double(in_space(i, j)) == is(full(i, j)));
    CHECK(double(in_space.right(i)) == is(full.right(i)));
  }
  const Point x{random(-1, 1), random(-1, 1), random(-1, 1)};
  const std::vector<Real> solution = full.solve({x[0], x[1], x[2]});
  Real least = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::array s{solution[3 + 2 * g], solution[4 + 2 * g]};
    for (std::size_t c = 0; c < 2; ++c)
      CHECK(double(at(best[g].maps[c], x)) == is(s[c]));
    for (std::size_t w : groups[g])
      for (const Maps& maps : wedges[w].all)
        least += cost(maps, s, x);
  }
  CHECK(double(cost(squares, x)) == is(least));
}
