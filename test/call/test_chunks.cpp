// Pieces of a surface that are simplified apart fit as they did before, and cost what they do in
// the whole.
#include "chunks.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using internal::Box;
using internal::Chunk;
using internal::CostHistogram;
using internal::simplify_chunk;
using test::Position;
using test::Soup;
using test::SoupTopology;
using test::topology_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Cost>
Chunk<Cost> whole(const Soup& soup) {
  Chunk<Cost> piece;
  piece.positions = soup.points;
  piece.triangles = soup.triangles;
  piece.box = Box<3>(soup.points);
  return piece;
}

Soup terrain(std::uint64_t seed, std::uint32_t size = 24) {
  return test::mapped(test::with_noise(test::grid(size, size), seed, 0.004), [](const Position& p) {
    return Position{{p[0], p[1], p[2] + 0.1 * std::sin(7 * p[0]) * std::cos(5 * p[1])}};
  });
}

// The cost up to which a run over the whole takes that many faces.
template <class Cost>
CostLimit limit_for(const Soup& soup, std::size_t faces, const Cost& cost) {
  const auto left = simplify_chunk(whole<Cost>(soup), cost, OptimalPlacement{}, FaceCount{4});
  return internal::cost_limit(cost, Box<3>(soup.points),
                              static_cast<double>(left.costs.cost_for(faces)));
}

template <class Cost, class... Policies>
Soup in_phases(const Soup& soup, std::uint32_t parts, const CostLimit& limit, int phases,
               const Policies&... policies) {
  test::Sewn<Cost> surface{soup, {}};
  CostHistogram costs;
  constexpr std::array shares{0.5, 0.36, 0.62};
  for (int phase = 0; phase < phases; ++phase)
    surface = simplified_in_chunks(
        surface, kd_chunks(surface.soup, parts, shares[static_cast<std::size_t>(phase) % 3]),
        Box<3>(soup.points), costs, Cost{}, OptimalPlacement{}, limit, policies...);
  return surface.soup;
}

} // namespace

TEMPLATE_TEST_CASE("Pieces that are simplified apart fit", "", Quadric, MemorylessQuadric) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const Soup& soup :
         {test::random_closed(seed), terrain(seed), test::plate_with_holes(3, 3)}) {
      const SoupTopology before = topology_of(soup);
      for (double ratio : {0.5, 0.95}) {
        const CostLimit limit = limit_for(
            soup, static_cast<std::size_t>(ratio * static_cast<double>(soup.triangles.size())),
            TestType{});
        for (std::uint32_t parts : {2u, 5u, 16u}) {
          INFO("seed " << seed << ", limit for " << ratio << ", " << parts << " parts, " << before);
          const Soup left = in_phases<TestType>(soup, parts, limit, 3);
          const SoupTopology after = topology_of(left);
          INFO(after);
          CHECK(is_same_topology(before, after));
          CHECK_FALSE(after.has_duplicate_faces);
          CHECK((parts == 16 || left.triangles.size() < soup.triangles.size()));
        }
      }
    }
  }
}

TEST_CASE(
    "Pieces of a surface fit in passes, with numbers of any order, where vertices are renumbered") {
  const Soup soup = test::shuffled(test::with_noise(test::sphere(6), 3, 0.001), 7);
  const CostLimit limit = limit_for(soup, soup.triangles.size() * 9 / 10, MemorylessQuadric{});
  for (const bool refresh : {false, true}) {
    const Soup left =
        in_phases<MemorylessQuadric>(soup, 2, limit, 2, RelaxedOrder{.refresh = refresh});
    const SoupTopology after = topology_of(left);
    INFO(after);
    CHECK(is_same_topology(topology_of(soup), after));
    CHECK(left.triangles.size() < soup.triangles.size() / 8);
  }
}

