// Levels of detail from one run: each is what simplify leaves, bit for bit.
#include "farthest.h"
#include "meshes.h"
#include "replay.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/level_splits.h>
#include <quadrille/level_steps.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Points points_of_soup(const Soup& soup) {
  Points points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

void require_same(const Level& level, const Points& points, const Triangles& triangles,
                  const Report& report) {
  const Level sorted = in_input_order(level);
  REQUIRE(sorted.points == points);
  REQUIRE(sorted.triangles == triangles);
  REQUIRE(level.faces == report.faces_after);
  REQUIRE(level.vertices == report.vertices_after);
  REQUIRE(level.contractions == report.contractions);
  REQUIRE(level.error == Approx(report.error).epsilon(1e-6));
  REQUIRE(level.error >= report.error);
}

template <class Cost, class Placement>
void require_same_levels(const Soup& soup, std::size_t coarsest, std::size_t step) {
  Levels levels;
  Points all = points_of_soup(soup);
  Triangles all_triangles = soup.triangles;
  simplify<Cost, Placement>(all, all_triangles, FaceCount{coarsest}, record_into(levels));
  require_same(levels.at(FaceCount{soup.triangles.size()}), points_of_soup(soup), soup.triangles,
               [&] {
                 Report report;
                 report.faces_after = soup.triangles.size();
                 report.vertices_after = soup.points.size();
                 return report;
               }());
  for (std::size_t faces = soup.triangles.size() - 2; faces >= coarsest; faces -= step) {
    INFO(faces << " faces");
    Points points = points_of_soup(soup);
    Triangles triangles = soup.triangles;
    const Report report = simplify<Cost, Placement>(points, triangles, FaceCount{faces});
    require_same(levels.at(FaceCount{faces}), points, triangles, report);
  }
}

// --- Against simplify ----------------------------------------------------------------------------

TEST_CASE("each level of a closed surface is what simplify leaves") {
  const Soup soup = sphere(2);
  require_same_levels<Quadric, OptimalPlacement>(soup, 4, 2);
  require_same_levels<MemorylessQuadric, OptimalPlacement>(soup, 4, 2);
  require_same_levels<EdgeLength, MidpointPlacement>(soup, 4, 2);
  require_same_levels<Quadric, EndpointPlacement>(torus(12, 8), 20, 2);
  require_same_levels<MemorylessQuadric, OptimalPlacement>(with_noise(sphere(2), 7, 0.05), 4, 2);
}

TEST_CASE("levels of a large surface in any order are what simplify leaves") {
  const Soup soup = shuffled(with_noise(sphere(5), 3, 0.002), 11); // renumbered by the engine
  require_same_levels<MemorylessQuadric, OptimalPlacement>(soup, 100, 2038);
}

TEST_CASE("levels of open surfaces by contractions are what simplify leaves") {
  for (const Soup& soup : {grid(9, 7), open_cylinder(9, 6), with_holes(sphere(2), 5, 4)}) {
    Levels levels;
    Points all = points_of_soup(soup);
    Triangles all_triangles = soup.triangles;
    const Report coarsest = simplify(all, all_triangles, FaceCount{10}, record_into(levels));
    for (std::size_t count = 0; count <= coarsest.contractions; ++count) {
      Points points = points_of_soup(soup);
      Triangles triangles = soup.triangles;
      const auto is_enough = [count](const Status& status) { return status.contractions >= count; };
      const Report report = simplify(points, triangles, is_enough);
      require_same(levels.at(AfterContractions{count}), points, triangles, report);
    }
  }
}

