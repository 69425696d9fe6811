// The columns of channels, whose components are computed with two or four at a time, against plain
// sums in doubles.

#include <quadrille/internal/attributes/wedge_records.h>
#include <quadrille/internal/attributes/wedge_sums.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/quadric_form.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace quadrille::internal;

constexpr std::size_t vertices = 7;

struct Face {
  std::array<Index, 3> corners;
  double weight;
};

/// Vertices with values, numbered from the middle of a fan on, and a record for each.
struct Fan {
  explicit Fan(std::size_t components) : input() {
    input.components = components;
    input.values.resize(vertices * components);
    for (double& value : input.values)
      value = number(-3, 3);
    for (std::size_t c = 0; c < components; ++c)
      squared_weights.push_back(std::pow(number(0.1, 2), 2));
    for (Vector<3>& place : places)
      place = {{number(-1, 1), number(-1, 1), number(-1, 1)}};
    for (Index v = 1; v + 1 < vertices; ++v)
      faces.push_back({{0, v, v + 1}, number(0.1, 1)});
  }

  WedgeRecords records() const {
    WedgeRecords records(squared_weights, nullptr);
    Array<Index> origins(vertices);
    for (Index v = 0; v < vertices; ++v)
      origins[v] = v;
    records.read(input, std::move(origins));
    return records;
  }
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }

  std::mt19937 random{7};
  ChannelInput input;
  std::vector<double> squared_weights;
  std::array<Vector<3>, vertices> places;
  std::vector<Face> faces;
};

/// The gradients of what is 1 at the second or the third corner of a face and 0 at the others.
std::array<Vector<3>, 2> ways_on(const Fan& fan, const Face& face) {
  const Vector<3> to_second = fan.places[face.corners[1]] - fan.places[face.corners[0]];
  const Vector<3> to_third = fan.places[face.corners[2]] - fan.places[face.corners[0]];
  const Vector<3> normal = cross(to_second, to_third);
  const double inverse = 1 / squared_length(normal);
  return {inverse * cross(to_third, normal), inverse * cross(normal, to_second)};
}

Vector<3> gradient(const Fan& fan, const Face& face, std::size_t c) {
  const auto [first, second] = ways_on(fan, face);
  const auto value = [&](std::size_t i) { return fan.input.value(face.corners[i], c); };
  return (value(1) - value(0)) * first + (value(2) - value(0)) * second;
}

AffineMap random_map(Fan& fan) {
  return {{{fan.number(-1, 1), fan.number(-1, 1), fan.number(-1, 1)}}, fan.number(-2, 2)};
}

/// Gives a wedge random maps and returns them.
WedgeMap write_random(Fan& fan, WedgeRecords& records, Index wedge) {
  WedgeMap map;
  map.weight = fan.number(0.1, 2);
  for (std::size_t c = 0; c < records.components(); ++c)
    map.maps.push_back(random_map(fan));
  records.write(wedge, map);
  return map;
}

constexpr std::array<std::size_t, 7> counts{1, 2, 3, 4, 5, 8, 11};

TEST_CASE("The faces of a wedge sum up to their mean gradient and what they disagree about") {
  for (std::size_t components : counts) {
    CAPTURE(components);
    Fan fan(components);
    WedgeRecords records = fan.records();
    SymmetricMatrix<3> found;
    with_wedge_sums(vertices, components, nullptr, [&](auto sums) {
      sums.clear(0);
      typename decltype(sums)::Row row(components);
      for (const Face& face : fan.faces) {
        const auto [first, second] = ways_on(fan, face);
        double steepness = 0;
        for (std::size_t c = 0; c < components; ++c)
          steepness += fan.squared_weights[c] * squared_length(gradient(fan, face, c));
        CHECK(row.set(records, face.corners, first, second) == Approx(steepness));
        row.weigh(face.weight);
        sums.add(0, row);
      }
      found = sums.resolve(0, records);
    });
    double weight = 0;
    for (const Face& face : fan.faces)
      weight += face.weight;
    SymmetricMatrix<3> expected;
    const WedgeMap map = records.map(0);
    for (std::size_t c = 0; c < components; ++c) {
      Vector<3> mean;
      for (const Face& face : fan.faces)
        mean += (face.weight / weight) * gradient(fan, face, c);
      for (const Face& face : fan.faces)
        expected += SymmetricMatrix<3>::outer_product(gradient(fan, face, c) - mean,
                                                      face.weight * fan.squared_weights[c]);
      CHECK(squared_distance(map.maps[c].gradient, mean) < 1e-12 * (1 + squared_length(mean)));
      CHECK(map.maps[c].value == fan.input.value(0, c));
    }
    CHECK(map.weight == Approx(weight));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        CHECK(std::abs(found(i, j) - expected(i, j)) < 1e-12 * expected.trace());
  }
}

TEST_CASE("Maps of two wedges differ and are joined, four components at a time") {
  for (std::size_t components : counts) {
    CAPTURE(components);
    Fan fan(components);
    WedgeRecords records = fan.records();
    const WedgeMap one = write_random(fan, records, 2), other = write_random(fan, records, 5);
    const Vector<3> to_second = fan.places[5] - fan.places[2], target = fan.places[1];
    for_each_four(components, [&](std::size_t four, auto count) {
      const auto [x, y, z, off] = records.differences<count>(2, 5, to_second, four);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t c = 4 * four + i;
        const double length = std::sqrt(fan.squared_weights[c]);
        const Vector<3> apart = other.maps[c].gradient - one.maps[c].gradient;
        CHECK(squared_distance({{x[i], y[i], z[i]}}, length * apart) < 1e-12);
        CHECK(
            off[i] ==
            Approx(length * (other.maps[c].at(-1.0 * to_second) - one.maps[c].value)).margin(1e-6));
      }
    });
    records.join(2, 5, to_second, target, 2, fan.squared_weights);
    const double part = other.weight / (one.weight + other.weight);
    const WedgeMap joined = records.map(2);
    for (std::size_t c = 0; c < components; ++c) {
      const AffineMap &p = one.maps[c], &q = other.maps[c];
      CHECK(squared_distance(joined.maps[c].gradient, (1 - part) * p.gradient + part * q.gradient) <
            1e-12);
      CHECK(joined.maps[c].value ==
            Approx((1 - part) * p.at(target) + part * q.at(target - to_second)).margin(1e-6));
    }
    CHECK(joined.weight == Approx(one.weight + other.weight));
    CHECK(records.origin(2) == none);
  }
}

} // namespace
