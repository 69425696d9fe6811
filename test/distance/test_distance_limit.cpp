// An error limit keeps its word: the result lies within it, measured apart by CGAL.
#include "farthest.h"
#include "meshes.h"
#include "soups.h"

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <quadrille/distance.h>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
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
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::read_model;

struct Model {
  std::string name;
  Mesh mesh;
};

std::vector<Model> models() {
  std::vector<Model> models;
  for (const char* name : {"cow", "bones", "nefertiti", "blobby_3cc", "pinion"})
    models.push_back({name, read_model(name)});
  models.push_back({"sphere", test::make_mesh(test::sphere(4))});
  models.push_back({"torus", test::make_mesh(test::torus(40, 20))});
  models.push_back({"cube", test::make_mesh(test::cube(6))});
  models.push_back({"noise", test::make_mesh(test::with_noise(test::sphere(4), 1, 0.02))});
  models.push_back({"holes", test::make_mesh(test::random_with_boundaries(3))});
  return models;
}

// From the result to the input, to a tenth of the limit.
double distance_to(const Mesh& input, const Mesh& result, double limit) {
  return CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
      result, input, limit / 10);
}

// The same from points of each triangle, to the last bits, for surfaces of any kind.
double sampled_distance_to(const test::Soup& input, const test::Soup& result) {
  return test::farthest(result, input, result.triangles.size() > 500 ? 5 : 20);
}

struct Outcome {
  Report report;
  test::Soup result;
};

// Simplifies a soup, and holds that the report says no less than is measured.
template <class... Arguments>
Outcome simplify_within(double limit, const test::Soup& input, const Arguments&... arguments) {
  test::PointSoup soup(input);
  Outcome outcome{simplify<Quadric, OptimalPlacement>(soup.points, soup.triangles,
                                                      DistanceLimit{limit}, Topology::kept,
                                                      arguments...),
                  {}};
  for (const test::Point& p : soup.points)
    outcome.result.points.push_back(test::to_position(p));
  outcome.result.triangles = soup.triangles;
  const double size = test::greatest_coordinate(input);
  INFO("limit " << limit << ": " << outcome.report);
  CHECK(outcome.report.distance_bound <= std::max(limit, 0x1p-40 * size));
  const double measured = sampled_distance_to(input, outcome.result);
  CHECK(measured <= outcome.report.distance_bound + 0x1p-50 * size); // the measure's own roundings
  return outcome;
}

double area(const test::Soup& soup) {
  double sum = 0;
  for (const test::Triangle& t : soup.triangles)
    sum += std::sqrt(squared_length(test::area_vector(soup, t)));
  return sum;
}

// A square sheet bent along its middle, so that both halves make this angle; at 180 it is flat.
test::Soup bent_sheet(double degrees) {
  const double turn = (180 - degrees) * std::numbers::pi / 180;
  return test::mapped(test::grid(12, 12), [&](const test::Position& p) {
    const double beyond = std::max(0.0, p[0] - 0.5);
    return test::Position{{p[0] - beyond + beyond * std::cos(turn), p[1], beyond * std::sin(turn)}};
  });
}

