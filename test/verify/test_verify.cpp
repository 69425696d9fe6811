// verify() finds what is broken of a claim, and nothing where claims hold.
#include "damage.h"
#include "farthest.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/verify.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;
using test::Triangle;

Verdict verify_soups(const Soup& input, const Soup& result, const Claims& claims) {
  return verify(test::points_of(input), input.triangles, test::points_of(result), result.triangles,
                claims);
}

const Finding& finding(const Verdict& verdict, const std::string& claim) {
  for (const Finding& finding : verdict.findings)
    if (finding.claim == claim)
      return finding;
  throw std::logic_error("nothing of " + claim);
}

std::size_t pairs_of(const Soup& soup) {
  return static_cast<std::size_t>(finding(verify_soups(soup, soup, {.no_self_intersection = true}),
                                          "intersecting pairs of faces")
                                      .measured);
}

/// By CGAL, of a mesh.
std::size_t pairs_by_cgal(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> points;
  for (const Position& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  CGAL::Surface_mesh<Point> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  std::vector<std::pair<decltype(mesh)::Face_index, decltype(mesh)::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return static_cast<std::size_t>(std::count_if( // without faces that have no area
      pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first != pair.second; }));
}

Soup scaled(Soup soup, double scale) {
  for (Position& p : soup.points)
    p = scale * p;
  return soup;
}

/// Two cubes with an edge in common, of which each has faces of its own.
Soup cubes_on_an_edge() {
  Soup soup =
      test::surface_of_cubes(2, 2, 1, [](int x, int y, int) { return x == y; }); // on one diagonal
  return soup;
}

} // namespace

TEST_CASE("verify: what a simplification promises is held") {
  const test::Mesh input = test::make_mesh(test::sphere(3));
  test::Mesh result = input;
  const Report report =
      simplify(result, DistanceLimit::relative(0.01), NoSelfIntersection{}, Topology::kept);
  REQUIRE(report.faces_after < report.faces_before);
  result.collect_garbage();
  const Verdict verdict = verify(input, result,
                                 {.distance = report.distance_bound,
                                  .distance_both_ways = 4 * report.distance_bound,
                                  .no_self_intersection = true,
                                  .solid = true});
  INFO(verdict);
  CHECK(verdict);
  CHECK(verdict.findings.size() == 9);
  const Finding& distance = finding(verdict, "distance of the result from the input");
  CHECK(distance.promised == report.distance_bound);
  CHECK(distance.measured > 0.1 * report.distance_bound);
  std::ostringstream text;
  text << verdict;
  CHECK(text.str().find("BROKEN") == std::string::npos);
  CHECK(text.str().find("; open edges: 0 promised, 0 measured;") != std::string::npos);
}

TEST_CASE("verify: nothing claimed is nothing found") {
  const Verdict verdict = verify_soups(test::tetrahedron(), test::octahedron(), {});
  CHECK(verdict.findings.empty());
  CHECK(verdict.is_met());
}

TEST_CASE("verify: a moved vertex breaks a distance, and only what looks that way") {
  Soup input = test::grid(8, 8), bump = input;
  bump.points[40][2] += 0.25;
  const auto distances = [](const Soup& a, const Soup& b, double d) {
    return verify_soups(a, b, {.distance_both_ways = d});
  };
  CHECK(distances(input, bump, 0.26));
  const Verdict broken = distances(input, bump, 0.2);
  CHECK_FALSE(broken);
  const Finding& there = finding(broken, "distance of the result from the input");
  CHECK_FALSE(there.is_met);
  CHECK(std::abs(there.measured - 0.25) <= there.error);
  std::ostringstream text;
  text << broken;
  CHECK(text.str().find("BROKEN") != std::string::npos);

  Soup part = input; // the result has lost a part: all that is left lies on the input
  std::erase_if(part.triangles, [&](const Triangle& t) { return input.points[t[0]][0] > 0.49; });
  const Verdict lost = distances(input, part, 0.2);
  CHECK(finding(lost, "distance of the result from the input").is_met);
  CHECK_FALSE(finding(lost, "distance of the input from the result").is_met);
  CHECK(verify_soups(input, part, {.distance = 0.2}));
}

