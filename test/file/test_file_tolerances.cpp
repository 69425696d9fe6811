// Tolerances of vertices that lie in a file, by parts: what is left is looked at by CGAL's tree
// alone.

#include "farthest.h"
#include "folder.h"
#include "soups.h"
#include "surface_files.h"

#include <quadrille/distance_limits.h>
#include <quadrille/file.h>
#include <quadrille/memoryless_quadric.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Folder;
using test::Soup;

/// A surface with a distance that each vertex allows.
struct Tolerant {
  Soup soup;
  std::vector<double> tolerances;

  double of_face(const test::Triangle& t) const {
    return std::min({tolerances[t[0]], tolerances[t[1]], tolerances[t[2]]});
  }
};

constexpr double fine = 0.003, coarse = 0.03;

/// Closed; some stripes are to stay ten times as near as what is between them.
Tolerant surface(std::uint32_t along = 50, std::uint32_t around = 24) {
  Tolerant result{test::with_noise(test::torus(along, around), 1, 0.004), {}};
  for (const auto& p : result.soup.points)
    result.tolerances.push_back(std::abs(std::sin(1.5 * p[0])) < 0.4 ? fine : coarse);
  return result;
}

std::string tolerant_ply_of(const Tolerant& surface) {
  return test::ply_with(surface.soup, "allowed", surface.tolerances);
}

/// Without the tolerances, which have gone along.
Soup read_result(const Folder& folder) {
  std::string ply = test::content_of(folder.path("out.ply"));
  const std::string property = "property double allowed\n";
  const std::size_t at = ply.find(property);
  REQUIRE(at != std::string::npos);
  ply.erase(at, property.size());
  const std::size_t header = ply.find("end_header\n") + 11;
  const std::size_t words = ply.find("element vertex ") + 15;
  for (std::size_t v = 0; v < std::stoul(ply.substr(words)); ++v)
    ply.erase(header + 24 * (v + 1), 8);
  folder.file("plain.ply", ply);
  return test::read_ply(folder.path("plain.ply"));
}

OutOfCore in_chunks(const Folder& folder, std::uint64_t chunk_faces = 550) {
  OutOfCore options;
  options.scratch = folder.path("scratch");
  options.chunk_faces = options.whole_faces = chunk_faces;
  options.chunks_in_flight = 1;
  options.tolerance = "allowed";
  return options;
}

template <class Stop>
FileReport run(const Folder& folder, const OutOfCore& options, const Stop& stop) {
  return simplify_file<MemorylessQuadric, OptimalPlacement>(folder.path("in.ply"),
                                                            folder.path("out.ply"), stop, options);
}

std::size_t faces_in_memory(const Tolerant& surface) {
  Soup soup = surface.soup;
  simplify<MemorylessQuadric, OptimalPlacement>(
      soup.points, soup.triangles, ToleranceLimit{},
      parameters::vertex_tolerance_map(CGAL::make_property_map(surface.tolerances)));
  return soup.triangles.size();
}

// Returns how far the faces that allow more are at most.
double require_kept(const Tolerant& input, const Soup& output) {
  const test::Nearest left(output);
  double farthest = 0;
  std::size_t beyond = 0;
  std::array<Soup, 2> by_tolerance;
  for (const test::Triangle& t : input.soup.triangles) {
    const double tolerance = input.of_face(t);
    by_tolerance[tolerance == fine ? 0 : 1].triangles.push_back(t);
    test::for_each_point(input.soup, t, 3, [&](const test::Position& p) {
      const double distance = left.distance(p);
      beyond += distance > tolerance ? 1 : 0;
      if (tolerance == coarse)
        farthest = std::max(farthest, distance);
    });
  }
  CHECK(beyond == 0);
  by_tolerance[0].points = by_tolerance[1].points = input.soup.points;
  const test::Nearest of_fine(by_tolerance[0]), of_coarse(by_tolerance[1]);
  std::size_t away = 0;
  for (const test::Triangle& t : output.triangles)
    test::for_each_point(output, t, 4, [&](const test::Position& p) {
      away += of_fine.distance(p) > fine && of_coarse.distance(p) > coarse ? 1 : 0;
    });
  CHECK(away == 0);
  return farthest;
}

} // namespace