TEST_CASE("levels with a limit of the distance tell bounds") {
  const Soup soup = with_noise(sphere(3), 5, 0.01);
  Levels levels;
  Points points = points_of_soup(soup);
  Triangles triangles = soup.triangles;
  const Report report = simplify(points, triangles, DistanceLimit{0.1}, record_into(levels));
  CHECK(levels.coarsest().distance_bound >= report.distance_bound);
  CHECK(levels.coarsest().distance_bound < 0.1 * (1 + 1e-6));
  double last_bound = 0, last_error = 0;
  for (std::size_t i = 0; i <= report.contractions; ++i) {
    const LevelInfo info = levels.info(AfterContractions{i});
    CHECK(info.distance_bound >= last_bound);
    CHECK(info.error >= last_error);
    last_bound = info.distance_bound;
    last_error = info.error;
    const LevelInfo within = levels.info(DistanceAtMost{last_bound});
    CHECK(within.distance_bound <= last_bound);
    CHECK(within.contractions >= i);
    CHECK(levels.info(ErrorAtMost{last_error}).contractions >= i);
    CHECK(levels.info(ErrorAtMost{last_error}).error <= last_error);
  }
  for (double limit : {0.02, 0.05})
    CHECK(levels.info(DistanceAtMost{limit}).faces > levels.coarsest().faces);
}

TEST_CASE("levels of a limit both ways tell bounds both ways") {
  const Soup soup = with_noise(sphere(3), 5, 0.01);
  const std::vector<double> tolerances(soup.points.size(), 0.1);
  const auto check = [&](const auto& stop, const auto&... named) {
    Levels levels;
    Points points = points_of_soup(soup);
    Triangles triangles = soup.triangles;
    const Report report = simplify(points, triangles, stop, record_into(levels), named...);
    CHECK(levels.coarsest().hausdorff_bound >= report.hausdorff_bound);
    CHECK(levels.coarsest().hausdorff_bound < 0.1 * (1 + 1e-6));
    for (std::size_t i = 0; i <= report.contractions; i += report.contractions / 8) {
      const Level level = levels.at(AfterContractions{i});
      Soup now{{}, level.triangles};
      for (const auto& p : level.points)
        now.points.push_back({p});
      CHECK(farthest(soup, now, 2) <= level.hausdorff_bound + 1e-12);
      CHECK(farthest(now, soup, 2) <= level.distance_bound + 1e-12);
      CHECK(level.hausdorff_bound == level.distance_bound);
    }
  };
  check(HausdorffLimit{0.1});
  check(ToleranceLimit{}, parameters::vertex_tolerance_map(CGAL::make_property_map(tolerances)));

  Levels one_way;
  Points points = points_of_soup(soup);
  Triangles triangles = soup.triangles;
  simplify(points, triangles, DistanceLimit{0.1}, record_into(one_way));
  CHECK(one_way.coarsest().hausdorff_bound == std::numeric_limits<double>::infinity());
  CHECK(one_way.finest().hausdorff_bound == 0);
}

// --- Against a replay ----------------------------------------------------------------------------

// Each level has what is there when the log has been done again up to it.
void require_replayed(const Levels& levels, const Log& log, bool is_manifold) {
  Replay replay(log);
  const std::size_t count = log.contractions.size();
  REQUIRE(levels.coarsest().contractions == count);
  for (std::size_t i = 0;; ++i) {
    const Level level = levels.at(AfterContractions{i});
    REQUIRE(level.contractions == i);
    REQUIRE(level.faces == replay.faces().size());
    REQUIRE(level.triangles.size() == level.faces);
    const std::set<std::uint32_t> vertices = replay.vertices();
    REQUIRE(std::set(level.input_vertices.begin(), level.input_vertices.end()) == vertices);
    REQUIRE(level.input_vertices.size() == vertices.size());
    for (std::size_t f = 0; f < level.faces; ++f) {
      Triangle corners = level.triangles[f];
      for (std::uint32_t& v : corners)
        v = level.input_vertices[v];
      REQUIRE(corners == replay.faces().at(level.input_faces[f]));
    }
    bool is_equal = true;
    for (std::size_t v = 0; v < level.vertices; ++v)
      for (std::size_t k = 0; k < 3; ++k)
        is_equal = is_equal && level.points[v][k] == replay.values(level.input_vertices[v])[k];
    const std::vector<std::uint32_t> images = levels.vertex_map(level);
    for (std::uint32_t v = 0; v < images.size(); ++v)
      is_equal = is_equal && (vertices.count(replay.image(v))
                                  ? level.input_vertices.at(images[v]) == replay.image(v)
                                  : images[v] == not_recorded);
    REQUIRE(is_equal);
    if (is_manifold) {
      Soup soup{{}, level.triangles};
      soup.points.resize(level.vertices);
      REQUIRE(topology_of(soup).is_manifold);
    }
    if (i == count)
      return;
    REQUIRE(replay.step());
  }
}