TEST_CASE("verify: tolerances and normals of a simplification are kept, and not much less") {
  const test::Mesh input = test::make_mesh(test::sphere(3));
  std::vector<double> tolerances;
  for (const auto v : vertices(input))
    tolerances.push_back(0.05 * std::pow(10, input.point(v).x()));
  const auto tolerance = CGAL::make_property_map(tolerances);
  std::vector<test::Mesh::Vertex_index> images(tolerances.size());
  const auto image = CGAL::make_property_map(images);
  test::Mesh result = input;
  const Report report = simplify(
      result, ToleranceLimit{}, NormalDeviation{40}, Topology::kept,
      parameters::vertex_to_vertex_map(image, parameters::vertex_tolerance_map(tolerance)));
  REQUIRE(5 * report.faces_after < 4 * report.faces_before);
  const auto verified = [&](double part, double degrees) {
    std::vector<double> parts = tolerances;
    for (double& t : parts)
      t *= part;
    const auto map = CGAL::make_property_map(parts);
    return verify(input, result, {.normal_deviation = degrees},
                  parameters::vertex_to_vertex_map(image, parameters::vertex_tolerance_map(map)));
  };
  const Verdict verdict = verified(1, *report.normal_bound_degrees);
  INFO(verdict);
  CHECK(verdict);
  REQUIRE(verdict.findings.size() == 4);
  CHECK(verdict.findings[2].measured > *report.normal_bound_degrees / 2);
  const Verdict less = verified(0.1, verdict.findings[2].measured / 1.01);
  INFO(less);
  CHECK_FALSE(less.findings[0].is_met);
  CHECK_FALSE(less.findings[1].is_met);
  CHECK_FALSE(less.findings[2].is_met);
}

TEST_CASE("verify: a tolerance is that of an input face, one way and the other") {
  const Soup input = test::grid(8, 8);
  Soup bump = input;
  bump.points[40][2] += 0.1;
  Claims claims{.tolerances = std::vector<double>(input.points.size(), 1)};
  claims.tolerances[0] = 0; // where nothing has changed
  CHECK(verify_soups(input, bump, claims));
  claims.tolerances[40] = 0.05; // the next faces allow the bump, but their points do not need it
  const Verdict verdict = verify_soups(input, bump, claims);
  REQUIRE(verdict.findings.size() == 2);
  CHECK_FALSE(verdict.findings[0].is_met);
  CHECK(verdict.findings[0].measured > 0.01);
  CHECK(verdict.findings[1].is_met);
  CHECK(verdict.findings[1].measured == 0);
  claims.tolerances.assign(input.points.size(), 0.09);
  claims.tolerances[0] = std::numeric_limits<double>::infinity();
  CHECK_FALSE(verify_soups(input, bump, claims).findings[1].is_met);
  CHECK(std::abs(verify_soups(input, bump, claims).findings[1].measured - 0.01) < 1e-9);
  // What is flat needs no tolerance, however it is cut into faces.
  claims.tolerances.assign(input.points.size(), 0);
  CHECK(verify_soups(test::tilted(input), test::tilted(test::shuffled(input, 3)), claims));
  const Soup coarse = test::tilted(test::grid(3, 5));
  CHECK(verify_soups(test::tilted(input), coarse, claims));
  claims.tolerances.assign(coarse.points.size(), 0);
  CHECK(verify_soups(coarse, test::tilted(input), claims));
}

TEST_CASE("verify: what is beyond tolerances is measured, between the corners as well") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    CAPTURE(seed);
    const Soup input = test::random_closed(seed), result = test::with_noise(input, seed, 0.05);
    test::Random random(seed);
    Claims claims;
    for (std::size_t v = 0; v < input.points.size(); ++v)
      claims.tolerances.push_back(random(0, 0.04));
    const Verdict verdict = verify_soups(input, result, claims);
    // As many points of each face as it takes to know it to a hundredth of the diagonal.
    const test::Nearest of_result(result);
    double beyond = 0;
    for (const Triangle& t : input.triangles)
      test::for_each_point(input, t, 12, [&](const Position& p) {
        const auto& tau = claims.tolerances;
        beyond =
            std::max(beyond, of_result.distance(p) - std::min({tau[t[0]], tau[t[1]], tau[t[2]]}));
      });
    const Finding& there = verdict.findings[0];
    CHECK(beyond > 0.01);
    CHECK(there.measured >= beyond - there.error / 2);
    CHECK(there.measured <= beyond + 0.003);
    CHECK(verify_soups(result, input, claims).findings[1].measured <= 0.1);
  }
}