TEST_CASE("No edge comes about between two shared vertices") {
  // A strip of two squares, cut open at the bottom and the top: 1 and 4 are joined by the vertex
  // inside only, which costs nothing to contract into either.
  //   3---4---5
  //   | \ | / |
  //   |   6   |
  //   | / | \ |
  //   0---1---2
  Chunk<Quadric> piece;
  piece.positions = {{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}},  {{0, 1, 0}},
                     {{1, 1, 0}}, {{2, 1, 0}}, {{1, 0.5, 0}}};
  piece.triangles = {{0, 1, 6}, {1, 2, 6}, {2, 5, 6}, {5, 4, 6}, {4, 3, 6}, {3, 0, 6}};
  piece.is_shared = {true, true, true, true, true, true, false};
  piece.box = Box<3>(piece.positions);
  const auto left = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, CostLimit{infinity});
  CHECK(left.triangles.size() == 6);
  CHECK(left.report.rejected(Rejection::chord) > 0);

  piece.is_shared = {false, true, false, false, false, false, false};
  CHECK(simplify_chunk(piece, Quadric{}, OptimalPlacement{}, CostLimit{0.01}).triangles.size() < 6);
}

TEST_CASE("No face comes about between three shared vertices") {
  Chunk<Quadric> piece; // another piece may have the other side of it
  piece.positions = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0.3, 0.3, 0}}};
  piece.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  piece.is_shared = {true, true, true, false};
  piece.box = Box<3>(piece.positions);
  CHECK(
      simplify_chunk(piece, Quadric{}, OptimalPlacement{}, CostLimit{infinity}).triangles.size() ==
      3);
}

TEMPLATE_TEST_CASE("What shared vertices remember adds up to what they do in the whole", "",
                   Quadric, ThinFeatureQuadric) {
  const Soup soup = terrain(5);
  const FaceCount all{soup.triangles.size()};
  const auto in_core = simplify_chunk(whole<TestType>(soup), TestType{}, OptimalPlacement{}, all);
  REQUIRE(in_core.states.size() == soup.points.size());
  CostHistogram costs;
  test::Sewn<TestType> sewn{soup, {}};
  const auto form = [](const auto& state) {
    if constexpr (requires { state.planes; })
      return state.planes;
    else
      return state;
  };
  for (int phase = 0; phase < 3; ++phase) { // whose gains are nothing after the first
    const auto parts = kd_chunks(sewn.soup, 7, 0.5 + 0.1 * phase);
    sewn = simplified_in_chunks(sewn, parts, Box<3>(soup.points), costs, TestType{},
                                OptimalPlacement{}, all);
    REQUIRE(sewn.states.size() == soup.points.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      std::size_t w = 0; // the same point, in the whole
      while (!(soup.points[w] == sewn.soup.points[v]))
        ++w;
      const auto a = form(in_core.states[w]), b = form(sewn.states[v]);
      CHECK(b.trace() == Approx(a.trace()));
      CHECK(b(Position{{0.3, -0.2, 5}}) == Approx(a(Position{{0.3, -0.2, 5}})));
    }
  }
}

TEST_CASE("Edges of one face are borders unless both ends are shared, and if they are named") {
  // What it costs to move the ends of an edge of one face along its face, by the named borders.
  const auto trace = [](std::vector<bool> is_shared,
                        std::vector<std::array<internal::Index, 2>> borders) {
    Chunk<Quadric> piece = whole<Quadric>(test::triangle());
    piece.is_shared = std::move(is_shared);
    piece.boundaries = std::move(borders);
    const auto left = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, FaceCount{1});
    return left.states[0].trace();
  };
  const double none = trace({true, true, true}, {});
  CHECK(none == Approx(trace({true, true, true}, {{1, 2}})));
  CHECK(none < trace({true, true, true}, {{1, 0}}));
  CHECK(trace({true, true, true}, {{0, 1}, {2, 0}}) == Approx(trace({}, {})));
  CHECK(trace({true, true, true}, {{1, 0}}) == Approx(trace({true, false, true}, {})));
}