template <class... Arguments>
void require_replayed_levels(const Soup& soup, bool is_manifold, const Arguments&... arguments) {
  Levels levels;
  Log log;
  for (int run = 0; run < 2; ++run) {
    Points points = points_of_soup(soup);
    Triangles triangles = soup.triangles;
    const Report report = run == 0 ? simplify(points, triangles, arguments..., record_into(levels))
                                   : simplify(points, triangles, arguments..., record_into(log));
    REQUIRE(report.contractions > 20);
    if (run == 0)
      require_same(levels.at(FaceCount{0}), points, triangles, report);
  }
  REQUIRE(log.ends == 1);
  require_replayed(levels, log, is_manifold);
}

TEST_CASE("levels are what contractions leave, one after the other") {
  require_replayed_levels(torus(14, 9), true, FaceCount{20});
  require_replayed_levels(with_holes(sphere(2), 3, 5), true, FaceCount{10});
  require_replayed_levels(
      surface_of_cubes(4, 4, 4, [](int i, int j, int k) { return (i + j + k) % 3 != 0; }), false,
      FaceCount{30});
}

TEST_CASE("levels where topology is free") {
  const Soup two = joined(sphere(2), torus(10, 6), {{1.1, 0, 0}});
  require_replayed_levels(two, false, FaceCount{12}, Topology::free);
  require_replayed_levels(two, false, FaceCount{6}, ThresholdPairs{0.3});
  require_replayed_levels(
      surface_of_cubes(4, 4, 4, [](int i, int j, int k) { return (i + j + k) % 3 != 0; }), false,
      FaceCount{8}, Topology::free);
  Soup doubled = sphere(2); // with doubled and degenerate faces, and a point of no face
  doubled.triangles.insert(doubled.triangles.begin() + 5, doubled.triangles[40]);
  doubled.triangles.push_back({3, 3, 7});
  doubled.points.push_back({{5, 5, 5}});
  require_replayed_levels(doubled, false, FaceCount{6}, Topology::free);
}

TEST_CASE("levels of passes") {
  const Soup soup = shuffled(with_noise(sphere(4), 3, 0.004), 11);
  Levels levels;
  Log log;
  Points points = points_of_soup(soup);
  Triangles triangles = soup.triangles;
  simplify(points, triangles, FaceCount{200}, RelaxedOrder{}, record_into(log));
  Points again = points_of_soup(soup);
  Triangles triangles_again = soup.triangles;
  const Report report =
      simplify(again, triangles_again, FaceCount{200}, RelaxedOrder{}, record_into(levels));
  require_same(levels.at(FaceCount{200}), points, triangles, report);
  Replay replay(log);
  while (replay.steps() < log.contractions.size()) {
    REQUIRE(replay.step());
    if (replay.steps() % 97 != 0)
      continue;
    const Level level = levels.at(AfterContractions{replay.steps()});
    REQUIRE(level.faces == replay.faces().size());
    for (std::size_t f = 0; f < level.faces; ++f) {
      Triangle corners = level.triangles[f];
      for (std::uint32_t& v : corners)
        v = level.input_vertices[v];
      REQUIRE(corners == replay.faces().at(level.input_faces[f]));
    }
    for (std::size_t v = 0; v < level.vertices; ++v)
      REQUIRE(Position{level.points[v]} == Position{[&] {
                const std::vector<double> p = replay.values(level.input_vertices[v]);
                return std::array{p[0], p[1], p[2]};
              }()});
    Soup left{{}, level.triangles};
    left.points.resize(level.vertices);
    REQUIRE(topology_of(left).is_manifold);
  }
  CHECK(replay.faces().size() == 200);
  // A level in the middle of a pass is even: on both halves of the surface.
  const Level half = levels.at(FaceCount{soup.triangles.size() * 4 / 5});
  std::size_t left = 0;
  for (const auto& p : half.points)
    left += p[0] < 0;
  CHECK(left > half.vertices * 9 / 20);
  CHECK(left < half.vertices * 11 / 20);
}