TEST_CASE("verify: a face beside others is nearest for the tolerance that it has") {
  // Two squares, one over the other, of which the upper one allows less.
  const Soup square = test::grid(4, 4);
  const Soup input = test::joined(square, square, {{0, 0, 1}});
  const Soup between = test::mapped(square, [](const Position& p) {
    return p + Position{{0, 0, 0.7}};
  });
  Claims claims{.tolerances = std::vector<double>(25, 0.71)};
  claims.tolerances.resize(50, 0.2);
  CHECK(verify_soups(input, between, claims).findings[1].is_met);
  CHECK(std::abs(verify_soups(input, between, claims).findings[0].measured - 0.1) < 1e-9);
  std::fill_n(claims.tolerances.begin(), 25, 0.65);
  CHECK(std::abs(verify_soups(input, between, claims).findings[1].measured - 0.05) < 1e-9);
}

TEST_CASE("verify: normals are compared with those of faces that are gone") {
  Soup roof; // two slopes and, between them, a flat strip of two faces
  roof.points = {{{0, 0, 0}}, {{0, 1, 0}}, {{1, 0, 1}}, {{1, 1, 1}}, {{2, 0, 1}}, {{2, 1, 1}}};
  roof.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  Soup slope = roof; // the strip has gone onto the upper edge of the slope
  slope.triangles.resize(2);
  Claims claims{.normal_deviation = 44, .vertex_map = {0, 1, 2, 3, 2, 3}};
  const Verdict verdict = verify_soups(roof, slope, claims);
  REQUIRE(verdict.findings.size() == 2);
  CHECK(std::abs(verdict.findings[0].measured - 45) < 1e-9);
  CHECK(verdict.findings[1].measured == 0);
  CHECK_FALSE(verdict);
  CHECK_FALSE(verdict.findings[1].place);
  claims.normal_deviation = 45;
  CHECK(verify_soups(roof, slope, claims));
  claims.vertex_map = {0, 1, 2,
                       3, 2, 2}; // one of its faces onto the edge, the other to a point of it
  CHECK(std::abs(verify_soups(roof, slope, claims).findings[0].measured - 45) < 1e-9);
  claims.vertex_map = {0, 1, 2, 3, parameters::vanished, parameters::vanished};
  CHECK(verify_soups(roof, slope, claims).findings[0].measured < 1e-9);
  claims.vertex_map[0] = 1; // no map of these faces
  CHECK(verify_soups(roof, slope, claims).findings[1].measured == 1);
  CHECK(verify_soups(roof, slope, claims).findings[1].place == slope.points[0]);
  claims.vertex_map[0] = 0;
  std::swap(slope.triangles[0][0], slope.triangles[0][1]); // a face that is turned over
  CHECK(std::abs(verify_soups(roof, slope, claims).findings[0].measured - 180) < 1e-9);

  // The place is that of the face: one of many that has been turned.
  const Soup sheet = test::grid(6, 5);
  Soup bent = sheet;
  bent.points[17][2] += 2;
  Claims as_before{.normal_deviation = 30, .vertex_map = {}};
  for (std::size_t v = 0; v < sheet.points.size(); ++v)
    as_before.vertex_map.push_back(v);
  const Finding broken = verify_soups(sheet, bent, as_before).findings[0];
  REQUIRE(broken.place);
  CHECK(squared_distance(*broken.place, sheet.points[17]) < 2 * 2 + 0.2);
}

TEST_CASE("verify: crossings are found, and counted as CGAL counts them") {
  const Soup sphere = test::sphere(2);
  CHECK(pairs_of(sphere) == 0);
  Soup pulled = sphere;
  pulled.points[5] = -1.3 * pulled.points[5];
  CHECK(pairs_of(pulled) == pairs_by_cgal(pulled));
  CHECK_FALSE(verify_soups(sphere, pulled, {.no_self_intersection = true}));
  CHECK(verify_soups(pulled, sphere, {.no_self_intersection = true}));
  const Soup crossing = test::joined(sphere, scaled(sphere, 1), {{0.4, 0.1, 0.2}});
  CHECK(pairs_of(crossing) > 50);
  CHECK(pairs_of(crossing) == pairs_by_cgal(crossing));
  for (std::uint64_t seed = 0; seed < 40; ++seed) { // with faces that lie on each other
    const Soup wild = test::with_noise(test::random_closed(seed), seed, seed % 2 ? 0.3 : 0);
    CAPTURE(seed);
    CHECK(pairs_of(wild) == pairs_by_cgal(wild));
  }
  Soup flat = test::grid(4, 4); // on lattice points, so that overlaps are exact
  flat.points[12] = flat.points[6];
  CHECK(pairs_of(flat) > 0);
  CHECK(pairs_of(flat) == pairs_by_cgal(flat));
}

