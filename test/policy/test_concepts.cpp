#include "archetypes.h"
#include "meshes.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/filters.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <concepts>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

using namespace quadrille;
using namespace test;

// --- The models ----------------------------------------------------------------------------------

static_assert(CostPolicy<Quadric> && CostPolicy<EdgeLength>);
static_assert(CostPolicy<MemorylessQuadric> && CostPolicy<ThinFeatureQuadric>);
static_assert(CostPolicy<AttributeQuadric<1>> && CostPolicy<AttributeQuadric<7>>);
static_assert(CostPolicy<ColorQuadric> && CostPolicy<TextureQuadric> && CostPolicy<NormalQuadric>);
static_assert(PlacementPolicy<OptimalPlacement, Quadric>);
static_assert(PlacementPolicy<OptimalPlacement, ColorQuadric>);
static_assert(PlacementPolicy<OptimalPlacement, MemorylessQuadric>);
static_assert(PlacementPolicy<EndpointPlacement, EdgeLength>);
static_assert(PlacementPolicy<MidpointPlacement, EdgeLength>);
static_assert(PairPolicy<EdgePairs> && PairPolicy<ThresholdPairs>);
static_assert(StopPolicy<FaceCount> && StopPolicy<FaceRatio> && StopPolicy<VertexCount>);
static_assert(StopPolicy<DistanceLimit> && StopPolicy<AnyOf<FaceCount, DistanceLimit>> &&
              StopPolicy<AllOf<FaceCount, VertexCount>>);
static_assert(FilterPolicy<NormalFlip, Quadric> && FilterPolicy<HighestDegree, EdgeLength>);
static_assert(FilterPolicy<HeightField, Quadric> && FilterPolicy<SmallestAngle, ColorQuadric> &&
              FilterPolicy<LongestEdge, EdgeLength>);
static_assert(StopPolicy<ShortestEdge> && StopPolicy<AnyOf<FaceCount, TimeBudget>>);

// EdgeLength has no minimum.
static_assert(!PlacementPolicy<OptimalPlacement, EdgeLength>);

// --- The archetypes ------------------------------------------------------------------------------

static_assert(CostPolicy<CostArchetype<>> && CostPolicy<CostArchetype<1>>);
static_assert(PlacementPolicy<PlacementArchetype, Quadric> &&
              PlacementPolicy<PlacementArchetype, CostArchetype<2>>);
static_assert(PairPolicy<PairArchetype>);
static_assert(StopPolicy<StopArchetype>);
static_assert(FilterPolicy<FilterArchetype, Quadric>);

// --- Near misses of a cost: one requirement taken away or changed each
// ----------------------------

namespace cost {

struct NoCopy : CostArchetype<> {
  NoCopy(const NoCopy&) = delete;
};
static_assert(!CostPolicy<NoCopy>);

struct Base {
  struct State {
    void operator+=(const State&) {}
  };
  State face(auto&&, auto&&, auto&&) const { return {}; }
  double operator()(auto&&, auto&&) const { return 0; }
};
struct Whole : Base {
  static constexpr int dimension = 3;
};
static_assert(CostPolicy<Whole>);

static_assert(!CostPolicy<Base>); // no dimension

struct FlatDimension : Base {
  static constexpr int dimension = 2;
};
static_assert(!CostPolicy<FlatDimension>);

struct NegativeDimension : Base {
  static constexpr int dimension = -3;
};
static_assert(!CostPolicy<NegativeDimension>);

struct NoState {
  static constexpr int dimension = 3;
  int face(auto&&, auto&&, auto&&) const { return 0; }
  double operator()(auto&&, auto&&) const { return 0; }
};
static_assert(!CostPolicy<NoState>);

struct StateWithoutSum : Whole {
  struct State {};
  State face(auto&&, auto&&, auto&&) const { return {}; }
};
static_assert(!CostPolicy<StateWithoutSum>);

struct StateWithoutDefault : Whole {
  struct State {
    explicit State(int) {}
    void operator+=(const State&) {}
  };
  State face(auto&&, auto&&, auto&&) const { return State(0); }
};
static_assert(!CostPolicy<StateWithoutDefault>);

struct StateWithoutCopy : Whole {
  struct State {
    State() = default;
    State(State&&) = default;
    State& operator=(State&&) = default;
    void operator+=(const State&) {}
  };
  State face(auto&&, auto&&, auto&&) const { return {}; }
};
static_assert(!CostPolicy<StateWithoutCopy>);

struct NoFace {
  static constexpr int dimension = 3;
  using State = Base::State;
  double operator()(auto&&, auto&&) const { return 0; }
};
static_assert(!CostPolicy<NoFace>);

struct FaceOfTwoCorners : Whole {
  State face(auto&&, auto&&) const { return {}; }
};
static_assert(!CostPolicy<FaceOfTwoCorners>);

struct FaceNotConst : Whole {
  State face(auto&&, auto&&, auto&&) { return {}; }
};
static_assert(!CostPolicy<FaceNotConst>);

struct FaceOfAnotherType : Whole {
  int face(auto&&, auto&&, auto&&) const { return 0; }
};
static_assert(!CostPolicy<FaceOfAnotherType>);

struct NoCost {
  static constexpr int dimension = 3;
  using State = Base::State;
  State face(auto&&, auto&&, auto&&) const { return {}; }
};
static_assert(!CostPolicy<NoCost>);

struct CostOfNothing : NoCost {
  void operator()(auto&&, auto&&) const {}
};
static_assert(!CostPolicy<CostOfNothing>);

struct CostNotConst : NoCost {
  double operator()(auto&&, auto&&) { return 0; }
};
static_assert(!CostPolicy<CostNotConst>);

struct CostOfPositionOnly : NoCost {
  double operator()(auto&&) const { return 0; }
};
static_assert(!CostPolicy<CostOfPositionOnly>);

struct CostInFourDimensions : NoCost {
  double operator()(auto&&, const Vector<4>&) const { return 0; }
};
static_assert(!CostPolicy<CostInFourDimensions>);

} // namespace cost