// Sheets that have one edge line in common.
test::Soup sheets_at_a_line(int count) {
  test::Soup soup;
  const std::uint32_t n = 8;
  for (std::uint32_t j = 0; j <= n; ++j)
    soup.points.push_back({{0, 0, double(j) / n}});
  for (int k = 0; k < count; ++k) {
    const double angle = 0.3 + 2 * std::numbers::pi * k / count;
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return i == 0 ? j : first + (i - 1) * (n + 1) + j;
    };
    for (std::uint32_t i = 1; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        soup.points.push_back({{std::cos(angle) * i / n, std::sin(angle) * i / n, double(j) / n}});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return soup;
}

// Pages at odd angles and of different sizes, on one edge line; about a third are wound the other
// way. The line and the pages may be curved.
test::Soup odd_pages(int count, std::uint64_t seed, double curve = 0) {
  test::Random random(seed);
  const auto part = [&] { return double(random.below(1000)) / 1000; };
  test::Soup soup;
  const std::uint32_t n = 8;
  const auto bent = [&](double j) { return curve * std::sin(j / 2); };
  for (std::uint32_t j = 0; j <= n; ++j)
    soup.points.push_back({{bent(j), 0, double(j)}});
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.7 * part()) / count, step = 0.3 + part();
    const auto width = static_cast<std::uint32_t>(1 + random.below(5));
    const bool is_turned = random.below(3) == 0;
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return i == 0 ? j : first + (i - 1) * (n + 1) + j;
    };
    for (std::uint32_t i = 1; i <= width; ++i)
      for (std::uint32_t j = 0; j <= n; ++j) {
        const double rise = 0.1 * curve * std::sin(1.3 * i + 0.9 * j);
        soup.points.push_back({{bent(j) + step * i * std::cos(angle) - rise * std::sin(angle),
                                step * i * std::sin(angle) + rise * std::cos(angle), double(j)}});
      }
    const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      soup.triangles.push_back(is_turned ? test::Triangle{p, r, q} : test::Triangle{p, q, r});
    };
    for (std::uint32_t i = 0; i < width; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return soup;
}

// A soup of which equal points are one.
class Builder {
public:
  std::uint32_t vertex(const test::Position& p) {
    const auto [place, is_new] = numbers_.try_emplace(
        {std::llround(1e6 * p[0]), std::llround(1e6 * p[1]), std::llround(1e6 * p[2])},
        static_cast<std::uint32_t>(soup.points.size()));
    if (is_new)
      soup.points.push_back(p);
    return place->second;
  }
  void add(const test::Position& p, const test::Position& q, const test::Position& r) {
    soup.triangles.push_back({vertex(p), vertex(q), vertex(r)});
  }
  // A parallelogram in fine x fine cells.
  void add_grid(const test::Position& p, const test::Position& u, const test::Position& v,
                int fine) {
    const auto at = [&](int i, int j) { return p + double(i) / fine * u + double(j) / fine * v; };
    for (int i = 0; i < fine; ++i)
      for (int j = 0; j < fine; ++j) {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  void add_triangle(const test::Position& p, const test::Position& q, const test::Position& r,
                    int fine) {
    const auto at = [&](int i, int j) {
      return p + double(i) / fine * (q - p) + double(j) / fine * (r - p);
    };
    for (int i = 0; i < fine; ++i)
      for (int j = 0; i + j < fine; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < fine)
          add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }

  test::Soup soup;

private:
  std::map<std::array<long long, 3>, std::uint32_t> numbers_;
};

// count³ unit cubes with shared walls, each wall a grid.
test::Soup cells(int count, int fine) {
  Builder builder;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int s = 0; s <= count; ++s)
      for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
          test::Position p, u, v;
          const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
          p[axis] = s, p[first] = i, p[second] = j;
          u[first] = 1, v[second] = 1;
          builder.add_grid(p, u, v, fine);
        }
  return builder.soup;
}

// Four cells in a tetrahedron: films from its middle to its edges, and its sides.
test::Soup foam(int fine) {
  const std::array<test::Position, 4> corners{
      {{{1, 1, 1}}, {{1, -1, -1}}, {{-1, 1, -1}}, {{-1, -1, 1}}}};
  Builder builder;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      builder.add_triangle({{0, 0, 0}}, corners[i], corners[j], fine);
      for (std::size_t k = j + 1; k < 4; ++k)
        builder.add_triangle(corners[i], corners[j], corners[k], fine);
    }
  return builder.soup;
}