TEST_CASE("Nothing is pulled to a seam") {
  // Planes along the seam would weigh in errors and tie breaks of what goes to it.
  const Soup soup = terrain(4, 16);
  const CostLimit limit = limit_for(soup, soup.triangles.size() * 8 / 10, MemorylessQuadric{});
  const auto count = [&](double weight) {
    test::Sewn<MemorylessQuadric> surface{soup, {}};
    CostHistogram costs;
    MemorylessQuadric cost;
    cost.boundary_weight = weight;
    auto pieces = cut(surface, kd_chunks(soup, 4, 0.5), Box<3>(soup.points));
    auto& piece = pieces.front().piece;
    piece.boundaries.clear();
    piece.is_shared.assign(piece.is_shared.size(), false);
    std::vector<int> faces(piece.positions.size() * piece.positions.size());
    for (const auto& t : piece.triangles) // all of its edges of one face are seams
      for (std::size_t i = 0; i < 3; ++i)
        ++faces[std::max(t[i], t[(i + 1) % 3]) * piece.positions.size() +
                std::min(t[i], t[(i + 1) % 3])];
    for (std::size_t e = 0; e < faces.size(); ++e)
      if (faces[e] == 1)
        piece.is_shared[e / piece.positions.size()] = piece.is_shared[e % piece.positions.size()] =
            true;
    double sum = 0;
    const AnyOf stop{limit, [&sum](const Status& status) {
                       sum += status.next_error;
                       return false;
                     }};
    const auto left = simplify_chunk(piece, cost, OptimalPlacement{}, stop);
    return std::pair(left.positions, sum);
  };
  CHECK(count(0) == count(1e6));
}

TEST_CASE("A box that is given decides about the units") {
  const Soup near = test::with_noise(test::sphere(3), 2, 0.01);
  Soup far = near; // whose box is 1000 times as large
  far = joined(far, test::triangle(), {{1000, -20, 3}});
  const FaceCount target{far.triangles.size() - 300};
  const auto in_whole = simplify_chunk(whole<MemorylessQuadric>(far), MemorylessQuadric{},
                                       OptimalPlacement{}, target);
  Chunk<MemorylessQuadric> piece = whole<MemorylessQuadric>(near);
  const auto own = simplify_chunk(piece, MemorylessQuadric{}, OptimalPlacement{},
                                  FaceCount{near.triangles.size() - 300});
  piece.box = Box<3>(far.points);
  const auto alone = simplify_chunk(std::move(piece), MemorylessQuadric{}, OptimalPlacement{},
                                    FaceCount{near.triangles.size() - 300});
  CHECK(std::equal(alone.positions.begin(), alone.positions.end(), in_whole.positions.begin()));
  CHECK(std::ranges::equal(alone.costs.counters(), in_whole.costs.counters()));
  CHECK_FALSE(std::ranges::equal(alone.costs.counters(), own.costs.counters()));
}

TEST_CASE("What pieces remember in the next phase is all that they did") {
  const Soup soup = test::with_noise(test::sphere(4), 5, 0.01);
  const CostLimit limit = limit_for(soup, soup.triangles.size() * 8 / 10, Quadric{});
  const auto first = simplify_chunk(whole<Quadric>(soup), Quadric{}, OptimalPlacement{}, limit);
  Chunk<Quadric> piece;
  piece.positions = first.positions;
  piece.triangles = first.triangles;
  piece.box = Box<3>(soup.points);
  const auto forgetful = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, limit);
  piece.states = first.states;
  const auto knowing = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, limit);
  CHECK(knowing.report.contractions < first.report.contractions / 100);
  CHECK(forgetful.report.contractions > 3 * knowing.report.contractions + 10);
  piece.has_state.assign(piece.positions.size(), false); // none is given then
  CHECK(simplify_chunk(piece, Quadric{}, OptimalPlacement{}, limit).positions ==
        forgetful.positions);
}