// --- Maps ----------------------------------------------------------------------------------------

TEST_CASE("members of a level are the input's vertices, each once") {
  const Soup soup = joined(sphere(2), torus(10, 6), {{1.1, 0, 0}});
  Levels levels;
  Points points = points_of_soup(soup);
  Triangles triangles = soup.triangles;
  simplify(points, triangles, FaceCount{12}, Topology::free, record_into(levels));
  for (const std::size_t faces : {400U, 150U, 40U, 12U}) {
    const LevelInfo level = levels.info(FaceCount{faces});
    const std::vector<std::uint32_t> images = levels.vertex_map(level);
    const LevelMembers members = levels.members(level);
    REQUIRE(members.size() == level.vertices);
    std::vector<std::uint32_t> seen(images.size(), not_recorded);
    for (std::uint32_t v = 0; v < members.size(); ++v)
      for (std::uint32_t input : members[v]) {
        CHECK(seen[input] == not_recorded);
        seen[input] = v;
      }
    CHECK(seen == images);
    const LevelInfo fine = levels.info(FaceCount{faces * 3 / 2});
    const std::vector<std::uint32_t> on_fine = levels.vertex_map(fine);
    const std::vector<std::uint32_t> between = levels.vertex_map(fine, level);
    for (std::size_t input = 0; input < images.size(); ++input)
      CHECK(images[input] ==
            (on_fine[input] == not_recorded ? not_recorded : between[on_fine[input]]));
  }
}

TEST_CASE("levels are extracted into the user's containers") {
  const Soup soup = sphere(3);
  Levels levels;
  std::vector<test::Point> points = points_of(soup);
  std::vector<std::vector<int>> triangles;
  for (const Triangle& t : soup.triangles)
    triangles.emplace_back(t.begin(), t.end());
  simplify(points, triangles, FaceCount{40}, record_into(levels));
  for (const std::size_t faces : {1280U, 700U, 320U, 40U}) {
    const Level level = levels.at(FaceCount{faces});
    const LevelInfo info = levels.extract(FaceCount{faces}, points, triangles);
    CHECK(info.faces == level.faces);
    REQUIRE(points.size() == level.vertices);
    REQUIRE(triangles.size() == level.faces);
    for (std::size_t v = 0; v < points.size(); ++v)
      CHECK(to_position(points[v]) == Position{level.points[v]});
    for (std::size_t f = 0; f < triangles.size(); ++f)
      CHECK(std::equal(triangles[f].begin(), triangles[f].end(), level.triangles[f].begin(),
                       level.triangles[f].end(),
                       [](int a, std::uint32_t b) { return static_cast<std::uint32_t>(a) == b; }));
  }
  std::vector<std::array<float, 3>> floats;
  levels.extract(FaceCount{100}, floats, triangles);
  CHECK(static_cast<double>(floats[7][1]) ==
        Approx(levels.at(FaceCount{100}).points[7][1]).epsilon(1e-6));
}

void require_at(const LevelSteps& steps, const Levels& levels, std::size_t contractions) {
  CAPTURE(contractions);
  const Level level = levels.at(AfterContractions{contractions});
  REQUIRE(steps.info().contractions == contractions);
  REQUIRE(steps.info().error == level.error);
  REQUIRE(std::equal(steps.points().begin(), steps.points().end(), level.points.begin(),
                     level.points.end()));
  REQUIRE(std::equal(steps.triangles().begin(), steps.triangles().end(), level.triangles.begin(),
                     level.triangles.end()));
}