// --- Near misses of the other concepts -----------------------------------------------------------

namespace placement {

struct NoCopy : PlacementArchetype {
  NoCopy(const NoCopy&) = delete;
};
static_assert(!PlacementPolicy<NoCopy, Quadric>);

struct Nothing {};
static_assert(!PlacementPolicy<Nothing, Quadric>);

struct NotConst {
  auto operator()(auto&&, auto&& pair) { return pair.first; }
};
static_assert(!PlacementPolicy<NotConst, Quadric>);

struct WithoutCost {
  auto operator()(auto&& pair) const -> decltype(pair.first) { return pair.first; }
};
static_assert(!PlacementPolicy<WithoutCost, Quadric>);

struct Number {
  double operator()(auto&&, auto&&) const { return 0; }
};
static_assert(!PlacementPolicy<Number, Quadric>);

struct Maybe {
  auto operator()(auto&&, auto&& pair) const { return std::optional(pair.first); }
};
static_assert(!PlacementPolicy<Maybe, Quadric>);

struct InSpaceOnly {
  Vector<3> operator()(auto&&, auto&&) const { return {}; }
};
static_assert(PlacementPolicy<InSpaceOnly, Quadric>);
static_assert(!PlacementPolicy<InSpaceOnly, ColorQuadric>);

} // namespace placement

namespace pairs {

struct NoCopy : PairArchetype {
  NoCopy(const NoCopy&) = delete;
};
static_assert(!PairPolicy<NoCopy>);

struct Nothing {};
static_assert(!PairPolicy<Nothing>);

struct NotConst {
  void operator()(const SurfaceView&, const EmitPair&) {}
};
static_assert(!PairPolicy<NotConst>);

struct WithoutSurface {
  void operator()(const EmitPair&) const {}
};
static_assert(!PairPolicy<WithoutSurface>);

struct WithoutEmit {
  void operator()(const SurfaceView&) const {}
};
static_assert(!PairPolicy<WithoutEmit>);

struct EmitOfOneIndex {
  void operator()(const SurfaceView&, const std::function<void(std::size_t)>&) const {}
};
static_assert(!PairPolicy<EmitOfOneIndex>);

struct GivesReverse {
  std::vector<int> operator()(const SurfaceView&, const EmitPair&) const { return {}; }
};
static_assert(!PairPolicy<GivesReverse>);

struct ChangesTheSurface {
  void operator()(SurfaceView&, const EmitPair&) const {}
};
static_assert(!PairPolicy<ChangesTheSurface>);

} // namespace pairs

