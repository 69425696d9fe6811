// Costs of the user's that are costed two pairs at a time: CostPolicy's TwoLanes.
#include "meshes.h"
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace {

using namespace quadrille;
using namespace test;

template <class Cost>
constexpr bool has_two_lanes = internal::has_two_lanes<Cost, OptimalPlacement>;

static_assert(has_two_lanes<Quadric> && has_two_lanes<const Quadric> &&
              has_two_lanes<MemorylessQuadric> && has_two_lanes<ThinFeatureQuadric>);
static_assert(!internal::has_two_lanes<Quadric, MidpointPlacement>);
static_assert(!has_two_lanes<ColorQuadric> && !has_two_lanes<EdgeLength>);

// Whether a derived class has other values nobody knows but itself.
struct Derived : Quadric {};
static_assert(!has_two_lanes<Derived>);

// Each of the following is there with two lanes and without.

// Written anew: planes that count by the root of their area.
template <bool two>
struct OfOnesOwn {
  static constexpr std::size_t dimension = 3;
  using ScaleFree = OfOnesOwn;
  using TwoLanes = std::conditional_t<two, OfOnesOwn, void>;
  using State = QuadricForm<3>;
  using TieBreak = OfOnesOwn;

  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    const Vector<3> normal = normal_vector(p, q, r);
    const double squared = squared_length(normal);
    return squared > 0 ? State::plane(normal, std::pow(squared, -0.75)) : State();
  }
  double operator()(const auto& pair, const Vector<3>& x) const {
    return pair.state(x - pair.first);
  }
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return Quadric{}.tie_break(pair, x);
  }
  std::optional<Vector<3>> minimizer(const auto& pair) const { return Quadric{}.minimizer(pair); }
};

// Faces to the right count more.
template <bool two>
struct Lopsided : Quadric {
  using ScaleFree = Lopsided;
  using TieBreak = Lopsided;
  using TwoLanes = std::conditional_t<two, Lopsided, Quadric>;

  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    State state = Quadric::face(p, q, r);
    return state *= p[0] + q[0] + r[0] > 0 ? 20 : 1;
  }
};

// Planes count by area^(3/2).
template <class Base, bool two>
struct ByArea : Base {
  using ScaleFree = ByArea;
  using TieBreak = ByArea;
  using TwoLanes = std::conditional_t<two, ByArea, Base>;

  ByArea() {
    if constexpr (std::is_same_v<Base, ThinFeatureQuadric>)
      Base::loss_tolerance = 0; // so that all losses count
  }
  typename Base::Current current_face(const Vector<3>& p, const Vector<3>& q,
                                      const Vector<3>& r) const {
    return Base::weighted_face(p, q, r, [](double area) { return std::sqrt(area); });
  }
};

Soup noisy() {
  return with_noise(sphere(4), 1, 0.01);
}

template <class Cost>
Soup simplified(const AnyOrder& order) {
  PointSoup soup(noisy());
  simplify(soup.points, soup.triangles, Cost{}, FaceRatio{0.2}, order);
  return to_soup(soup);
}

template <class Cost, class Plain>
void check() {
  static_assert(has_two_lanes<Cost> && !has_two_lanes<Plain>);
  for (const AnyOrder& order : {AnyOrder(GreedyOrder{}), AnyOrder(RelaxedOrder{})}) {
    const Soup expected = simplified<Plain>(order);
    CHECK(is_identical(simplified<Cost>(order), expected));
    CHECK(!is_identical(simplified<Quadric>(order), expected));
  }
}

} // namespace

TEST_CASE("a cost of one's own with two lanes has the bits that it has without") {
  check<OfOnesOwn<true>, OfOnesOwn<false>>();
}

TEST_CASE("a derived cost with two lanes has the bits that it has without") {
  check<Lopsided<true>, Lopsided<false>>();
}

TEST_CASE("a derived memoryless cost with two lanes has the bits that it has without") {
  check<ByArea<MemorylessQuadric, true>, ByArea<MemorylessQuadric, false>>();
}

TEST_CASE("a derived cost that counts losses with two lanes has the bits that it has without") {
  check<ByArea<ThinFeatureQuadric, true>, ByArea<ThinFeatureQuadric, false>>();
}