TEST_CASE("file tolerances: each face keeps its own, in as many parts as there are") {
  const Folder folder;
  const Tolerant input = surface(100, 40);
  folder.file("in.ply", tolerant_ply_of(input));
  const FileReport report = run(folder, in_chunks(folder), ToleranceLimit{});
  const Soup output = read_result(folder);
  CHECK(report.chunks >= 14);
  CHECK(report.phases >= 3);
  CHECK(report.stop == StopReason::target_met);
  CHECK(test::topology_of(output).genus() == 1);
  CHECK(require_kept(input, output) > 2 * fine);
  REQUIRE(report.used_tolerance);
  CHECK(report.used_tolerance->fraction <= 1);
  CHECK(report.used_tolerance->fraction > 0.9);
  CHECK(report.hausdorff_bound <= coarse);
  CHECK(report.hausdorff_bound > 0.9 * coarse);
  CHECK(test::farthest(input.soup, output, 2) <= report.hausdorff_bound);
  const std::size_t in_memory = faces_in_memory(input);
  INFO(output.triangles.size() << " faces, in memory " << in_memory);
  CHECK(20 * output.triangles.size() < 23 * in_memory);
  CHECK(20 * output.triangles.size() > 17 * in_memory);
}

TEST_CASE("file tolerances: in one part they are those of a run in memory") {
  const Folder folder;
  const Tolerant input = surface();
  folder.file("in.ply", tolerant_ply_of(input));
  const FileReport report = run(folder, in_chunks(folder, 9000), ToleranceLimit{});
  CHECK(report.chunks == 1);
  require_kept(input, read_result(folder));
  CHECK(report.hausdorff_bound == Approx(coarse * report.used_tolerance->fraction));
}

TEST_CASE("file tolerances: where they are 0 no vertex moves, and a count may come first") {
  const Folder folder;
  Tolerant input = surface();
  std::size_t kept = 0;
  for (std::size_t v = 0; v < input.soup.points.size(); ++v) {
    input.tolerances[v] = input.soup.points[v][0] < 0 ? 0 : 1e30;
    kept += input.tolerances[v] == 0 ? 1 : 0;
  }
  folder.file("in.ply", tolerant_ply_of(input));
  run(folder, in_chunks(folder, 300), ToleranceLimit{});
  const Soup output = read_result(folder);
  for (std::size_t v = 0; v < input.soup.points.size(); ++v)
    if (input.tolerances[v] == 0)
      CHECK(std::count(output.points.begin(), output.points.end(), input.soup.points[v]) == 1);
  CHECK(output.triangles.size() < 2 * kept + 300);
  OutOfCore options = in_chunks(folder, 300);
  options.whole_faces = 0;
  const FileReport report = run(folder, options, AnyOf{FaceCount{1700}, ToleranceLimit{}});
  CHECK(report.faces_after == 1700);
  CHECK(report.is_count_exact);
}

TEST_CASE("file tolerances: a run that has ended goes on with what faces have used") {
  const Folder folder;
  folder.file("in.ply", tolerant_ply_of(surface()));
  OutOfCore options = in_chunks(folder, 300);
  run(folder, options, ToleranceLimit{});
  const std::string once = test::content_of(folder.path("out.ply"));
  options.restart = true;
  options.chunks_in_flight = 2;
  int ends = 0;
  for (bool is_over = false; !is_over; ++ends) {
    int calls = 10 + 10 * ends;
    options.proceed = [&](const FileStatus&) { return --calls > 0; };
    is_over = run(folder, options, ToleranceLimit{}).stop != StopReason::cancelled;
    REQUIRE(ends < 100);
  }
  CHECK(ends > 2);
  CHECK(test::content_of(folder.path("out.ply")) == once);
  OutOfCore other = in_chunks(folder, 300);
  other.proceed = [](const FileStatus& status) { return status.stage != FileStage::simplify; };
  run(folder, other, ToleranceLimit{});
  other.restart = true;
  other.tolerance = "";
  CHECK_THROWS_WITH(run(folder, other, HausdorffLimit(coarse)),
                    Catch::Contains("of another file, or for another"));
}