// A floor, a wall across it, and another one from the middle of that.
test::Soup walls() {
  Builder builder;
  builder.add_grid({{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, 8);
  builder.add_grid({{0, 0.5, 0}}, {{1, 0, 0}}, {{0, 0, 1}}, 8);
  builder.add_grid({{0.5, 0.5, 0}}, {{0, 0.5, 0}}, {{0, 0, 0.5}}, 4);
  return builder.soup;
}

test::Soup wound_at_random(test::Soup soup, int percent, std::uint64_t seed) {
  test::Random random(seed);
  for (test::Triangle& t : soup.triangles)
    if (random.below(100) < static_cast<std::uint64_t>(percent))
      std::swap(t[1], t[2]);
  return soup;
}

// 40 x 20 x 2.4 with a round hole; n points around each outline, of which all but 8 are on straight
// edges, and n around the hole.
test::Soup plate_with_hole(std::uint32_t n) {
  test::Soup soup;
  for (double z : {0.0, 2.4}) {
    for (double radius : {0.0, 1.7})
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n, c = std::cos(angle), s = std::sin(angle);
        const double k = radius > 0 ? radius : 1 / std::max(std::abs(c) / 20, std::abs(s) / 10);
        soup.points.push_back({{k * c, k * s, z}});
      }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    quad(2 * n + i, 2 * n + j, 3 * n + j, 3 * n + i); // top
    quad(i, n + i, n + j, j);                         // bottom
    quad(i, j, 2 * n + j, 2 * n + i);                 // outside
    quad(n + j, n + i, 3 * n + i, 3 * n + j);         // in the hole
  }
  return soup;
}

test::Soup far_away(const test::Soup& soup) {
  return test::mapped(test::tilted(soup), [](const test::Position& p) {
    return p + test::Position{{1000, -400, 300}};
  });
}

// Cells of a landscape of blocks, each unit square cut in two by two.
test::Soup blocks(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<int> heights(36);
  for (int& height : heights)
    height = 1 + static_cast<int>(random.below(3) / 2) + static_cast<int>(random.below(6) / 5);
  return test::surface_of_cubes(12, 12, 6, [&](int x, int y, int z) {
    return z / 2 < heights[static_cast<std::size_t>(x / 2 * 6 + y / 2)];
  });
}

// A gently curved sheet with noise and a jagged rim.
test::Soup panel() {
  test::Soup soup = test::with_noise(test::grid(30, 30), 5, 0.008);
  return test::with_noise(
      test::mapped(soup,
                   [](const test::Position& p) {
                     return test::Position{{p[0], p[1], 0.1 * std::cos(2 * p[0] - 1)}};
                   }),
      6, 0.001);
}

const std::vector<double> ladder{0,    1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9,
                                 1e-8, 1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1};

// For surfaces of any size: the limits are parts of the diagonal.
void require_fewer_faces_at_larger_limits(const test::Soup& input) {
  const double diagonal = test::diagonal(input);
  std::size_t least = input.triangles.size();
  for (double fraction : ladder) {
    const std::size_t faces = simplify_within(fraction * diagonal, input).report.faces_after;
    INFO(fraction << " of the diagonal: " << faces << " faces, " << least << " at a smaller limit");
    REQUIRE(100 * faces <= 101 * least + 200); // a hundredth and two are noise
    least = std::min(least, faces);
  }
}

} // namespace

TEMPLATE_TEST_CASE("No point of the result is further from the input than the limit", "", Quadric,
                   MemorylessQuadric) {
  const auto check = [](const Model& model, double limit, const auto& order) {
    Mesh mesh = model.mesh;
    const Report report = simplify<TestType, OptimalPlacement>(mesh, DistanceLimit{limit}, order);
    mesh.collect_garbage();
    INFO(model.name << ", limit " << limit << ": " << report);
    REQUIRE(report.stop == StopReason::target_met);
    REQUIRE(report.distance_bound <= limit);
    const double measured = distance_to(model.mesh, mesh, limit);
    CAPTURE(measured);
    REQUIRE(measured <= report.distance_bound + limit / 10);
  };
  for (const Model& model : models())
    for (double fraction : {0.002, 0.02}) {
      const double limit = fraction * bounding_box_diagonal(model.mesh);
      check(model, limit, GreedyOrder{});
      check(model, limit, RelaxedOrder{});
      check(model, limit, RelaxedOrder{.refresh = true});
    }
}

