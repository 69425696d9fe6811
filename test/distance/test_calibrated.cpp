// A calibrated limit is kept, by another measure, and goes further than the sum of steps.
#include "farthest.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/bounded_hausdorff.h>
#include <quadrille/calibrated.h>
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace {

using namespace quadrille;
using test::Mesh;

} // namespace

TEST_CASE("A calibrated limit leaves fewer faces, and is kept as measured") {
  for (const Mesh& input : {test::make_mesh(test::with_noise(test::sphere(4), 1, 0.005)),
                            test::read_model("elephant")}) {
    const double limit = 0.01 * bounding_box_diagonal(input);
    Mesh by_sum = input;
    const Report sum = simplify(by_sum, HausdorffLimit{limit});
    const auto [mesh, report, factor] = calibrated(input, HausdorffLimit::relative(0.01));
    INFO(sum << "; calibrated by " << factor << ": " << report);
    CHECK(factor > 1);
    CHECK(report.faces_after == mesh.number_of_faces());
    CHECK(5 * report.faces_after < 4 * sum.faces_after);
    CHECK(report.hausdorff_bound <= limit);
    CHECK(bounded_hausdorff(input, mesh, limit / 50) <= report.hausdorff_bound + limit / 50);
    CHECK(surface_distance(input, mesh).hausdorff <= report.hausdorff_bound);
    // The same with all that simplify() takes.
    const auto other = calibrated<MemorylessQuadric>(
        input, HausdorffLimit{limit}, Calibration{.largest_factor = 2, .refinements = 0},
        RelaxedOrder{});
    CHECK(other.factor <= 2);
    CHECK(other.report.hausdorff_bound <= limit);
  }
}

TEST_CASE("A calibrated limit of a soup") {
  // Three pages with a line in common.
  test::Soup pages;
  for (double angle : {0.0, 2.0, 4.0}) {
    const auto page =
        test::mapped(test::with_noise(test::grid(12, 12), 5, 0.004), [&](const test::Position& p) {
          return test::Position{{p[0] * std::cos(angle) - p[2] * std::sin(angle), p[1],
                                 p[0] * std::sin(angle) + p[2] * std::cos(angle)}};
        });
    pages = pages.points.empty() ? page : test::joined(pages, page);
  }
  const auto points = test::points_of(pages);
  const auto [coarse, triangles, report, factor] =
      calibrated<MemorylessQuadric>(points, pages.triangles, HausdorffLimit{0.03});
  test::Soup result{{}, triangles};
  for (const test::Point& p : coarse)
    result.points.push_back(test::to_position(p));
  test::PointSoup by_sum(pages);
  const Report sum =
      simplify<MemorylessQuadric>(by_sum.points, by_sum.triangles, HausdorffLimit{0.03});
  CHECK(factor > 1);
  CHECK(report.faces_after == triangles.size());
  CHECK(report.faces_after < sum.faces_after);
  CHECK(report.hausdorff_bound <= 0.03);
  CHECK(std::max(test::farthest(result, pages, 8), test::farthest(pages, result, 8)) <=
        report.hausdorff_bound);
}

TEST_CASE("A calibrated limit of nothing, or of what holds no more, is the plain one") {
  const Mesh cube = test::make_mesh(test::cube(4));
  CHECK(calibrated(cube, HausdorffLimit{0}).report.faces_after == 12);
  const auto [mesh, report, factor] = calibrated(cube, HausdorffLimit{0.001});
  CHECK(report.faces_after == 12);
  CHECK(factor == 1);
  CHECK_THROWS_AS(calibrated(cube, HausdorffLimit{-1}), std::invalid_argument);
  for (const Calibration& wrong :
       {Calibration{.largest_factor = 0.5}, Calibration{.refinements = -1}, Calibration{.error = 0},
        Calibration{.error = 1}})
    CHECK_THROWS_AS(calibrated(cube, HausdorffLimit{1}, wrong), std::invalid_argument);
}
