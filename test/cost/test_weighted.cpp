// Costs made of others: those that are derived, and Weighted.
#include "meshes.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/weighted.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using ConstantWeight = double (*)(const Vector<3>&);

// --- Which costs have a tie break ----------------------------------------------------------------

template <class Cost>
constexpr bool breaks_ties =
    internal::BreaksTies<Cost, internal::PairOf<Cost>, Vector<Cost::dimension>>;

static_assert(breaks_ties<Quadric> && breaks_ties<MemorylessQuadric> &&
              breaks_ties<ThinFeatureQuadric> && breaks_ties<ColorQuadric>);
static_assert(!breaks_ties<EdgeLength>);

// Values of another scale.
template <class Cost>
struct Scaled : Cost {
  double factor = 1e-9;
  double operator()(const auto& pair, const auto& x) const {
    return factor * Cost::operator()(pair, x);
  }
  double squared_error(const auto& pair, double cost) const {
    return Cost::squared_error(pair, cost / factor);
  }
};
static_assert(!breaks_ties<Scaled<Quadric>> && !breaks_ties<Scaled<MemorylessQuadric>> &&
              !breaks_ties<Scaled<ThinFeatureQuadric>> && !breaks_ties<Scaled<ColorQuadric>>);

struct OfNoTemplate : Quadric {
  double operator()(const internal::PairOf<OfNoTemplate>& pair, const Vector<3>& x) const {
    return 2 * Quadric::operator()(pair, x);
  }
};
static_assert(!breaks_ties<OfNoTemplate>);

// What changes other members has the same values.
struct OtherFaces : ThinFeatureQuadric {
  State face(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    return ThinFeatureQuadric::face(p, q, r);
  }
};
static_assert(breaks_ties<OtherFaces>);

// A tie break of one's own.
struct WithOwn : Scaled<Quadric> {
  double tie_break(const auto& pair, const auto& x) const {
    return factor * Quadric::tie_break(pair, x);
  }
};
static_assert(breaks_ties<WithOwn>);

// A cost of the user's says where its own belongs.
struct Own : WithOwn {
  using TieBreak = Own;
  double operator()(const auto& pair, const Vector<3>& x) const {
    return WithOwn::operator()(pair, x);
  }
  double tie_break(const auto& pair, const Vector<3>& x) const {
    return WithOwn::tie_break(pair, x);
  }
};
static_assert(breaks_ties<Own> && !breaks_ties<Scaled<Own>>);

static_assert(breaks_ties<Weighted<Quadric, ConstantWeight>> &&
              breaks_ties<Weighted<Weighted<ThinFeatureQuadric, ConstantWeight>, ConstantWeight>>);
static_assert(!breaks_ties<Weighted<EdgeLength, ConstantWeight>> &&
              !breaks_ties<Weighted<Scaled<Quadric>, ConstantWeight>> &&
              !breaks_ties<Scaled<Weighted<Quadric, ConstantWeight>>>);

static_assert(CostPolicy<Weighted<Quadric, ConstantWeight>> &&
              CostPolicy<Weighted<EdgeLength, ConstantWeight>> &&
              CostPolicy<Weighted<ColorQuadric, ConstantWeight>>);
static_assert(PlacementPolicy<OptimalPlacement, Weighted<MemorylessQuadric, ConstantWeight>> &&
              !PlacementPolicy<OptimalPlacement, Weighted<EdgeLength, ConstantWeight>>);
static_assert(!WeightFunction<double> && !WeightFunction<double (*)(double)>);

// --- What they are tried on ----------------------------------------------------------------------

struct Result {
  Soup soup;
  Report report;
};

template <class... Arguments>
Result simplified(const Soup& input, double scale, const Arguments&... arguments) {
  Soup scaled = input;
  for (Position& p : scaled.points)
    p *= scale;
  PointSoup points(scaled);
  const Report report = simplify(points.points, points.triangles, arguments...);
  Result result{{{}, points.triangles}, report};
  for (const Point& p : points.points)
    result.soup.points.push_back((1 / scale) * to_position(p));
  result.report.error /= scale;
  return result;
}

Soup noisy() {
  return with_noise(sphere(4), 1, 0.01);
}

// One half of it flat: there ties are broken.
Soup half_flat() {
  Soup soup = noisy();
  for (Position& p : soup.points)
    p[2] = std::max(p[2], 0.);
  return soup;
}

void check_same(const Result& a, const Result& b) {
  const bool is_same = a.soup.triangles == b.soup.triangles && a.soup.points == b.soup.points;
  CHECK(is_same);
  CHECK(a.report.error == b.report.error);
}

} // namespace