TEST_CASE("A limit in a stop policy that does not ask for distances lets nothing pass") {
  const auto limit = [](const Status& status) { return DistanceLimit{1e9}(status); };
  Mesh mesh = read_model("cow");
  const std::size_t faces = mesh.number_of_faces();
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, limit).faces_after == faces);
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, limit, RelaxedOrder{}).faces_after == faces);
}

TEST_CASE("Inside of a surface the limit is used, and not only kept") {
  const Mesh input = test::make_mesh(test::sphere(5));
  const double limit = 0.005 * bounding_box_diagonal(input);
  Mesh mesh = input;
  const Report report = simplify(mesh, DistanceLimit{limit});
  mesh.collect_garbage();
  INFO(report);
  CHECK(report.faces_after < report.faces_before / 3);
  CHECK(distance_to(input, mesh, limit) > limit / 8);
}

TEST_CASE("Where topology is free what contractions add up to is bounded, too") {
  for (const Mesh& input : {read_model("cow"), test::make_mesh(test::sphere(4))}) {
    const double limit = 0.2 * bounding_box_diagonal(input);
    Mesh mesh = input;
    const Report report =
        simplify(mesh, DistanceLimit{limit}, EdgeLength{}, MidpointPlacement{}, Topology::free);
    mesh.collect_garbage();
    INFO(report);
    CHECK(report.contractions > 100);
    CHECK(report.distance_bound <= limit);
    CHECK(distance_to(input, mesh, limit) <= report.distance_bound + limit / 10);
  }
}

TEST_CASE("Inside of a surface a limit goes as far where topology is free as where it is kept") {
  for (const char* name : {"cow", "lion-head"}) {
    const Mesh input = read_model(name);
    const double limit = 0.005 * bounding_box_diagonal(input);
    Mesh kept = input, free = input;
    const std::size_t faces = simplify(kept, DistanceLimit{limit}).faces_after;
    const Report report = simplify(free, DistanceLimit{limit}, Topology::free);
    free.collect_garbage();
    INFO(name << ": " << report << ", kept: " << faces);
    CHECK(10 * report.faces_after < 11 * faces);
    CHECK(report.distance_bound <= limit);
    CHECK(distance_to(input, free, limit) <= report.distance_bound + limit / 10);
  }
}

TEST_CASE("A flat part costs no distance at all") {
  Mesh mesh = test::make_mesh(test::cube(12));
  const Report report = simplify(mesh, DistanceLimit{1e-6});
  CHECK(report.distance_bound <= 1e-6);
  CHECK(report.faces_after < 100);
}

TEST_CASE("A flat sheet is left with two faces at any limit, 0 included") {
  for (const test::Soup& sheet :
       {test::grid(16, 16), test::tilted(test::grid(16, 16)),
        test::mapped(test::tilted(test::grid(9, 14)), [](const test::Position& p) {
          return p + test::Position{{40, -70, 9}};
        })})
    for (double limit : ladder) {
      const auto [report, result] = simplify_within(limit, sheet);
      INFO("limit " << limit << ": " << report);
      CHECK(report.faces_after == 2);
      CHECK(report.stop == StopReason::target_met);
      CHECK(area(result) == Approx(area(sheet)).epsilon(1e-9)); // the border has not receded
    }
}

TEST_CASE("What is exact is contracted at any limit: boxes, and creases of any angle") {
  const test::Soup box = test::mapped(test::cube(8), [](const test::Position& p) {
    return test::Position{{0.5 * p[0], 0.6 * p[1], 0.6 * p[2]}};
  });
  for (double limit : ladder)
    for (const test::Soup& input : {box, test::tilted(box)}) {
      if (limit > 1e-2)
        continue; // there corners may go
      CHECK(simplify_within(limit, input).report.faces_after == 12);
    }
  for (double degrees : {170.0, 120.0, 90.0, 40.0, 15.0})
    for (double limit : {0.0, 1e-9, 1e-4}) {
      INFO(degrees << " degrees, limit " << limit);
      CHECK(simplify_within(limit, bent_sheet(degrees)).report.faces_after == 4);
      CHECK(simplify_within(limit, test::tilted(bent_sheet(degrees))).report.faces_after == 4);
    }
}