TEST_CASE("verify: what is no solid is found") {
  const Claims solid{.solid = true};
  const Soup sphere = test::sphere(2),
             shell = test::joined(sphere, test::turned_over(scaled(sphere, 0.5)));
  CHECK(verify_soups(sphere, sphere, solid));
  CHECK(verify_soups(shell, shell, solid));

  Soup open = sphere;
  open.triangles.pop_back();
  CHECK_FALSE(verify_soups(sphere, open, solid));
  CHECK(finding(verify_soups(sphere, open, solid), "open edges").measured == 3);

  const Verdict not_turned = verify_soups(shell, test::joined(sphere, scaled(sphere, 0.5)), solid);
  CHECK_FALSE(finding(not_turned, "components turned inside out, or without volume").is_met);
  const Verdict beside =
      verify_soups(shell, test::joined(sphere, scaled(shell, 0.5), {{3, 0, 0}}), solid);
  CHECK_FALSE(finding(beside, "components").is_met);
  CHECK_FALSE(finding(verify_soups(shell, sphere, solid), "components").is_met);
  const Verdict ring = verify_soups(sphere, test::torus(12, 8), solid);
  CHECK_FALSE(finding(ring, "components with a different number of handles").is_met);
  CHECK_THROWS_AS(verify_soups(open, sphere, solid), std::invalid_argument);
}

TEST_CASE("verify: damage is found by the claim that it breaks, and by no other") {
  // Balls of 32 faces stand for balls of 128 that are larger by 0.3 of their radius at most.
  constexpr double distance = 0.5;
  for (std::uint64_t seed = 0; seed < 1; ++seed) {
    const test::RandomSolid solid(seed);
    const Soup input = solid.soup(1), right = solid.soup(0);
    CHECK(verify_soups(
        input, right,
        {.distance_both_ways = distance, .no_self_intersection = true, .solid = true}));
    std::vector<test::Damage> damages = test::damages_of_faces(distance);
    for (test::Damage& damage : test::damages_of_parts())
      damages.push_back(std::move(damage));
    for (const test::Damage& damage : damages) {
      test::RandomSolid changed = solid;
      Soup damaged = right;
      damage.apply(changed, damaged);
      const Verdict verdict = verify_soups(input, damaged, damage.claims);
      INFO(damage.name << ", seed " << seed << ": " << verdict);
      CHECK(test::broken_findings(verdict) == std::vector{damage.finding});
    }
  }
}

TEST_CASE("verify: what encloses nothing is no solid, and a surface that is gone keeps nothing") {
  const Claims solid{.solid = true};
  const Soup sphere = test::sphere(2);
  const auto pressed = [&](double x, double y, double z) {
    return test::mapped(sphere, [=](const Position& p) {
      return Position{{x * p[0], y * p[1], z * p[2]}};
    });
  };
  for (const Soup& flat :
       {pressed(1, 1, 0), test::tilted(pressed(1, 1, 0)), pressed(1, 0, 0), pressed(0, 0, 0)}) {
    const Verdict verdict = verify_soups(sphere, flat, solid);
    CHECK_FALSE(finding(verdict, "components turned inside out, or without volume").is_met);
  }
  const Soup pillow{{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{0, 1, 2}, {1, 0, 2}}};
  CHECK_FALSE(verify_soups(sphere, pillow, solid));
  CHECK_FALSE(verify_soups(sphere, {}, solid));
  CHECK_FALSE(verify_soups(sphere, {}, {.no_self_intersection = true}));
  CHECK_FALSE(verify_soups(sphere, {}, {.distance = 1}));
  CHECK_FALSE(verify_soups({}, sphere, {.distance = 1}));
  CHECK(verify_soups({}, {}, {.distance_both_ways = 1, .solid = true}));
}

TEST_CASE("verify: an input that bounds no volume is kept as it is") {
  // A ball in a ball, both outward; and onions, of which each skin has changed by more than they
  // are apart.
  const Claims solid{.solid = true};
  const auto balls = [](int fineness, double inner, bool alternates) {
    const Soup ball = test::sphere(fineness);
    const Soup small = scaled(ball, inner);
    return test::joined(ball, alternates ? test::turned_over(small) : small);
  };
  CHECK(verify_soups(balls(3, 0.5, false), balls(1, 0.5, false), solid));
  CHECK_FALSE(verify_soups(balls(3, 0.5, false), balls(1, 0.5, true), solid));
  CHECK(verify_soups(balls(3, 0.99, true), balls(0, 0.99, true), solid));
  CHECK_FALSE(verify_soups(balls(3, 0.99, true), test::turned_over(balls(0, 0.99, true)), solid));
  CHECK(
      verify_soups(scaled(balls(3, 0.5, true), 1e200), scaled(balls(1, 0.5, true), 1e200), solid));
}