namespace stop {

struct NoCopy : StopArchetype {
  NoCopy(const NoCopy&) = delete;
};
static_assert(!StopPolicy<NoCopy>);

struct Nothing {};
static_assert(!StopPolicy<Nothing>);

struct NotConst {
  bool operator()(const Status&) { return true; }
};
static_assert(!StopPolicy<NotConst>);

struct WithoutStatus {
  bool operator()() const { return true; }
};
static_assert(!StopPolicy<WithoutStatus>);

struct ChangesTheStatus {
  bool operator()(Status&) const { return true; }
};
static_assert(!StopPolicy<ChangesTheStatus>);

struct SaysNothing {
  void operator()(const Status&) const {}
};
static_assert(!StopPolicy<SaysNothing>);

struct OfACount {
  bool operator()(std::size_t) const { return true; }
};
static_assert(!StopPolicy<OfACount>);

} // namespace stop

namespace filter {

struct NoCopy : FilterArchetype {
  NoCopy(const NoCopy&) = delete;
};
static_assert(!FilterPolicy<NoCopy, Quadric>);

struct Nothing {};
static_assert(!FilterPolicy<Nothing, Quadric>);

struct NotConst {
  bool allows(auto&&) { return true; }
};
static_assert(!FilterPolicy<NotConst, Quadric>);

struct SaysNothing {
  void allows(auto&&) const {}
};
static_assert(!FilterPolicy<SaysNothing, Quadric>);

struct WithoutContraction {
  bool allows() const { return true; }
};
static_assert(!FilterPolicy<WithoutContraction, Quadric>);

struct ACall {
  bool operator()(auto&&) const { return true; }
};
static_assert(!FilterPolicy<ACall, Quadric>);

} // namespace filter

// --- What an argument is taken for ---------------------------------------------------------------

namespace {

using internal::Kind;
template <class T>
constexpr Kind kind = internal::kind_of<T, Quadric>();

// Generic callables: what they give back tells them apart.
constexpr auto placing = [](const auto&, const auto& pair) { return pair.first; };
constexpr auto stopping = [](const auto& status) { return status.faces < 3; };
constexpr auto pairing = [](const SurfaceView&, const auto& emit) { emit(0, 1); };

static_assert(kind<decltype(placing)> == Kind::placement);
static_assert(kind<decltype(stopping)> == Kind::stop);
static_assert(kind<decltype(pairing)> == Kind::pairs);
static_assert(kind<CostArchetype<>> == Kind::cost && kind<ColorQuadric> == Kind::cost);
static_assert(kind<FilterArchetype> == Kind::filter && kind<Topology> == Kind::topology);
static_assert(kind<OptimalPlacement> == Kind::placement &&
              internal::kind_of<OptimalPlacement, EdgeLength>() == Kind::placement);
static_assert(kind<cost::NoFace> == Kind::unknown && kind<int> == Kind::unknown);
static_assert(kind<decltype(CGAL::parameters::vertex_point_map(0))> == Kind::named_parameters);

} // namespace

// --- Running -------------------------------------------------------------------------------------

namespace {

struct Run {
  Soup surface;
  Report report;
};

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven>
Run simplified_mesh(const Soup& soup, const auto&... arguments) {
  Mesh mesh = make_mesh(soup);
  const Report report = simplify<Cost, Placement>(mesh, arguments...);
  mesh.collect_garbage();
  CHECK(is_valid_triangle_mesh(mesh));
  return {to_soup(mesh), report};
}

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven>
Run simplified_soup(Soup soup, const auto&... arguments) {
  std::vector<Point> points = test::points_of(soup);
  const Report report = simplify<Cost, Placement>(points, soup.triangles, arguments...);
  soup.points.clear();
  for (const Point& p : points)
    soup.points.push_back(to_position(p));
  return {soup, report};
}

// Constant values for the one attribute of a CostArchetype<1>.
struct One {
  using key_type = std::size_t;
  using value_type = double;
  using reference = double;
  using category = boost::read_write_property_map_tag;
  friend double get(const One&, const auto&) { return 1; }
  friend void put(const One&, const auto&, double value) { CHECK(value == 1); }
};

} // namespace