TEST_CASE("Bounds hold where more than two faces meet, and on jagged borders") {
  for (int count : {3, 5})
    for (double limit : {0.0, 1e-6, 0.01, 0.1}) {
      INFO(count << " sheets, limit " << limit);
      const test::Soup sheets = sheets_at_a_line(count);
      CHECK(simplify_within(limit, sheets).report.faces_after < sheets.triangles.size() / 8);
      simplify_within(limit, test::with_noise(sheets, 3, 0.01));
    }
  for (std::uint64_t seed = 0; seed < 12; ++seed)
    for (double limit : {0.003, 0.03, 0.2}) {
      INFO("seed " << seed << ", limit " << limit);
      simplify_within(limit, test::random_with_boundaries(seed));
      simplify_within(limit, test::random_with_boundaries(seed), RelaxedOrder{});
    }
}

TEST_CASE("Flat pages that share a straight edge are left with two faces each") {
  for (double limit : {0.0, 1e-9, 0.01})
    for (int count : {3, 4, 5, 6, 7, 8, 30}) {
      const test::Soup pages = count < 7 ? sheets_at_a_line(count) : odd_pages(count, 1);
      INFO(count << " pages, limit " << limit);
      const auto faces = static_cast<std::size_t>(2 * count);
      CHECK(simplify_within(limit, pages).report.faces_after == faces);
      CHECK(simplify_within(limit, wound_at_random(pages, 50, 2)).report.faces_after == faces);
      CHECK(simplify_within(limit, far_away(odd_pages(count, 3))).report.faces_after == faces);
    }
}

TEST_CASE("Walls between cells are left with what is exact") {
  for (double limit : {0.0, 0.01}) {
    INFO("limit " << limit);
    CHECK(simplify_within(limit, cells(4, 4)).report.faces_after == 480);
    CHECK(simplify_within(limit, cells(3, 3)).report.faces_after == 216);
    CHECK(simplify_within(limit, far_away(cells(2, 5))).report.faces_after == 72);
    CHECK(simplify_within(limit, foam(6)).report.faces_after == 10);
    CHECK(simplify_within(limit, far_away(wound_at_random(foam(8), 50, 1))).report.faces_after ==
          10);
    const std::size_t faces = simplify_within(limit, walls()).report.faces_after;
    CHECK(faces <= 14);
    CHECK(simplify_within(limit, wound_at_random(walls(), 50, 1)).report.faces_after == faces);
  }
}

TEST_CASE("Bounds hold at junction lines that are curved or rough") {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (double limit : {0.01, 0.1, 0.4}) {
      INFO("seed " << seed << ", limit " << limit);
      const test::Soup pages = odd_pages(3 + static_cast<int>(seed), seed, 1);
      simplify_within(limit, pages);
      simplify_within(limit, test::with_noise(pages, seed, 0.05), RelaxedOrder{});
      simplify_within(limit, wound_at_random(test::with_noise(cells(2, 4), seed, 0.02), 50, seed));
      simplify_within(limit, test::with_noise(walls(), seed, 0.02));
      const test::Soup films = test::with_noise(
          test::mapped(
              foam(6),
              [](const test::Position& p) {
                return p + test::Position{{0.1 * std::sin(3 * p[1]), 0.1 * std::cos(2 * p[2]), 0}};
              }),
          seed, 0.01);
      const std::size_t faces = simplify_within(limit, films).report.faces_after;
      const Report turned = simplify_within(limit, wound_at_random(films, 30, seed)).report;
      CHECK(turned.faces_after <= faces + faces / 50);
    }
}