// The finer level becomes the coarser one by what a step says.
void require_step(const LevelStep& step, const Level& fine, const Level& coarse) {
  REQUIRE(step.finer_faces == fine.faces);
  REQUIRE(step.coarser_faces == coarse.faces);
  REQUIRE(step.finer_vertices == fine.vertices);
  REQUIRE(step.coarser_vertices == coarse.vertices);
  REQUIRE(step.kept_before == fine.points[step.kept]);
  REQUIRE(step.gone_before == fine.points[step.gone]);
  if (step.kept < coarse.vertices) // it has faces still
    REQUIRE(step.after == coarse.points[step.kept]);
  Triangles triangles = fine.triangles;
  for (std::uint32_t face : step.changed)
    for (std::uint32_t& v : triangles[face])
      v = v == step.gone ? step.kept : v;
  triangles.resize(coarse.faces);
  REQUIRE(triangles == coarse.triangles);
  std::vector<std::uint32_t> star;
  for (std::uint32_t face = 0; face < fine.faces; ++face) {
    const auto has = [&](std::uint32_t v) {
      return std::ranges::find(fine.triangles[face], v) != fine.triangles[face].end();
    };
    if (has(step.kept) || has(step.gone) || face >= coarse.faces)
      star.push_back(face);
  }
  REQUIRE(std::ranges::equal(step.changed, star));
}

TEST_CASE("levels step by step, forwards and backwards") {
  for (const bool is_free : {false, true}) {
    const Soup soup = is_free ? joined(sphere(2), torus(10, 6), {{1.1, 0, 0}}) : sphere(2);
    Levels levels;
    Points points = points_of_soup(soup);
    Triangles triangles = soup.triangles;
    simplify(points, triangles, FaceCount{8}, is_free ? Topology::free : Topology::kept,
             record_into(levels));
    const std::size_t count = levels.coarsest().contractions;
    LevelSteps steps(levels);
    CHECK_FALSE(steps.refine());
    for (std::size_t i = 0; i < count; ++i) {
      require_at(steps, levels, i);
      REQUIRE(steps.coarsen());
      require_step(steps.last_step(), levels.at(AfterContractions{i}),
                   levels.at(AfterContractions{i + 1}));
    }
    CHECK_FALSE(steps.coarsen());
    for (std::size_t i = count; i > 0; --i) {
      require_at(steps, levels, i);
      REQUIRE(steps.refine());
      require_step(steps.last_step(), levels.at(AfterContractions{i - 1}),
                   levels.at(AfterContractions{i}));
    }
    require_at(steps, levels, 0);
    std::size_t at = 0;
    Random random(5);
    for (int i = 0; i < 2000; ++i) { // to and fro
      const bool is_down = random.below(2) == 0;
      if (is_down ? steps.coarsen() : steps.refine())
        at += is_down ? std::size_t{1} : ~std::size_t{0};
      if (i % 50 == 0)
        require_at(steps, levels, at);
    }
  }
}