TEST_CASE("A histogram counts the faces that contractions take, by what these cost") {
  const Soup soup = terrain(9);
  CostHistogram sum;
  for (const bool in_passes : {false, true}) {
    AnyOrder order = GreedyOrder{};
    if (in_passes)
      order = RelaxedOrder{};
    const auto left = simplify_chunk(whole<MemorylessQuadric>(soup), MemorylessQuadric{},
                                     OptimalPlacement{}, FaceCount{100}, order);
    CHECK(left.costs.total() == soup.triangles.size() - left.triangles.size());
    CHECK(left.costs.up_to(std::numeric_limits<float>::max()) == left.costs.total());
    const std::uint64_t half = left.costs.total() / 2;
    const float cost = left.costs.cost_for(half);
    CHECK(left.costs.up_to(cost) >= half);
    CHECK(left.costs.up_to(0.96f * cost) < half);
    CHECK(left.costs.cost_for(left.costs.total() + 1) == std::numeric_limits<float>::infinity());
    sum += left.costs;
    CHECK(sum.total() == (in_passes ? 2 : 1) * left.costs.total());
  }
  CostHistogram few;
  few.add(-1, 1);
  few.add(std::numeric_limits<float>::quiet_NaN(), 1);
  few.add(0, 1);
  few.add(1, 10);
  few.add_in_pass(1.02f, 10);
  few.add(1.04f, 100);
  CHECK(few.up_to(0) == 3);
  CHECK(few.up_to(1) == 23);
  CHECK(few.cost_for(23) == Approx(1.03125));
  CHECK(few.cost_for(24) == Approx(1.0625));
}

TEST_CASE("A limit from a histogram leaves about as many faces") {
  const Soup soup = test::with_noise(test::sphere(4), 5, 0.01);
  for (const double ratio : {0.3, 0.6, 0.9}) {
    const auto wanted =
        static_cast<std::size_t>(ratio * static_cast<double>(soup.triangles.size()));
    const CostLimit limit = limit_for(soup, wanted, MemorylessQuadric{});
    const auto left = simplify_chunk(whole<MemorylessQuadric>(soup), MemorylessQuadric{},
                                     OptimalPlacement{}, limit);
    CHECK(static_cast<double>(left.costs.total()) == Approx(double(wanted)).epsilon(0.05));
    CHECK(left.report.stop == StopReason::target_met);
  }
}

TEST_CASE("The faces up to a cost are those that a run up to it takes") {
  const Soup soup = test::with_noise(test::sphere(4), 6, 0.01);
  const auto full =
      simplify_chunk(whole<Quadric>(soup), Quadric{}, OptimalPlacement{}, FaceCount{4});
  for (const std::size_t faces : {200u, 700u, 1300u, 1900u}) {
    const float key = full.costs.cost_for(faces);
    const CostLimit limit =
        internal::cost_limit(Quadric{}, Box<3>(soup.points), static_cast<double>(key));
    const auto left = simplify_chunk(whole<Quadric>(soup), Quadric{}, OptimalPlacement{}, limit);
    CHECK(left.costs.total() == full.costs.up_to(key));
  }
}

TEST_CASE("Faces of a piece go on with how far they and their input points are") {
  using internal::FaceBound;
  const Soup soup = test::shuffled(terrain(3, 40), 5);
  const auto run = [&](std::vector<FaceBound> bounds, const auto& order) {
    Chunk<MemorylessQuadric> piece = whole<MemorylessQuadric>(soup);
    piece.bounds = std::move(bounds);
    return simplify_chunk(std::move(piece), MemorylessQuadric{}, OptimalPlacement{},
                          HausdorffLimit(0.01), order);
  };
  const auto require = [&](const auto& order) {
    const auto result = run({}, order);
    REQUIRE(result.bounds.size() == result.triangles.size());
    FaceBound most;
    for (const FaceBound& b : result.bounds) {
      most.from_input = std::max(most.from_input, b.from_input);
      most.to_input = std::max(most.to_input, b.to_input);
    }
    const double unit = result.report.distance_bound / static_cast<double>(most.from_input);
    CHECK(std::exp2(std::round(std::log2(unit))) == unit);
    CHECK(result.report.hausdorff_bound ==
          unit * static_cast<double>(std::max(most.from_input, most.to_input)));
    const auto begun_at = [&](double from, double to) {
      const auto as_float = [&](double length) { return static_cast<float>(length / unit); };
      return run(std::vector<FaceBound>(soup.triangles.size(), {as_float(from), as_float(to)}),
                 order);
    };
    CHECK(begun_at(0.0101, 0).report.contractions == 0);
    CHECK(begun_at(0, 0.0101).report.contractions == 0);
    for (const auto& later : {begun_at(0.006, 0), begun_at(0, 0.006)}) {
      CHECK(later.report.contractions > 0);
      CHECK(later.report.contractions < result.report.contractions);
      CHECK(later.report.hausdorff_bound > 0.006);
      CHECK(later.report.hausdorff_bound <= 0.01);
    }
  };
  require(GreedyOrder{});
  require(RelaxedOrder{});
  CHECK_THROWS_WITH(run(std::vector<FaceBound>(3), GreedyOrder{}), Catch::Contains("3 bounds"));
}

