// Passes hold to the same promises as greedy order, and come close to its error.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::read_model;
using test::Soup;
using test::SoupTopology;

const std::vector<RelaxedOrder> orders{{}, {.share = 1}, {.share = 0.2, .refresh = true}};

struct CountTurned {
  std::size_t* count;
  bool allows(const auto& contraction) const {
    for (const auto& face : contraction.faces())
      *count += dot(double_area_vector(face.before, face.second, face.third),
                    double_area_vector(face.after, face.second, face.third)) < 0;
    return true;
  }
};

template <class Cost, class Order>
double error_of(const Mesh& input, std::size_t faces, const Order& order) {
  Mesh mesh = input;
  simplify<Cost, OptimalPlacement>(mesh, FaceCount{faces}, order);
  return surface_distance(input, mesh, {.samples = 20'000}).rms;
}

} // namespace

TEMPLATE_TEST_CASE("Passes keep the topology, meet the target and turn no face", "", Quadric,
                   MemorylessQuadric) {
  std::vector<std::pair<std::string, Mesh>> models;
  for (const char* name : {"bunny00", "cow", "lion-head", "nefertiti"})
    models.emplace_back(name, read_model(name));
  models.emplace_back("plate", test::make_mesh(test::plate_with_holes(9, 8)));
  models.emplace_back("noise", test::make_mesh(test::random_closed(7)));
  for (const auto& [name, input] : models) {
    const SoupTopology before = test::topology_of(test::to_soup(input));
    for (const RelaxedOrder& order : orders)
      for (double ratio : {0.5, 0.1, 0.0}) {
        const auto target =
            static_cast<std::size_t>(ratio * static_cast<double>(input.number_of_faces()));
        Mesh mesh = input;
        std::size_t turned = 0;
        const Report report = simplify<TestType, OptimalPlacement>(mesh, FaceCount{target}, order,
                                                                   CountTurned{&turned});
        INFO(name << " to " << target << ", share " << order.share << ": " << report);
        REQUIRE(test::is_valid_triangle_mesh(mesh));
        const SoupTopology after = test::topology_of(test::to_soup(mesh));
        REQUIRE(after.is_manifold);
        REQUIRE_FALSE(after.has_duplicate_faces);
        REQUIRE(is_same_topology(before, after));
        REQUIRE(turned == 0);
        REQUIRE(report.faces_after == mesh.number_of_faces());
        REQUIRE(report.vertices_after == mesh.number_of_vertices());
        REQUIRE(report.contractions == report.vertices_before - report.vertices_after);
        if (report.stop == StopReason::target_passed)
          REQUIRE(mesh.number_of_faces() + 1 == target);
        else if (report.stop == StopReason::target_met)
          REQUIRE(mesh.number_of_faces() == target);
        else
          REQUIRE((report.stop == StopReason::all_pairs_rejected ||
                   report.stop == StopReason::target_unreachable));
        REQUIRE((is_target_reached(report.stop) || ratio == 0 || input.num_faces() < 200));
      }
  }
}

TEST_CASE("Passes meet odd and even targets on a surface with a border, or pass them by one") {
  const Mesh input = test::make_mesh(test::with_noise(test::grid(100, 100), 3, 0.05));
  for (const RelaxedOrder& order : orders)
    for (std::size_t target = 2000; target < 2006; ++target) {
      Mesh mesh = input;
      const Report report = simplify(mesh, FaceCount{target}, order);
      CAPTURE(target, order.share);
      const std::size_t faces = mesh.number_of_faces();
      CHECK((faces == target || faces + 1 == target));
      CHECK(report.stop == (faces == target ? StopReason::target_met : StopReason::target_passed));
    }
}

TEST_CASE("Passes come close to the error of greedy order, refreshed ones to less") {
  const Mesh input = read_model("bunny00");
  const double greedy = error_of<Quadric>(input, 7540, GreedyOrder{});
  const double relaxed = error_of<Quadric>(input, 7540, RelaxedOrder{});
  const double refreshed =
      error_of<Quadric>(input, 7540, RelaxedOrder{.share = 0.2, .refresh = true});
  CAPTURE(greedy, relaxed, refreshed);
  CHECK(relaxed < 1.05 * greedy);
  CHECK(relaxed > 0.9 * greedy);
  CHECK(refreshed < 0.85 * greedy);
}

TEST_CASE("Passes hold to constraints") {
  Mesh mesh = test::make_mesh(test::with_noise(test::sphere(5), 1, 0.01));
  const auto is_constrained =
      mesh.add_property_map<Mesh::Vertex_index, bool>("v:constrained", false).first;
  std::vector<std::pair<Mesh::Vertex_index, test::Point>> places;
  for (Mesh::Vertex_index v : mesh.vertices())
    if (v.idx() % 10 == 0) {
      is_constrained[v] = true;
      places.emplace_back(v, mesh.point(v));
    }
  const Report report = simplify<Quadric, OptimalPlacement>(
      mesh, FaceCount{2500}, RelaxedOrder{},
      CGAL::parameters::vertex_is_constrained_map(is_constrained));
  CHECK(report.faces_after == 2500);
  for (const auto& [v, place] : places) {
    REQUIRE_FALSE(mesh.is_removed(v));
    REQUIRE(mesh.point(v) == place);
  }
}

TEST_CASE("Passes hand out what vertices remember at the vertices' own numbers") {
  const bool refresh = GENERATE(false, true);
  Mesh mesh = test::make_mesh(test::sphere(5));
  const auto map = mesh.add_property_map<Mesh::Vertex_index, QuadricForm<3>>("v:quadric").first;
  simplify(mesh, FaceRatio{0.05}, RelaxedOrder{.refresh = refresh},
           parameters::vertex_quadric_map(map));
  REQUIRE(mesh.number_of_vertices() > 100);
  for (const auto v : mesh.vertices()) { // about the vertex: the tangent plane, nearly
    const auto out = 0.01 * test::to_position(mesh.point(v));
    REQUIRE(map[v](out) > 0.8 * 0.01 * 0.01);
  }
}

TEST_CASE("Passes keep creases where they are, with their vertices under new numbers") {
  const bool refresh = GENERATE(false, true);
  const auto off_the_seam = [&](bool has_seam) { // of a seam along a diagonal of a plate: the RMS
    Mesh mesh = test::make_mesh(test::grid(64, 64));
    const auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
    const auto is_on_seam = [](const test::Point& p) { return p.x() - p.y() == 10 / 64.0; };
    std::vector<test::Point> seam;
    for (const auto e : mesh.edges()) {
      const auto p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
      if (!is_on_seam(p) || !is_on_seam(q))
        continue;
      is_crease[e] = has_seam;
      seam.push_back(CGAL::midpoint(p, q));
    }
    REQUIRE(seam.size() > 30);
    simplify(mesh, FaceRatio{0.1}, RelaxedOrder{.share = 0.2, .refresh = refresh},
             quadrille::parameters::edge_is_crease_map(is_crease));
    double sum = 0;
    for (const test::Point& p : seam) { // to the nearest edge
      double nearest = 1;
      for (const auto e : mesh.edges())
        nearest = std::min(nearest, CGAL::squared_distance(p, CGAL::Segment_3<test::Kernel>(
                                                                  mesh.point(mesh.vertex(e, 0)),
                                                                  mesh.point(mesh.vertex(e, 1)))));
      sum += nearest;
    }
    return std::sqrt(sum / static_cast<double>(seam.size()));
  };
  const double with = off_the_seam(true), without = off_the_seam(false);
  CAPTURE(with, without);
  CHECK(with < 1e-9);
  CHECK(without > 1e-3);
}

TEST_CASE("Passes may take the last face of a surface") {
  const Mesh input = [] {
    Mesh mesh;
    for (int i = 0; i < 3000; ++i) {
      const double x = 4 * (i % 50), y = 4 * (i / 50);
      mesh.add_face(mesh.add_vertex(test::Point(x, y, 0)),
                    mesh.add_vertex(test::Point(x + 1, y, 0)),
                    mesh.add_vertex(test::Point(x, y + 2, 0)));
    }
    return mesh;
  }();
  for (const RelaxedOrder& order : orders) {
    Mesh mesh = input;
    const Report report = simplify(mesh, FaceCount{0}, order, Topology::free);
    CHECK(report.faces_after == 0);
    CHECK(mesh.number_of_faces() == 0);
    CHECK(mesh.number_of_vertices() == 0);
    CHECK(mesh.is_valid());
  }
}

TEST_CASE("Creases may lose their faces in passes") {
  const bool are_faces = GENERATE(false, true); // else edges of no face
  Mesh mesh = test::make_mesh(test::with_noise(test::grid(80, 80), 3, 0.002));
  for (int i = 0; i < 1500; ++i) {
    const double x = 1e-3 * (i % 50), y = 1e-3 * (i / 50);
    const auto a = mesh.add_vertex(test::Point(x, y, 9)),
               b = mesh.add_vertex(test::Point(x + 2e-4, y, 9)),
               c = mesh.add_vertex(test::Point(x, y + 4e-4, 9));
    if (are_faces)
      mesh.add_face(a, b, c);
    else
      mesh.add_edge(a, b);
  }
  const auto is_crease = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
  for (const auto e : mesh.edges())
    is_crease[e] = mesh.point(mesh.vertex(e, 0)).z() > 5;
  const Report report = simplify(mesh, FaceRatio{0.2}, RelaxedOrder{.refresh = true},
                                 are_faces ? Topology::free : Topology::kept,
                                 quadrille::parameters::edge_is_crease_map(is_crease));
  CHECK(report.stop == StopReason::target_met);
  CHECK(test::is_valid_triangle_mesh(mesh));
}

TEST_CASE("Passes take no pair at which the stop policy would stop") {
  const Mesh input = read_model("bunny00");
  const DistanceLimit limit = DistanceLimit::relative(1e-3);
  Mesh greedy = input, relaxed = input;
  const Report g = simplify<Quadric, OptimalPlacement>(greedy, limit);
  const Report r = simplify<Quadric, OptimalPlacement>(relaxed, limit, RelaxedOrder{});
  CHECK(r.distance_bound <= 1e-3 * bounding_box_diagonal(input));
  CHECK(r.stop == StopReason::target_met);
  CHECK(static_cast<double>(r.faces_after) < 1.1 * static_cast<double>(g.faces_after));
}

TEST_CASE("Passes join the parts of a soup, and leave nothing degenerate") {
  Soup soup = test::joined(test::cube(24), test::cube(24), {{1.01, 0, 0}});
  std::vector<test::Point> points = test::points_of(soup);
  const Report report = simplify<Quadric, OptimalPlacement>(points, soup.triangles, FaceCount{16},
                                                            ThresholdPairs{0.02}, RelaxedOrder{});
  INFO(report);
  CHECK(report.non_edge_contractions > 0);
  CHECK(report.components_before == 2);
  CHECK(report.components_after == 1);
  CHECK(report.faces_after <= 16);
  CHECK(report.faces_after >= 8);
  CHECK(soup.triangles.size() == report.faces_after);
  CHECK(points.size() == report.vertices_after);
  soup.points.clear();
  for (const test::Point& p : points)
    soup.points.push_back(test::to_position(p));
  CHECK(test::count_degenerate_faces(soup) == 0);
  CHECK_FALSE(test::topology_of(soup).has_duplicate_faces);
}

TEST_CASE("Passes meet targets where a contraction takes many faces, or vertices") {
  const auto compare = [](const Soup& soup, const auto& stop, auto figure) {
    const auto figure_after = [&](const auto& order) {
      test::PointSoup result(soup);
      const Report report = simplify<EdgeLength, MidpointPlacement>(
          result.points, result.triangles, stop, order, Topology::free, NormalFlip{180});
      INFO(report);
      REQUIRE(report.stop == StopReason::target_met);
      REQUIRE(report.vertices_after == result.points.size());
      return report.*figure;
    };
    const std::size_t greedy = figure_after(GreedyOrder{});
    for (double share : {0.5, 1.0})
      CHECK(figure_after(RelaxedOrder{.share = share}) == greedy);
  };
  Soup apart; // triangles, of which a contraction takes all
  for (int i = 0; i < 3000; ++i)
    apart = test::joined(std::move(apart), test::triangle(), {{2.0 * i, 0, 0}});
  apart = test::with_noise(apart, 1, 0.1);
  for (std::size_t count : {6000u, 3000u, 999u})
    compare(apart, VertexCount{count}, &Report::vertices_after);
  Soup book; // 40 pages at an edge
  book.points = {{{0, 0, 0}}, {{0, 0, 0.01}}};
  for (std::uint32_t page = 2; page < 42; ++page) {
    book.points.push_back({{std::cos(page / 7.0), std::sin(page / 7.0), 0}});
    book.triangles.push_back({0, 1, page});
  }
  Soup books;
  for (int i = 0; i < 250; ++i)
    books = test::joined(std::move(books), book, {{3.0 * i, 0, 0}});
  for (std::size_t count : {8000u, 5000u, 1000u})
    compare(books, FaceCount{count}, &Report::faces_after);
  Soup bound_twice; // where one edge goes, its pages are left, and few vertices go with many faces
  book.points.push_back({{0.2, 0.2, 0}});
  book.points.push_back({{0.2, 0.2, 0.5}});
  for (std::uint32_t page = 2; page < 42; ++page)
    book.triangles.push_back({42, 43, page});
  for (int i = 0; i < 250; ++i)
    bound_twice = test::joined(std::move(bound_twice), book, {{3.0 * i, 0, 0}});
  for (std::size_t count : {16'000u, 12'000u})
    compare(bound_twice, FaceCount{count}, &Report::faces_after);
}

TEST_CASE("Passes know how many vertices are left where faces are few and far between") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Soup soup = test::with_noise(test::grid(60, 60), seed, 0.01);
    std::erase_if(soup.triangles, [&](const auto&) { return random.below(8) > seed % 8; });
    soup = test::without_isolated_points(soup);
    const std::size_t target = soup.points.size() * (2 + random.below(3)) / 5;
    for (bool counts_vertices : {true, false}) {
      test::PointSoup result(soup);
      const auto stop = [&](const Status& status) {
        return (counts_vertices ? status.vertices : 2 * status.faces) <= target;
      };
      const Report report = simplify<Quadric, OptimalPlacement>(
          result.points, result.triangles, stop, Topology::free, RelaxedOrder{.share = 1});
      INFO(report);
      REQUIRE(report.vertices_after == result.points.size());
      REQUIRE(report.vertices_after ==
              test::without_isolated_points({soup.points, result.triangles}).points.size());
    }
  }
}