TEST_CASE("vertex splits refine the coarsest level to each other one") {
  for (const Topology topology :
       {Topology::kept, Topology::free, Topology::components_may_vanish}) {
    const Soup soup = joined(sphere(2), torus(10, 6), {{1.1, 0, 0}});
    Levels levels;
    Points all = points_of_soup(soup);
    Triangles input = soup.triangles;
    simplify(all, input, FaceCount{8}, topology, record_into(levels));
    const VertexSplits splits = vertex_splits(levels);
    const std::size_t count = splits.parents.size();
    REQUIRE(count == levels.coarsest().contractions);
    Points points(splits.points.begin(), splits.points.begin() + splits.vertex_counts[0]);
    Triangles faces(splits.faces.begin(), splits.faces.begin() + splits.face_counts[0]);
    for (std::size_t s = 0;; ++s) {
      const Level level = levels.at(AfterContractions{count - s});
      REQUIRE(points == level.points);
      REQUIRE(faces == level.triangles);
      REQUIRE(splits.errors[s] == level.error);
      if (s == count)
        break;
      for (std::uint32_t i = splits.corner_begins[s]; i < splits.corner_begins[s + 1]; ++i) {
        std::uint32_t& corner = faces[splits.corners[i] / 3][splits.corners[i] % 3];
        REQUIRE(corner == splits.parents[s]);
        corner = splits.children[s];
      }
      while (points.size() < splits.vertex_counts[s + 1])
        points.push_back(splits.points[points.size()]);
      while (faces.size() < splits.face_counts[s + 1])
        faces.push_back(splits.faces[faces.size()]);
      if (const std::uint32_t parent = splits.parents[s]; parent != not_recorded) {
        if (parent < splits.vertex_counts[s])
          REQUIRE(points[parent] == splits.merged_points[s]);
        points[parent] = splits.parent_points[s];
      }
    }
    const Level finest = levels.at(AfterContractions{0});
    CHECK(splits.input_vertices == finest.input_vertices);
    CHECK(splits.input_faces == finest.input_faces);
  }
}

template <class M>
void require_meshes() {
  const Soup soup =
      surface_of_cubes(4, 4, 4, [](int i, int j, int k) { return (i + j + k) % 3 != 0; });
  for (const Soup& input :
       {sphere(2), with_holes(sphere(2), 3, 5), soup, with_flipped_edges(grid(6, 5), 3, 4)}) {
    Levels levels;
    Points points = points_of_soup(input);
    Triangles triangles = input.triangles;
    simplify(points, triangles, FaceRatio{0.1}, record_into(levels));
    M mesh;
    for (std::size_t faces = input.triangles.size(); faces > 12; faces -= 10) {
      const Level level = levels.at(FaceCount{faces});
      const std::vector<std::uint32_t> origins = to_mesh(level, mesh);
      REQUIRE(CGAL::is_valid_polygon_mesh(mesh));
      REQUIRE(num_faces(mesh) == level.faces);
      REQUIRE(num_vertices(mesh) == origins.size());
      std::map<typename boost::graph_traits<M>::vertex_descriptor, std::uint32_t> number;
      std::size_t i = 0;
      for (auto v : vertices(mesh)) {
        CHECK(to_position(get(CGAL::vertex_point, mesh, v)) == Position{level.points[origins[i]]});
        number[v] = origins[i++];
      }
      std::size_t face = 0;
      for (auto f : CGAL::faces(mesh)) {
        auto h = halfedge(f, mesh);
        for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh))
          CHECK(number[target(h, mesh)] == level.triangles[face][k]);
        ++face;
      }
    }
  }
}

TEST_CASE("levels become meshes") {
  require_meshes<Mesh>();
  require_meshes<CGAL::Polyhedron_3<Kernel>>();
}

TEST_CASE("what has not been recorded is refused") {
  Levels levels;
  CHECK(levels.empty());
  CHECK_THROWS_WITH(levels.at(FaceCount{3}), "quadrille::Levels: nothing has been recorded");
  CHECK_THROWS_AS(levels.finest(), std::logic_error);
  CHECK_THROWS_AS(levels.coarsest(), std::logic_error);
  Mesh mesh = read_model("cow");
  simplify(mesh, FaceCount{100}, record_into(levels));
  CHECK_THROWS_AS(levels.at(DistanceAtMost{1}), std::logic_error);
  CHECK(levels.finest().faces == 5804);
  CHECK(levels.finest().distance_bound == 0);
  CHECK(levels.coarsest().faces == 100);
  // What throws or is cancelled before the first contraction leaves the levels that there were.
  Mesh bad = read_model("cow");
  bad.point(Mesh::Vertex_index(7)) = test::Point(0, std::numeric_limits<double>::infinity(), 0);
  CHECK_THROWS(simplify(bad, record_into(levels)));
  CHECK(levels.coarsest().faces == 100);
}

} // namespace