TEST_CASE("Faces of a piece go on with their tolerances and what they have used of them") {
  const Soup soup = test::shuffled(terrain(3, 40), 5);
  const auto run = [](Chunk<MemorylessQuadric> piece) {
    return simplify_chunk(std::move(piece), MemorylessQuadric{}, OptimalPlacement{},
                          ToleranceLimit{});
  };
  Chunk<MemorylessQuadric> by_vertices = whole<MemorylessQuadric>(soup);
  for (const Position& p : soup.points)
    by_vertices.tolerances.push_back(p[0] < 0.5 ? 0.002 : 0.02);
  const auto once = run(by_vertices);
  CHECK(once.report.hausdorff_bound == Approx(0.02 * once.report.used_tolerance->fraction));
  float fine = std::numeric_limits<float>::infinity();
  for (const internal::FaceBound& b : once.bounds)
    fine = std::min(fine, b.tolerance);
  std::array<std::size_t, 2> counts{};
  for (const internal::FaceBound& b : once.bounds)
    ++counts[b.tolerance == fine ? 0 : 1];
  CHECK(counts[0] > counts[1]);
  CHECK(counts[1] > 10);

  // Faces that have used nothing know what their vertices allow, and all is the same.
  Chunk<MemorylessQuadric> by_faces = whole<MemorylessQuadric>(soup);
  by_faces.greatest_tolerance = 0.02;
  for (const test::Triangle& t : soup.triangles) {
    const bool is_fine = std::any_of(
        t.begin(), t.end(), [&](std::uint32_t v) { return by_vertices.tolerances[v] == 0.002; });
    by_faces.bounds.push_back({0, 0, is_fine ? fine : 10 * fine});
  }
  const auto same = run(by_faces);
  CHECK(same.triangles == once.triangles);
  CHECK(same.report.hausdorff_bound == Approx(once.report.hausdorff_bound));
  for (internal::FaceBound& b : by_faces.bounds)
    b.from_input = 0.6F;
  const auto later = run(by_faces);
  CHECK(later.report.contractions > 0);
  CHECK(later.report.contractions < once.report.contractions);
  CHECK(later.report.used_tolerance->fraction > 0.6);
  CHECK(later.report.used_tolerance->fraction <= 1);
  CHECK_THROWS_WITH(run(whole<MemorylessQuadric>(soup)), Catch::Contains("no tolerances"));
}

TEST_CASE("Points and faces of a piece's result tell what they were") {
  const Soup soup = terrain(3);
  auto pieces = cut(test::Sewn<Quadric>{soup, {}}, kd_chunks(soup, 3, 0.5), Box<3>(soup.points));
  Chunk<Quadric>& piece = pieces[1].piece;
  piece.is_fixed.assign(piece.positions.size(), false);
  std::size_t fixed = 0;
  for (std::size_t v = 0; v < piece.positions.size(); v += 50)
    piece.is_fixed[v] = true;
  piece.labels.assign(piece.triangles.size(), 7);
  for (std::size_t f = 0; f < piece.triangles.size() / 2; ++f)
    piece.labels[f] = 1000;
  const auto left = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, FaceCount{100});
  REQUIRE(left.vertices.size() == left.positions.size());
  CHECK(std::is_sorted(left.vertices.begin(), left.vertices.end()));
  for (std::size_t i = 0; i < left.vertices.size(); ++i)
    if (const auto v = left.vertices[i]; piece.is_shared[v] || piece.is_fixed[v]) {
      CHECK(left.positions[i] == piece.positions[v]);
      fixed += piece.is_fixed[v];
    }
  CHECK(fixed ==
        static_cast<std::size_t>(std::count(piece.is_fixed.begin(), piece.is_fixed.end(), true)));
  REQUIRE(left.faces.size() == left.triangles.size());
  CHECK(std::is_sorted(left.faces.begin(), left.faces.end()));
  CHECK(piece.labels[left.faces.front()] != piece.labels[left.faces.back()]);
}