TEST_CASE("The least policies that model the concepts do for simplify") {
  const Soup soup = sphere(2);
  const CostArchetype<> cost;
  const PlacementArchetype placement;
  const PairArchetype pairs;
  const StopArchetype stop;
  const FilterArchetype filter;

  SECTION("a cost") {
    CHECK(simplified_mesh<CostArchetype<>, MidpointPlacement>(soup).report.faces_after == 64);
    CHECK(simplified_soup<CostArchetype<>, EndpointPlacement>(soup).report.faces_after == 64);
    CHECK(simplified_mesh(soup, cost, MidpointPlacement{}).report.faces_after == 64);
    CHECK(simplified_soup(soup, MidpointPlacement{}, cost).report.faces_after == 64);
  }
  SECTION("a cost in more dimensions") {
    const auto map = quadrille::parameters::vertex_attribute_map(One());
    const CostArchetype<1> wide;
    CHECK(simplified_mesh(soup, wide, MidpointPlacement{}, map).report.faces_after == 64);
    CHECK(simplified_soup(soup, wide, EndpointPlacement{}, map).report.faces_after == 64);
  }
  SECTION("a placement") {
    const Run run = simplified_mesh<Quadric, PlacementArchetype>(soup);
    CHECK(run.report.faces_after == 64);
    CHECK(simplified_soup(soup, placement).report.faces_after == 64);
    for (const Position& p : run.surface.points)
      CHECK(std::find(soup.points.begin(), soup.points.end(), p) != soup.points.end());
  }
  SECTION("pairs, without the edges") {
    const Run run = simplified_mesh(soup, pairs, FaceCount{100});
    CHECK(run.report.faces_after <= 100);
    CHECK(simplified_soup(soup, pairs, FaceCount{100}).report.faces_after <= 100);
  }
  SECTION("a stop") {
    CHECK(simplified_mesh(soup, stop).report.faces_after == 8);
    CHECK(simplified_soup(soup, stop).report.faces_after <= 8);
    CHECK(simplified_mesh(soup, AnyOf(stop)).report.faces_after == 8);
    CHECK(simplified_mesh(soup, AllOf(stop, stop)).report.faces_after == 8);
  }
  SECTION("a filter") {
    CHECK(simplified_mesh(soup, filter).report.faces_after == 64);
    CHECK(simplified_soup(soup, filter, filter).report.faces_after == 64);
  }
  SECTION("all of them, in any order") {
    const NormalFlip any(180);
    CHECK(simplified_mesh(soup, filter, stop, pairs, placement, any, cost).report.faces_after <= 8);
    CHECK(simplified_soup(soup, cost, any, placement, pairs, stop, filter).report.faces_after <= 8);
  }
}

TEST_CASE("Generic callables are policies") {
  const Soup soup = sphere(1);
  CHECK(simplified_mesh(soup, placing, stopping).report.faces_after == 4);
  CHECK(simplified_soup(soup, stopping, placing, Topology::kept).report.faces_after == 4);
  CHECK(simplified_mesh(soup, pairing, FaceCount{0}).report.contractions == 1);
}

struct BadFilter {
  bool allows(const auto&) const { return true; }
  void validate() const { throw std::invalid_argument("bad filter"); }
};
struct BadPlacement {
  auto operator()(const auto&, const auto& pair) const { return pair.first; }
  void validate() const { throw std::invalid_argument("bad placement"); }
};

TEST_CASE("A placement and a filter that make no sense are refused before anything is changed") {
  Mesh mesh = make_mesh(octahedron());
  CHECK_THROWS_WITH(simplify(mesh, BadFilter{}), "bad filter");
  CHECK_THROWS_WITH(simplify(mesh, BadPlacement{}), "bad placement");
  CHECK(mesh.number_of_faces() == 8);
}

TEST_CASE("A pair policy that names a vertex that is not there is an error") {
  Mesh mesh = make_mesh(octahedron());
  const auto beyond = [](const SurfaceView& surface, const EmitPair& emit) {
    emit(0, surface.points.size());
  };
  CHECK_THROWS_AS(simplify(mesh, beyond), std::out_of_range);
  CHECK_THROWS_WITH(simplify(mesh, beyond), Catch::Contains("0 and 6 of 6"));
  CHECK(mesh.number_of_faces() == 8);
}

struct NoNumber : CostArchetype<> {
  double operator()(auto&&, auto&&) const {
    return -std::numeric_limits<double>::quiet_NaN(); // as 0 / 0 is on most machines
  }
};

TEST_CASE("A position or a cost that is no number refuses the contraction") {
  const Soup soup = sphere(2);
  const auto nowhere = [](const auto&, const auto& pair) {
    auto p = pair.first;
    p[1] = std::numeric_limits<double>::quiet_NaN();
    return p;
  };
  const Run placed = simplified_mesh(soup, nowhere);
  CHECK(placed.report.contractions == 0);
  CHECK(placed.report.stop == StopReason::all_pairs_rejected);
  CHECK(placed.report.rejected(Rejection::position) == 3 * 128 / 2);

  const Run run = simplified_mesh(soup, NoNumber(), MidpointPlacement{});
  CHECK(run.report.contractions == 0);
  CHECK(run.report.rejected(Rejection::position) == 3 * 128 / 2);
}