TEMPLATE_TEST_CASE("a power of two in all values of a derived cost changes nothing", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  const Soup soup = noisy();
  const Result expected = simplified(soup, 1, Scaled<TestType>{{}, 1}, FaceRatio{0.1});
  for (const int exponent : {-30, 30})
    check_same(simplified(soup, 1, Scaled<TestType>{{}, std::ldexp(1, exponent)}, FaceRatio{0.1}),
               expected);
}

TEST_CASE("Weighted by a constant is the cost itself") {
  const Soup soup = half_flat();
  const Result expected = simplified(soup, 1, Quadric{}, FaceRatio{0.1});
  for (const double factor : {1., 1e-9, 1e9}) {
    CAPTURE(factor);
    const Weighted cost(Quadric{}, [=](const Vector<3>&) { return factor; });
    const Result result = simplified(soup, 1, cost, FaceRatio{0.1});
    const bool is_same = result.soup.triangles == expected.soup.triangles;
    CHECK(is_same);
    CHECK(result.report.error == Approx(expected.report.error).epsilon(1e-12));
  }
}

TEMPLATE_TEST_CASE("so it is with costs that are kept up to date, up to rounding", "",
                   MemorylessQuadric, ThinFeatureQuadric) {
  const Soup soup = half_flat();
  const auto weighted = [&](double factor) {
    return simplified(soup, 1, Weighted(TestType{}, [=](const Vector<3>&) { return factor; }),
                      FaceRatio{0.1});
  };
  const Result expected = weighted(1);
  CHECK(expected.report.error ==
        Approx(simplified(soup, 1, TestType{}, FaceRatio{0.1}).report.error).epsilon(0.01));
  for (const double factor : {1e-9, 1e9}) {
    const Result result = weighted(factor);
    const bool is_same = result.soup.triangles == expected.soup.triangles;
    CHECK(is_same);
    CHECK(result.report.error == Approx(expected.report.error).epsilon(1e-12));
  }
}

TEMPLATE_TEST_CASE("Weighted does not know the scale", "", Quadric, MemorylessQuadric) {
  const Soup soup = std::is_same_v<TestType, Quadric> ? half_flat() : noisy();
  const auto seen_from = [](const Vector<3>& eye, double factor) {
    return Weighted(TestType{},
                    [=](const Vector<3>& p) { return factor / squared_distance(p, eye); });
  };
  const Vector<3> eye{1.5, 0, 0};
  const Result expected = simplified(soup, 1, seen_from(eye, 1), FaceRatio{0.1});
  for (const int exponent : {-20, 20}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1, exponent);
    check_same(simplified(soup, scale, seen_from(scale * eye, 1), FaceRatio{0.1}), expected);
    check_same(simplified(soup, scale, seen_from(scale * eye, std::ldexp(1, -30)), FaceRatio{0.1}),
               expected);
  }
  // And it does what it is there for.
  const Result plain = simplified(soup, 1, TestType{}, FaceRatio{0.1});
  const auto count_near = [&](const Result& result) {
    std::size_t near = 0;
    for (const Position& p : result.soup.points)
      near += squared_distance(p, eye) < 1;
    return near;
  };
  CHECK(5 * count_near(expected) > 6 * count_near(plain));
}

TEST_CASE("Weighted goes with costs that have no tie break or more dimensions, and with passes") {
  const Soup soup = half_flat();
  const auto from_left = [](const Vector<3>& p) { return p[0] < 0 ? 1. : 100.; };
  const auto count_right = [](const Soup& result) {
    std::size_t count = 0;
    for (const Position& p : result.points)
      count += p[0] > 0;
    return count;
  };
  const Result edges =
      simplified(soup, 1, Weighted(EdgeLength{}, from_left), MidpointPlacement{}, FaceRatio{0.1});
  CHECK(5 * count_right(edges.soup) > 4 * edges.soup.points.size());
  const Result passes =
      simplified(soup, 1, Weighted(Quadric{}, from_left), RelaxedOrder{}, FaceRatio{0.1});
  CHECK(2 * count_right(passes.soup) > passes.soup.points.size());
  // An error is told as a distance, whatever the weights.
  const Result cheap =
      simplified(soup, 1, Weighted(EdgeLength{}, [](const Vector<3>&) { return 1e-12; }),
                 MidpointPlacement{}, FaceRatio{0.1});
  CHECK(
      cheap.report.error ==
      Approx(simplified(soup, 1, EdgeLength{}, MidpointPlacement{}, FaceRatio{0.1}).report.error));
  // What weighs nothing goes first, and has no error.
  const Result free = simplified(
      soup, 1, Weighted(Quadric{}, [](const Vector<3>& p) { return p[0] < 0 ? 0. : 1.; }),
      FaceRatio{0.7});
  CHECK(std::isfinite(free.report.error));
}