TEST_CASE("How faces are wound does not matter to a limit") {
  const std::vector<test::Soup> inputs{
      test::sphere(4), test::torus(40, 20), test::with_noise(test::sphere(3), 1, 0.02),
      test::with_noise(test::grid(20, 20), 4, 0.01), test::to_soup(read_model("cow"))};
  for (const test::Soup& input : inputs) {
    const double limit = 0.003 * test::diagonal(input);
    const std::size_t alike = simplify_within(limit, input).report.faces_after;
    for (int percent : {1, 5, 50, 100}) {
      INFO(percent << " % are turned");
      const Report report = simplify_within(limit, wound_at_random(input, percent, 7)).report;
      CHECK(report.faces_after <= alike + alike / 50);
      CHECK(report.faces_after + alike / 50 >= alike);
    }
  }
}

TEST_CASE("Points on straight edges of a plate cost nothing") {
  for (std::uint32_t n : {32u, 64u, 96u, 128u})
    for (const test::Soup& plate : {plate_with_hole(n), far_away(plate_with_hole(n))}) {
      const auto [report, result] = simplify_within(0, plate);
      INFO(n << " points: " << report);
      // 4 (n + 8) are exact; a few more are left where faces would turn over.
      CHECK(report.faces_after <= 4 * (n + 8) + 12);
      const Report larger = simplify_within(1e-6, plate).report;
      CHECK(report.faces_after <= larger.faces_after + 12);
      CHECK(simplify_within(0, result).report.faces_after + 4 >= report.faces_after);
    }
}

TEST_CASE("A border recedes no further than the limit") {
  const test::Soup input = test::with_noise(test::grid(20, 20), 4, 0.01);
  for (double limit : {0.005, 0.02, 0.05}) {
    const auto [report, result] = simplify_within(limit, input);
    INFO("limit " << limit << ": " << report);
    CHECK(report.faces_after < 700);
    test::Soup border; // its vertices, as faces of no area
    for (std::uint32_t v = 0; v < 21; ++v)
      border.triangles.push_back({v, v, v});
    border.points = input.points;
    CHECK(sampled_distance_to(result, border) <= report.distance_bound);
  }
}

TEST_CASE("A larger limit leaves no more faces") {
  SECTION("box") {
    require_fewer_faces_at_larger_limits(test::cube(8));
    require_fewer_faces_at_larger_limits(test::tilted(test::cube(8)));
  }
  SECTION("plane") {
    require_fewer_faces_at_larger_limits(test::tilted(test::grid(16, 16)));
  }
  SECTION("blocks") {
    require_fewer_faces_at_larger_limits(blocks(1));
    require_fewer_faces_at_larger_limits(test::tilted(blocks(2)));
  }
  SECTION("panel") {
    require_fewer_faces_at_larger_limits(panel());
  }
  SECTION("fandisk") {
    require_fewer_faces_at_larger_limits(test::to_soup(read_model("fandisk")));
  }
}

TEST_CASE("At a hub the first face that is too far ends the measuring") {
  using namespace quadrille::internal;
  constexpr Index count = 1000; // faces around vertex 0
  Array<Vector<3>> positions{{{0, 0, 1}}};
  Array<TriangleComplex::Triangle> triangles;
  for (Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    positions.push_back({{std::cos(angle), std::sin(angle), 0}});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  TriangleComplex complex(positions.size(), triangles);
  PairStar star;
  star.gather(complex, 0, 1);
  const DistanceBounds bounds(count, 1);
  StarDeviation deviation;
  RecentFaces recent_faces;
  std::vector<float> after;
  std::size_t asked = 0;
  const auto is_too_far = [&](double distance, const StarTolerance& = {}) {
    ++asked;
    return distance > 0.01;
  };
  const auto is_one_fan = [](Index) { return false; };
  const Vector<3> x{{0, 0, 0.5}}; // far from each face
  CHECK(
      bounds.measure(star, 0, 1, positions, x, StarKind::oriented, {}, deviation, after, is_too_far)
          .from_input > 0.01);
  CHECK(asked == 1);
  CHECK(bounds.is_beyond_high_valence(complex, 0, 1, positions, x, recent_faces, is_one_fan,
                                      is_too_far));
  CHECK(asked == 2);
  // Far from a few faces only: the second time these are asked first.
  const Vector<3> y{{0.02, 0, 0.995}};
  CHECK(bounds.is_beyond_high_valence(complex, 0, 1, positions, y, recent_faces, is_one_fan,
                                      is_too_far));
  asked = 0;
  CHECK(bounds.is_beyond_high_valence(complex, 0, 1, positions, y, recent_faces, is_one_fan,
                                      is_too_far));
  CHECK(asked < 4);
  CHECK(!bounds.is_beyond_high_valence(complex, 0, 1, positions, {{0, 0, 0.999}}, recent_faces,
                                       is_one_fan, is_too_far));
}

TEST_CASE("Bounds stay with their faces when these get new numbers") {
  using namespace quadrille::internal;
  TriangleComplex complex(6, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}});
  DistanceBounds bounds(4);
  PairStar star;
  for (const StarFace& f : {StarFace(1, 2, 3), StarFace(3, 4, 5)})
    star.first.add_if(true, f);
  bounds.set(star, {0.25f, 2.0f});
  CHECK(bounds.greatest(complex) == 2);
  complex.remove_face(0);
  complex.remove_face(2);
  bounds.pack_if([&](Index face) { return !complex.is_removed(face); });
  complex.pack({1, 2, 3, 4, 5});
  CHECK(bounds.greatest(complex) == 2);
  complex.remove_face(1);
  CHECK(bounds.greatest(complex) == 0.25);
}