TEST_CASE("Channels of a piece go along, and stay at shared vertices") {
  const Soup soup = terrain(6);
  auto pieces = cut(test::Sewn<Quadric>{soup, {}}, kd_chunks(soup, 2, 0.5), Box<3>(soup.points));
  const Chunk<Quadric>& piece = pieces[0].piece;
  internal::ChunkChannels channels{
      {{2, {}, {.weights = {0.1, 0.1}}}, {1, {}, {.weights = {0.01}}}}};
  for (const Position& p : piece.positions) {
    channels.channels[0].values.insert(channels.channels[0].values.end(),
                                       {p[0] + 2 * p[1], 3 - p[0]});
    channels.channels[1].values.push_back(p[1]);
  }
  const auto left = simplify_chunk(piece, Quadric{}, OptimalPlacement{}, FaceCount{200}, channels);
  REQUIRE(left.channels.size() == 2);
  REQUIRE(left.channels[0].size() == 2 * left.positions.size());
  REQUIRE(left.channels[1].size() == left.positions.size());
  for (std::size_t i = 0; i < left.positions.size(); ++i) {
    const Position& p = left.positions[i];
    CHECK(left.channels[0][2 * i] == Approx(p[0] + 2 * p[1]).margin(0.01));
    CHECK(left.channels[0][2 * i + 1] == Approx(3 - p[0]).margin(0.01));
    if (const auto v = left.vertices[i]; piece.is_shared[v]) {
      CHECK(left.channels[0][2 * i] == channels.channels[0].values[2 * v]);
      CHECK(left.channels[1][i] == channels.channels[1].values[v]);
    }
  }
  channels.channels[1].values.pop_back();
  CHECK_THROWS_WITH(simplify_chunk(piece, Quadric{}, OptimalPlacement{}, FaceCount{200}, channels),
                    Catch::Contains("a channel of a tile has"));
}

TEST_CASE("A piece that makes no sense is refused") {
  const auto refuses = [](Chunk<Quadric> piece, const std::string& why) {
    CHECK_THROWS_WITH(simplify_chunk(std::move(piece), Quadric{}, OptimalPlacement{}, FaceCount{1}),
                      Catch::Contains(why));
  };
  const Chunk<Quadric> good = whole<Quadric>(test::two_triangles());
  Chunk<Quadric> bad = good;
  bad.is_shared = {true};
  refuses(bad, "1 values of is_shared, not 4");
  bad = good;
  bad.is_fixed = {true, false};
  refuses(bad, "2 values of is_fixed, not 4");
  bad = good;
  bad.states.resize(5);
  refuses(bad, "5 states, not 4");
  bad = good;
  bad.states.resize(4);
  bad.has_state = {true};
  refuses(bad, "1 values of has_state, not 4");
  bad = good;
  bad.labels = {0, 1, 0};
  refuses(bad, "3 labels, not 2");
  bad = good;
  bad.tolerances = {1};
  refuses(bad, "1 tolerances, not 4");
  bad = good;
  bad.boundaries = {{0, 4}};
  refuses(bad, "a border of a tile refers to point 4 of 4");
  bad = good;
  bad.triangles[1][2] = 9;
  refuses(bad, "names point 9");
  bad = good;
  bad.positions[2][0] = infinity;
  refuses(bad, "vertex 2 is not finite");
  bad = good;
  bad.box.high[0] = -1;
  refuses(bad, "is not a box");
  bad = good;
  bad.box = Box<3>(Position{}, Position{{0.1, 0.1, 0.1}});
  refuses(bad, "is not inside bounding_box");
}