TEST_CASE("file tolerances: whatever else is left out, they are read") {
  const Folder folder;
  const Tolerant input = surface();
  folder.file("in.ply", tolerant_ply_of(input));
  OutOfCore options = in_chunks(folder, 300);
  options.positions_only = true;
  run(folder, options, ToleranceLimit{});
  const std::string alone = test::content_of(folder.path("out.ply"));
  require_kept(input, read_result(folder));
  std::string more = tolerant_ply_of(input);
  more.insert(more.find("end_header"), "element extra 1\nproperty uchar number\n");
  folder.file("in.ply", more + "x");
  CHECK(run(folder, options, ToleranceLimit{}).dropped.size() == 1);
  CHECK(test::content_of(folder.path("out.ply")) == alone);
}

TEST_CASE("file tolerances: where tiles meet the least counts") {
  const Folder folder;
  const Tolerant whole{test::with_noise(test::grid(60, 40), 4, 0.004), {}};
  // Quadrilaterals by themselves, which have to stay, and behind their holes all that is around.
  std::array<Tolerant, 2> tiles;
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<std::uint32_t> place(whole.soup.points.size(), 0xFFFFFFFFU);
    for (std::size_t f = 0; f < whole.soup.triangles.size(); ++f) {
      const bool is_single = f / 2 % 60 % 6 == 3 && f / 120 % 6 == 3;
      if (is_single != (i == 0))
        continue;
      test::Triangle corners = whole.soup.triangles[f];
      for (std::uint32_t& v : corners) {
        if (place[v] == 0xFFFFFFFFU) {
          place[v] = static_cast<std::uint32_t>(tiles[i].soup.points.size());
          tiles[i].soup.points.push_back(whole.soup.points[v]);
          tiles[i].tolerances.push_back(i == 0 ? 1e-6 : 1);
        }
        v = place[v];
      }
      tiles[i].soup.triangles.push_back(corners);
    }
    const std::string name = "tile" + std::to_string(i) + ".ply";
    folder.file(name, tolerant_ply_of(tiles[i]));
    paths.insert(paths.begin(), folder.path(name));
  }
  simplify_file<MemorylessQuadric, OptimalPlacement>(paths, folder.path("out.ply"),
                                                     ToleranceLimit{}, in_chunks(folder, 300));
  CHECK(test::farthest(tiles[0].soup, read_result(folder), 2) <= 1e-6);
}

TEST_CASE("file tolerances: what makes no sense is refused, and nothing is left") {
  const Folder folder;
  Tolerant input = surface();
  folder.file("in.ply", tolerant_ply_of(input));
  OutOfCore options = in_chunks(folder, 300);
  CHECK_THROWS_WITH(run(folder, options, HausdorffLimit(1)), Catch::Contains("'allowed'"));
  CHECK_THROWS_WITH(run(folder, options, FaceCount{100}), Catch::Contains("'allowed'"));
  options.tolerance = "";
  CHECK_THROWS_WITH(run(folder, options, ToleranceLimit{}), Catch::Contains("needs tolerances"));
  options.tolerance = "other";
  CHECK_THROWS_WITH(run(folder, options, ToleranceLimit{}), Catch::Contains("in.ply") &&
                                                                Catch::Contains("other") &&
                                                                Catch::Contains("they have allowed"));
  options.tolerance = "allowed";
  for (const double bad : {-0.5, std::numeric_limits<double>::quiet_NaN()}) {
    input.tolerances[7] = bad;
    folder.file("in.ply", tolerant_ply_of(input));
    CHECK_THROWS_WITH(run(folder, options, ToleranceLimit{}),
                      Catch::Contains("in.ply") && Catch::Contains("of vertex 7"));
  }
  folder.file("in.stl", test::stl_of(input.soup));
  CHECK_THROWS_WITH((simplify_file<MemorylessQuadric, OptimalPlacement>(
                        folder.path("in.stl"), folder.path("out.ply"), ToleranceLimit{}, options)),
                    Catch::Contains("in.stl") && Catch::Contains("no scalar allowed"));
  CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  CHECK_FALSE(std::filesystem::exists(folder.path("out.ply")));
}