TEST_CASE("Without an error limit no bound is known") {
  Mesh mesh = test::make_mesh(test::sphere(3));
  CHECK(simplify(mesh, FaceCount{100}).distance_bound == std::numeric_limits<double>::infinity());
}

TEST_CASE("A relative limit is one on a surface as large as numbers are") {
  const Mesh input =
      test::make_mesh(test::mapped(test::with_noise(test::sphere(3), 1, 0.02),
                                   [](const test::Position& p) { return 1.7e308 * p; }));
  CHECK(bounding_box_diagonal(input) == std::numeric_limits<double>::max());
  Mesh mesh = input;
  CHECK(simplify<Quadric, OptimalPlacement>(mesh, DistanceLimit::relative(0)).contractions == 0);
  const Report report = simplify<Quadric, OptimalPlacement>(mesh, DistanceLimit::relative(0.001));
  CHECK(report.contractions > 0);
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.distance_bound <= 0.001 * std::numeric_limits<double>::max());
}

namespace {

// A type of which only some look at distances.
struct MayAsk {
  static constexpr Needs needs = {.distance = true};
  bool asks = false;
  std::size_t faces = 0;

  Needs needs_now() const { return {.distance = asks}; }
  bool operator()(const Status& status) const { return status.faces <= faces; }
};

} // namespace

TEMPLATE_TEST_CASE("What a stop policy does not ask for this time is not measured",
                   "[distance_limit]", GreedyOrder, RelaxedOrder) {
  const test::Soup noisy = test::with_noise(test::sphere(4), 1, 0.02);
  test::Soup plain = noisy, with = noisy, without = noisy;
  const auto simplified = [](test::Soup& soup, const auto& stop) {
    return simplify(soup.points, soup.triangles, stop, TestType{});
  };
  const Report expected = simplified(plain, FaceCount{200});
  const Report asked = simplified(with, MayAsk{true, 200});
  const Report unasked = simplified(without, MayAsk{false, 200});
  test::Soup any = noisy, all = noisy;
  const auto and_fewer = [](bool asks) { return AnyOf{MayAsk{asks, 200}, FaceCount{100}}; };
  CHECK(std::isinf(simplified(any, and_fewer(false)).distance_bound));
  CHECK(std::isfinite(simplified(all, AllOf{and_fewer(true), FaceCount{300}}).distance_bound));
  CHECK(asked.distance_bound > 0);
  CHECK(std::isfinite(asked.distance_bound));
  CHECK(std::isinf(unasked.distance_bound));
  CHECK(std::isinf(expected.distance_bound));
  CHECK(unasked.faces_after == 200);
  CHECK(unasked.rejections == expected.rejections);
  CHECK(without.points == plain.points);
  CHECK(without.triangles == plain.triangles);
}