TEST_CASE("A visitor cancels between passes and leaves a valid mesh") {
  struct Cancel : Visitor {
    bool proceed(const Status& status) const { return status.contractions == 0; }
  };
  Mesh mesh = read_model("bunny00");
  const Report report = simplify<Quadric, OptimalPlacement>(mesh, FaceCount{1000}, RelaxedOrder{},
                                                            CGAL::parameters::visitor(Cancel{}));
  CHECK(report.stop == StopReason::cancelled);
  CHECK(report.contractions > 0);
  CHECK(report.faces_after > 1000);
  CHECK(test::is_valid_triangle_mesh(mesh));
}

TEST_CASE("The same passes twice give the same mesh, bit for bit") {
  const Mesh input = read_model("bunny00");
  Mesh first = input, second = input;
  simplify<Quadric, OptimalPlacement>(first, FaceCount{5000}, RelaxedOrder{});
  simplify<Quadric, OptimalPlacement>(second, FaceCount{5000}, RelaxedOrder{});
  const Soup a = test::to_soup(first), b = test::to_soup(second);
  CHECK(a.points == b.points);
  CHECK(a.triangles == b.triangles);
}

TEST_CASE("An order that is chosen at run time is that order, bit for bit") {
  const Mesh input = read_model("bunny00");
  const auto simplified = [&](const auto& order) {
    Mesh mesh = input;
    simplify<MemorylessQuadric, OptimalPlacement>(mesh, FaceCount{3000}, order);
    return test::to_soup(mesh);
  };
  const auto is_same = [&](const auto& order) {
    const Soup a = simplified(order), b = simplified(AnyOrder{order});
    return a.points == b.points && a.triangles == b.triangles;
  };
  CHECK(is_same(GreedyOrder{}));
  CHECK(is_same(RelaxedOrder{}));
  CHECK(is_same(RelaxedOrder{.share = 0.2, .refresh = true}));
  Mesh mesh = input;
  CHECK_THROWS_WITH(simplify(mesh, AnyOrder{RelaxedOrder{.share = 0}}),
                    Catch::Contains("the share 0 is not in (0, 1]"));
}

TEST_CASE("An order that makes no sense is refused") {
  Mesh mesh = test::make_mesh(test::sphere(2));
  const auto with = [&](const RelaxedOrder& order) {
    simplify<Quadric, OptimalPlacement>(mesh, order);
  };
  CHECK_THROWS_WITH(with({.share = 0}), Catch::Contains("the share 0 is not in (0, 1]"));
  CHECK_THROWS_WITH(with({.share = 1.5}), Catch::Contains("the share 1.5 is not in (0, 1]"));
  CHECK_THROWS_WITH(with({.threads = 0}), Catch::Contains("0 threads"));
  CHECK_THROWS_WITH(with({.threads = 1025}), Catch::Contains("1025 threads are not from 1 to"));
  CHECK_THROWS_AS(with({.threads = 4'000'000'000}), std::invalid_argument);
#ifndef QUADRILLE_WITH_TBB
  CHECK_THROWS_WITH(with({.threads = 2}), Catch::Contains("2 threads need oneTBB"));
#endif
}