TEST_CASE("verify: a verdict is right by its own error") {
  // Of a lifted vertex of a square the distance is known.
  const Soup input = test::grid(8, 8);
  Soup bump = input;
  bump.points[40][2] += 0.01;
  for (double part = 0.8; part < 1.2; part += 0.0123) {
    const Verdict verdict = verify_soups(input, bump, {.distance = 0.01 / part});
    const Finding& there = verdict.findings[0];
    CHECK(there.measured <= 0.01 * (1 + 1e-9));
    CHECK(there.measured + there.error >= 0.01);
    if (part <= 1)
      CHECK(verdict);
    if (0.01 > there.promised + there.error)
      CHECK_FALSE(verdict);
  }
  const Verdict broken = verify_soups(input, bump, {.distance = 0.005});
  REQUIRE(broken.findings[0].place);
  CHECK(squared_distance(*broken.findings[0].place, bump.points[40]) < 1e-18);
}

TEST_CASE("verify: ends where surfaces lie on each other, and when it is told to") {
  // What took ten times as long for a third of the limit.
  const Soup fine = test::tilted(test::grid(24, 24)), coarse = test::tilted(test::grid(7, 9));
  const Claims claims{.distance_both_ways = 1e-4, .no_self_intersection = true, .solid = false};
  std::size_t told = 0;
  double last = 0;
  bool rises = true;
  Claims followed = claims;
  followed.progress = [&](double part) {
    rises &= part >= last && part <= 1;
    last = part;
    ++told;
    return true;
  };
  CHECK(verify_soups(fine, coarse, followed));
  CHECK(told > 50);
  CHECK(rises);
  followed.progress = [&](double) { return false; };
  const Verdict cancelled = verify_soups(fine, coarse, followed);
  CHECK(cancelled.is_cancelled);
  CHECK_FALSE(cancelled);
}

TEST_CASE("verify: solids that touch along an edge or at a point are solids") {
  const Claims solid{.solid = true};
  const Soup edge = cubes_on_an_edge();
  CHECK(verify_soups(edge, edge, solid));
  CHECK(finding(verify_soups(edge, edge, solid), "components").measured == 2);
  const Soup point =
      test::surface_of_cubes(2, 2, 2, [](int x, int y, int z) { return x == y && y == z; });
  CHECK(finding(verify_soups(point, point, solid), "components").measured == 2);
  CHECK(verify_soups(point, point, solid));
  const Soup tunnel =
      test::turned_over(edge); // all but the two cubes, of which the tunnel is one component
  CHECK(finding(verify_soups(tunnel, tunnel, solid), "open edges").is_met);
}

TEST_CASE("verify: meshes of other kinds, and what is refused") {
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  const auto mesh = test::make_mesh(test::sphere(1));
  const auto polyhedron = test::make_mesh<Polyhedron>(test::sphere(1));
  CHECK(verify(mesh, polyhedron,
               {.distance_both_ways = 0, .no_self_intersection = true, .solid = true}));
  CHECK_THROWS_AS(verify(mesh, polyhedron, {.distance = -1}), std::invalid_argument);
  CHECK_FALSE(verify(mesh, test::Mesh(), {.distance = 1}));
  CHECK_THROWS_AS(verify(mesh, mesh, {.tolerances = {1, 2}}), std::invalid_argument);
  std::vector<double> tolerances(num_vertices(mesh), 1);
  CHECK_FALSE(verify(mesh, test::Mesh(), {.tolerances = tolerances}));
  tolerances[3] = -1;
  CHECK_THROWS_AS(verify(mesh, mesh, {.tolerances = tolerances}), std::invalid_argument);
  CHECK_THROWS_AS(verify(mesh, mesh, {.normal_deviation = 10}), std::invalid_argument);
  CHECK_THROWS_AS(verify(mesh, mesh, {.normal_deviation = -1}), std::invalid_argument);
  Soup bad = test::tetrahedron();
  bad.triangles[0][0] = 7;
  CHECK_THROWS_AS(verify_soups(test::tetrahedron(), bad, {.solid = true}), std::invalid_argument);
  bad = test::tetrahedron();
  bad.points[0][0] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(verify_soups(bad, test::tetrahedron(), {.solid = true}), std::invalid_argument);
}
