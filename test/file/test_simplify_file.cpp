// Surfaces in parts, from a file to a file: against what is simplified in memory.

#include "farthest.h"
#include "soups.h"
#include "surface_files.h"

#include "folder.h"

#include <quadrille/distance.h>
#include <quadrille/distance_limits.h>
#include <quadrille/file.h>
#include <quadrille/memoryless_quadric.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::content_of;
using test::Folder;
using test::ply_of;
using test::read_ply;
using test::Soup;
using test::text_ply_of;
using test::topology_of;

constexpr std::uint64_t sixteenth = 550;

/// Closed, of genus 1, 8,000 faces.
Soup surface() {
  return test::as_floats(test::with_noise(test::torus(100, 40), 1, 0.004));
}

OutOfCore in_chunks(const Folder& folder, std::uint64_t chunk_faces, unsigned in_flight = 1) {
  OutOfCore options;
  options.scratch = folder.path("scratch");
  options.chunk_faces = chunk_faces;
  options.chunks_in_flight = in_flight;
  return options;
}

template <class Cost = MemorylessQuadric>
FileReport run(const Folder& folder, const OutOfCore& options, std::size_t faces = 800,
               const std::string& input = "in.ply") {
  return simplify_file<Cost, OptimalPlacement>(folder.path(input), folder.path("out.ply"),
                                               FaceCount{faces}, options);
}

// What a run without interruption makes of the surface, as the bytes of a file; the file is gone.
std::string content_at_once(const Folder& folder, const OutOfCore& options) {
  folder.file("in.ply", ply_of(surface()));
  run(folder, options);
  std::string content = content_of(folder.path("out.ply"));
  std::filesystem::remove(folder.path("out.ply"));
  return content;
}

// Ends before parts are made anew for the second phase.
OutOfCore ended_early(OutOfCore options) {
  options.proceed = [](const FileStatus& status) { return status.stage != FileStage::regroup; };
  return options;
}

double rms(const Soup& a, const Soup& b) {
  return surface_distance(a.points, a.triangles, b.points, b.triangles, {20'000, 0}).rms;
}

template <class Cost>
double rms_in_memory(Soup soup, std::size_t faces) {
  const Soup input = soup;
  simplify<Cost, OptimalPlacement>(soup.points, soup.triangles, FaceCount{faces});
  return rms(input, soup);
}

template <class Cost>
void require_as_in_memory() {
  const Folder folder;
  const Soup input = surface();
  folder.file("in.ply", ply_of(input));
  const double in_memory = rms_in_memory<Cost>(input, 800);
  for (const std::uint64_t chunk_faces : {8000U, 2200U, 550U, 140U}) {
    INFO(chunk_faces << " faces a part");
    const FileReport report = run<Cost>(folder, in_chunks(folder, chunk_faces));
    const Soup output = read_ply(folder.path("out.ply"));
    const auto topology = topology_of(output);
    CHECK(topology.is_manifold);
    CHECK(topology.is_oriented);
    CHECK(topology.is_closed());
    CHECK(topology.genus() == 1);
    CHECK(output.triangles.size() == 800);
    CHECK(report.faces_after == 800);
    CHECK(report.is_count_exact);
    CHECK(report.stop == StopReason::target_met);
    CHECK(report.chunks >= 7000 / chunk_faces);
    CHECK(report.contractions == input.points.size() - output.points.size());
    CHECK(rms(input, output) < (chunk_faces < 200 ? 1.04 : 1.02) * in_memory);
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  }
}

TEST_CASE("A surface in parts becomes what it becomes in memory") {
  require_as_in_memory<MemorylessQuadric>();
}

TEST_CASE("Costs that remember find in each phase what vertices remembered") {
  require_as_in_memory<Quadric>();
}

TEST_CASE("In one part, all bytes are those of a run in memory") {
  const Folder folder;
  Soup soup = surface();
  folder.file("in.ply", ply_of(soup));
  run(folder, in_chunks(folder, 8000));
  simplify<MemorylessQuadric, OptimalPlacement>(soup.points, soup.triangles, FaceCount{800});
  CHECK(test::is_identical(test::as_floats(soup), read_ply(folder.path("out.ply"))));
}

TEST_CASE("The output does not depend on how many parts are in flight") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  run(folder, in_chunks(folder, sixteenth));
  const std::string once = content_of(folder.path("out.ply"));
  for (const unsigned in_flight : {2U, 5U}) {
    run(folder, in_chunks(folder, sixteenth, in_flight));
    CHECK(content_of(folder.path("out.ply")) == once);
  }
}

TEST_CASE("Byte order and type of numbers change nothing") {
  const Folder folder;
  folder.file("little.ply", ply_of(surface()));
  folder.file("big.ply", ply_of(surface(), true));
  folder.file("double.ply", ply_of<double>(surface()));
  folder.file("big_double.ply", ply_of<double>(surface(), true));
  run(folder, in_chunks(folder, sixteenth), 800, "little.ply");
  const std::string little = content_of(folder.path("out.ply"));
  run(folder, in_chunks(folder, sixteenth), 800, "big.ply");
  CHECK(content_of(folder.path("out.ply")) == little);
  const Soup floats = read_ply(folder.path("out.ply"));
  for (const char* const name : {"double.ply", "big_double.ply"}) {
    run(folder, in_chunks(folder, sixteenth), 800, name);
    const Soup doubles = read_ply(folder.path("out.ply"));
    CHECK(test::is_identical(test::as_floats(doubles), floats));
    CHECK_FALSE(test::is_identical(doubles, floats));
  }
}

TEST_CASE("Corners of an STL file become vertices") {
  const Folder folder;
  folder.file("in.stl", test::stl_of(surface()));
  run(folder, in_chunks(folder, sixteenth), 800, "in.stl");
  const auto topology = topology_of(read_ply(folder.path("out.ply")));
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.genus() == 1);
  CHECK(topology.faces == 800);
}

TEST_CASE("Where the whole does not fit, all parts give their share to a count") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  OutOfCore options = in_chunks(folder, sixteenth);
  options.whole_faces = 100;
  const FileReport report = run(folder, options);
  CHECK(report.is_count_exact);
  const Soup output = read_ply(folder.path("out.ply"));
  CHECK(report.faces_after == 800);
  CHECK(output.triangles.size() == 800);
  const auto topology = topology_of(output);
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.genus() == 1);
  CHECK(rms(surface(), output) <
        1.1 * rms_in_memory<MemorylessQuadric>(surface(), output.triangles.size()));
}

// Of a surface in 16 parts that does not fit into memory as a whole before its last phase: what is
// left, which CGAL's tree measures.
template <class Limit>
void require_within(const Soup& input, const Limit& limit, bool both_ways) {
  const Folder folder;
  folder.file("in.ply", ply_of<double>(input));
  OutOfCore options = in_chunks(folder, sixteenth);
  options.whole_faces = sixteenth;
  const FileReport report = simplify_file<MemorylessQuadric, OptimalPlacement>(
      folder.path("in.ply"), folder.path("out.ply"), limit, options);
  const Soup output = read_ply(folder.path("out.ply"));
  CHECK(report.chunks >= 14);
  CHECK(report.phases >= 3);
  CHECK(report.stop == StopReason::target_met);
  CHECK(topology_of(output).is_manifold);
  const double distance = limit.distance(report.diagonal);
  const double from_input = test::farthest(output, input, 4);
  CHECK(from_input <= report.distance_bound);
  CHECK(report.distance_bound <= distance);
  CHECK(from_input > 0.2 * distance);
  if (both_ways) {
    CHECK(test::farthest(input, output, 2) <= report.hausdorff_bound);
    CHECK(report.hausdorff_bound <= distance);
  }
  Soup in_memory = input;
  simplify<MemorylessQuadric, OptimalPlacement>(in_memory.points, in_memory.triangles, limit);
  INFO(output.triangles.size() << " faces, in memory " << in_memory.triangles.size());
  CHECK(20 * output.triangles.size() < 23 * in_memory.triangles.size());
  CHECK(20 * output.triangles.size() > 17 * in_memory.triangles.size());
}

TEST_CASE("What is within a distance in each part is so as a whole") {
  require_within(surface(), HausdorffLimit::relative(0.006), true);
  require_within(test::with_noise(test::grid(70, 60), 4, 0.004), DistanceLimit::relative(0.002),
                 false);
}

TEST_CASE("A limit of distances and a count end a run by parts at what comes first") {
  const Folder folder;
  const Soup input = surface();
  folder.file("in.ply", ply_of<double>(input));
  const auto faces = [&](const auto& stop) {
    const FileReport report = simplify_file<Quadric, OptimalPlacement>(
        folder.path("in.ply"), folder.path("out.ply"), stop, in_chunks(folder, sixteenth));
    CHECK(report.distance_bound <= 0.01 * report.diagonal);
    return report.faces_after;
  };
  const DistanceLimit limit = DistanceLimit::relative(0.01);
  const std::size_t at_limit = faces(limit);
  CHECK(at_limit > 100);
  CHECK(faces(AnyOf{FaceCount{2000}, limit}) == 2000);
  CHECK(faces(AnyOf{limit, FaceRatio{0.25}}) == 2000);
  CHECK(10 * faces(AnyOf{FaceCount{50}, limit}) < 11 * at_limit);
  CHECK_THROWS_WITH(faces(DistanceLimit(-1)), Catch::Contains("-1"));
  CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
}

TEST_CASE("Borders that several parts have stay borders") {
  const Folder folder;
  const Soup input = test::as_floats(test::with_noise(test::grid(60, 60), 3, 0.002));
  folder.file("in.ply", ply_of(input));
  run(folder, in_chunks(folder, 500), 720);
  const Soup output = read_ply(folder.path("out.ply"));
  const auto topology = topology_of(output);
  CHECK(topology.is_manifold);
  CHECK(topology.boundary_loops == 1);
  CHECK(topology.euler() == 1);
  CHECK(topology.faces == 720);
  CHECK(rms(input, output) < 1.03 * rms_in_memory<MemorylessQuadric>(input, 720));
}

TEST_CASE("Boundaries may be locked, wherever parts are cut") {
  const Folder folder;
  const Soup input = test::with_holes(test::with_noise(test::grid(70, 60), 4, 0.004), 3, 6);
  folder.file("in.ply", ply_of<double>(input));
  OutOfCore options = in_chunks(folder, sixteenth);
  options.locks_boundary = true;
  run(folder, options, 1200);
  const Soup output = read_ply(folder.path("out.ply"));
  const auto sorted = [](const std::array<double, 3>& p, const std::array<double, 3>& q) {
    return p < q ? std::array{p, q} : std::array{q, p};
  };
  const auto boundary = [&](const Soup& soup) {
    std::map<std::array<std::uint32_t, 2>, int> faces;
    for (const test::Triangle& t : soup.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        ++faces[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
    std::set<std::array<std::array<double, 3>, 2>> edges;
    for (const auto& [edge, count] : faces)
      if (count == 1)
        edges.insert(sorted(soup.points[edge[0]].coordinates, soup.points[edge[1]].coordinates));
    return edges;
  };
  CHECK(output.triangles.size() <= 1201);
  CHECK(boundary(output) == boundary(input));
}

TEST_CASE("Small parts of the surface may vanish, wherever it is cut") {
  const Folder folder;
  Soup input = surface();
  test::Random random(8);
  const auto at = [&] { return 0.01 * (static_cast<double>(random.below(400)) - 200); };
  for (int i = 0; i < 40; ++i) {
    const test::Position place{{at(), at(), 1 + at()}};
    input = test::joined(input, test::mapped(test::tetrahedron(), [&](const test::Position& p) {
                           return 0.01 * p + place;
                         }));
  }
  folder.file("in.ply", ply_of<double>(input));
  OutOfCore options = in_chunks(folder, sixteenth);
  const auto faces = [&](Topology topology) {
    return simplify_file<Quadric, OptimalPlacement>(folder.path("in.ply"), folder.path("out.ply"),
                                                    FaceCount{100}, options, {}, {}, topology)
        .faces_after;
  };
  CHECK(faces(Topology::kept) > 160);
  CHECK(faces(Topology::components_may_vanish) == 100);
  CHECK(topology_of(read_ply(folder.path("out.ply"))).is_closed());
}

TEST_CASE("Several pieces and vertices without a face") {
  const Folder folder;
  Soup input = test::joined(surface(), test::torus(20, 10), {{0.1, 3, 0}});
  input.points.push_back({{9, 9, 9}});
  input.triangles.push_back({3, 3, 5});
  folder.file("in.ply", ply_of(input));
  const FileReport report = run(folder, in_chunks(folder, sixteenth), 1000);
  const auto topology = topology_of(read_ply(folder.path("out.ply")));
  CHECK(topology.components == 2);
  CHECK(topology.genus() == 2);
  CHECK(topology.is_closed());
  CHECK(topology.faces == 1000);
  CHECK(report.faces_before == 8401);
  CHECK(report.counted_faces == 8400);
}

TEST_CASE("What no face uses belongs to no box, and need not be finite") {
  const Folder folder;
  Soup input = surface();
  folder.file("in.ply", ply_of<double>(input));
  const FileReport plain = run(folder, in_chunks(folder, sixteenth));
  const std::string once = content_of(folder.path("out.ply"));
  for (const double far : {1000., 1e16, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    INFO(far);
    Soup with_far = input;
    with_far.points.push_back({{far, far, -far}});
    folder.file("in.ply", ply_of<double>(with_far));
    const FileReport report = run(folder, in_chunks(folder, sixteenth));
    CHECK(content_of(folder.path("out.ply")) == once);
    CHECK(report.diagonal == plain.diagonal);
    CHECK(report.error == plain.error);
    CHECK(report.unused_not_finite == (std::isnan(far) ? 1 : 0));
  }
}

TEST_CASE("A vertex of faces that is far away takes no faces from the others") {
  const Folder folder;
  for (const double far : {1e4, 1e10, 1e25}) {
    INFO(far);
    Soup input = surface();
    input.points[1000] = {{far, far, far}};
    folder.file("in.ply", ply_of(input));
    const FileReport report = run(folder, in_chunks(folder, sixteenth));
    CHECK(report.faces_after == 800);
    CHECK(report.stop == StopReason::target_met);
    CHECK(topology_of(read_ply(folder.path("out.ply"))).is_closed());
  }
}

TEST_CASE("Faces that are there twice count once") {
  const Folder folder;
  Soup input = surface();
  const auto run_to_tenth = [&] {
    return simplify_file<MemorylessQuadric, OptimalPlacement>(
        folder.path("in.ply"), folder.path("out.ply"), FaceRatio{0.1},
        in_chunks(folder, sixteenth));
  };
  const Soup plain = input;
  for (auto [a, b, c] : plain.triangles)
    input.triangles.push_back({b, c, a});
  folder.file("in.ply", ply_of(input));
  const FileReport report = run_to_tenth();
  CHECK(report.doubled_faces == 8000);
  CHECK(report.counted_faces == 8000);
  const Soup output = read_ply(folder.path("out.ply"));
  CHECK(output.triangles.size() == 800);
  CHECK(topology_of(output).is_closed());
  CHECK(rms(plain, output) < 1.02 * rms_in_memory<MemorylessQuadric>(plain, 800));
  input = plain;
  for (auto [a, b, c] : plain.triangles)
    input.triangles.push_back({c, b, a}); // the backs of these
  folder.file("in.ply", ply_of(input));
  CHECK(run_to_tenth().doubled_faces == 0);
  CHECK(read_ply(folder.path("out.ply")).triangles.size() == 1600);
}

TEST_CASE("A surface that is small beside something far away is cut as evenly") {
  const Folder folder;
  const Soup input = test::joined(surface(), test::octahedron(), {{3000, 0, 0}});
  folder.file("in.ply", ply_of(input));
  const FileReport report = run(folder, in_chunks(folder, sixteenth), 808);
  CHECK(report.chunks > 12);
  const Soup output = read_ply(folder.path("out.ply"));
  const auto topology = topology_of(output);
  CHECK(topology.is_closed());
  CHECK(topology.components == 2);
  CHECK(topology.genus() == 1);
  CHECK(topology.faces == 808);
  CHECK(rms(input, output) < 1.03 * rms_in_memory<MemorylessQuadric>(input, 808));
}

// Four tiles of a surface, by where the middles of faces are: each with vertices of its own.
std::vector<Soup> tiles_of(const Soup& soup) {
  std::vector<Soup> tiles(4);
  std::vector<std::map<std::uint32_t, std::uint32_t>> numbers(4);
  for (const test::Triangle& t : soup.triangles) {
    const test::Position middle = soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]];
    const std::size_t tile = (middle[0] > 0 ? 1 : 0) + (middle[1] > 0.1 ? 2 : 0);
    test::Triangle& to = tiles[tile].triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [found, is_new] =
          numbers[tile].try_emplace(t[i], static_cast<std::uint32_t>(tiles[tile].points.size()));
      if (is_new)
        tiles[tile].points.push_back(soup.points[t[i]]);
      to[i] = found->second;
    }
  }
  return tiles;
}

// Points at exactly the same place become one.
Soup sewn(const std::vector<Soup>& tiles) {
  Soup soup;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  for (const Soup& tile : tiles)
    for (const test::Triangle& t : tile.triangles) {
      test::Triangle& to = soup.triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [found, is_new] = numbers.try_emplace(
            tile.points[t[i]].coordinates, static_cast<std::uint32_t>(soup.points.size()));
        if (is_new)
          soup.points.push_back(tile.points[t[i]]);
        to[i] = found->second;
      }
    }
  return soup;
}

void require_whole(const Soup& output, std::size_t faces) {
  const auto topology = topology_of(output);
  CHECK(topology.is_manifold);
  CHECK(topology.is_oriented);
  CHECK(topology.is_closed());
  CHECK(topology.genus() == 1);
  CHECK(output.triangles.size() == faces);
}

TEST_CASE("Tiles whose borders coincide are one surface, and may be tiles again") {
  const Soup input = surface();
  const std::vector<Soup> tiles = tiles_of(input);
  for (const bool is_stl : {false, true}) {
    INFO((is_stl ? "STL" : "PLY"));
    const Folder folder;
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < tiles.size(); ++i)
      files.push_back(folder.file("tile" + std::to_string(i) + (is_stl ? ".stl" : ".ply"),
                                  is_stl ? test::stl_of(tiles[i]) : ply_of(tiles[i])));
    OutOfCore options = in_chunks(folder, sixteenth);
    const auto simplified = [&](const std::filesystem::path& output) {
      return simplify_file<MemorylessQuadric, OptimalPlacement>(files, output, FaceCount{800},
                                                                options);
    };
    const FileReport report = simplified(folder.path("out.ply"));
    CHECK(report.faces_after == 800);
    std::size_t vertices = 0; // of the tiles
    for (const Soup& tile : tiles)
      vertices += is_stl ? 3 * tile.triangles.size() : tile.points.size();
    CHECK(report.welded_vertices == vertices - input.points.size());
    require_whole(read_ply(folder.path("out.ply")), 800);
    if (!is_stl)
      CHECK(rms(input, read_ply(folder.path("out.ply"))) <
            1.1 * rms_in_memory<MemorylessQuadric>(input, 800));
    options.keeps_tiles = true;
    CHECK(simplified(folder.path("out")).faces_before == 8000);
    std::vector<Soup> kept;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      kept.push_back(read_ply(folder.path("out") / ("tile" + std::to_string(i) + ".ply")));
      CHECK(20 * kept[i].triangles.size() > tiles[i].triangles.size());
      CHECK(kept[i].triangles.size() * 5 < tiles[i].triangles.size());
    }
    require_whole(sewn(kept), 800);
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  }
}

TEST_CASE("Vertices at one place become one where tiles meet, and nowhere else") {
  const Folder folder;
  const Soup square = test::grid(1, 1);
  Soup slit = square; // each of its faces has vertices of its own
  slit.points.insert(slit.points.end(), square.points.begin(), square.points.end());
  for (std::uint32_t& v : slit.triangles[1])
    v += 4;
  const auto moved = [&](double x) {
    return folder.file("at" + std::to_string(static_cast<int>(x)) + ".ply",
                       ply_of(test::mapped(square, [&](const test::Position& p) {
                         return test::Position{{p[0] + x, p[1], 0}};
                       })));
  };
  const auto vertices = [&](double x) {
    const std::vector<std::filesystem::path> files{folder.file("slit.ply", ply_of(slit)), moved(x)};
    return simplify_file<Quadric>(files, folder.path("out.ply"), FaceCount{100},
                                  in_chunks(folder, 100))
        .vertices_after;
  };
  CHECK(vertices(5) == 6 + 4);
  CHECK(vertices(1) == 6 + 4 - 3); // at one of the two corners it has two vertices
}

TEST_CASE("Files that are no tiles of one surface are refused by their names") {
  const Folder folder;
  std::vector<Soup> tiles = tiles_of(surface());
  const auto refusal = [&](const std::vector<std::filesystem::path>& files, bool keeps = false) {
    OutOfCore options = in_chunks(folder, sixteenth);
    options.keeps_tiles = keeps;
    try {
      simplify_file<MemorylessQuadric, OptimalPlacement>(files, folder.path("out.ply"),
                                                         FaceCount{800}, options);
    } catch (const std::exception& error) {
      CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
      return std::string(error.what());
    }
    return std::string("none");
  };
  const auto a = folder.file("a.ply", ply_of(tiles[0])), b = folder.file("b.ply", ply_of(tiles[1]));
  const auto doubles = folder.file("doubles.ply", ply_of<double>(tiles[2]));
  const auto soup = folder.file("soup.stl", test::stl_of(tiles[3]));
  CHECK_THAT(refusal({a, doubles}), Catch::Contains("doubles.ply: has other properties"));
  CHECK_THAT(refusal({a, b, soup}),
             Catch::Contains("soup.stl: cannot be a tile of the same surface as"));
  CHECK_THAT(refusal({a, folder.path("none.ply")}), Catch::Contains("none.ply: cannot be opened"));
  CHECK_THAT(refusal({}), Catch::Contains("0 files were given"));
  std::filesystem::create_directory(folder.path("other"));
  CHECK_THAT(refusal({a, folder.file("other/a.ply", ply_of(tiles[1]))}, true),
             Catch::Contains("two tiles would be written to a.ply"));
  std::vector<int> degrees(tiles[1].points.size());
  for (const test::Triangle& t : tiles[1].triangles)
    for (const std::uint32_t v : t)
      ++degrees[v];
  const auto inner = std::find(degrees.begin(), degrees.end(), 6) - degrees.begin();
  tiles[1].points[static_cast<std::size_t>(inner)][2] = std::numeric_limits<double>::infinity();
  folder.file("b.ply", ply_of(tiles[1]));
  CHECK_THAT(refusal({a, b}),
             Catch::Contains("b.ply: vertex " + std::to_string(inner) + " has a value that is"));
}

TEST_CASE("Labels of faces go along, and their regions stay") {
  const Folder folder;
  const Soup input = surface();
  const std::string plain = ply_of(input);
  const std::size_t header = plain.find("end_header\n") + 11;
  const std::size_t faces = header + 12 * input.points.size();
  std::string ply = plain.substr(0, header - 11) +
                    "property short region\nproperty uchar flags2\n" +
                    plain.substr(header - 11, faces - header + 11);
  const auto region_of = [](std::size_t f) {
    return static_cast<std::int16_t>(f / 2000 * 300 - 1);
  };
  for (std::size_t f = 0; f < input.triangles.size(); ++f) {
    ply += plain.substr(faces + 13 * f, 13);
    test::put_number(ply, region_of(f));
    ply += static_cast<char>(7);
  }
  folder.file("in.ply", ply);
  run(folder, in_chunks(folder, sixteenth));
  const std::string output = content_of(folder.path("out.ply"));
  const std::size_t begin = output.find("end_header\n") + 11;
  CHECK(output.find("property short region\nproperty uchar flags2\n") < begin);
  std::map<int, Soup> regions;
  Soup whole;
  const std::size_t vertices = (output.size() - begin - 800 * 16) / 12;
  whole.points.resize(vertices);
  for (std::size_t f = 0; f < 800; ++f) {
    const char* const row = output.data() + begin + 12 * vertices + 16 * f;
    test::Triangle t;
    std::int16_t region = 0;
    std::memcpy(t.data(), row + 1, 12);
    std::memcpy(&region, row + 13, 2);
    REQUIRE(row[15] == 7);
    whole.triangles.push_back(t);
    regions[region].points.resize(vertices);
    regions[region].triangles.push_back(t);
  }
  CHECK(topology_of(whole).is_closed());
  REQUIRE(regions.size() == 4);
  for (const auto& [region, soup] : regions) { // each was a part of the ring: a tube
    CHECK((region + 1) % 300 == 0);
    const auto topology = topology_of(soup);
    CHECK(topology.is_manifold);
    CHECK(topology.components == 1);
    CHECK(topology.boundary_loops == 2);
    CHECK(topology.euler() == 0);
    CHECK(soup.triangles.size() > 100);
  }
}

// --- Attributes of vertices ----------------------------------------------------------------------

/// Of a place, from 0 to 255.
std::array<double, 3> color_at(const test::Position& p) {
  return {127.5 + 127.5 * std::sin(5 * p[0]), 127.5 + 60 * std::cos(7 * p[1] + p[2]), 40};
}

/// The surface with normals, which are those of its sphere, colours, a number and an integer.
std::string coloured_ply(const Soup& soup) {
  const std::string plain = ply_of(soup);
  const std::size_t header = plain.find("end_header\n") + 11;
  std::string ply = plain.substr(0, header);
  ply.insert(
      ply.find("element face"),
      "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty double heat\nproperty short id\n");
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const test::Position& p = soup.points[v];
    ply += plain.substr(header + 12 * v, 12);
    for (std::size_t i = 0; i < 3; ++i)
      test::put_number(ply, static_cast<float>(p[i] / std::sqrt(squared_length(p))));
    for (const double c : color_at(p))
      ply += static_cast<char>(static_cast<unsigned char>(std::lround(c)));
    test::put_number(ply, 1e6 * p[2]);
    test::put_number(ply, static_cast<std::int16_t>(p[0] > 0 ? 300 : -7));
  }
  return ply + plain.substr(header + 12 * soup.points.size());
}

struct Coloured {
  std::vector<test::Position> points, normals, colors;
  std::vector<double> heats;
  std::vector<int> ids;
  std::vector<test::Triangle> triangles;

  /// As simplify_file has written it.
  explicit Coloured(const std::string& ply) {
    const std::size_t at_vertices = ply.find("element vertex ") + 15;
    const std::size_t at_faces = ply.find("element face ") + 13;
    const char* at = ply.data() + ply.find("end_header\n") + 11;
    const auto next = [&]<class Number>(Number number) {
      std::memcpy(&number, at, sizeof(number));
      at += sizeof(number);
      return static_cast<double>(number);
    };
    for (std::size_t v = std::stoul(ply.substr(at_vertices)); v > 0; --v) {
      points.push_back({{next(0.0F), next(0.0F), next(0.0F)}});
      normals.push_back({{next(0.0F), next(0.0F), next(0.0F)}});
      colors.push_back({{next(std::uint8_t{}), next(std::uint8_t{}), next(std::uint8_t{})}});
      heats.push_back(next(0.0));
      ids.push_back(static_cast<int>(next(std::int16_t{})));
    }
    for (std::size_t f = std::stoul(ply.substr(at_faces)); f > 0; --f) {
      ++at;
      triangles.emplace_back();
      for (std::uint32_t& v : triangles.back())
        v = static_cast<std::uint32_t>(next(std::uint32_t{}));
    }
    REQUIRE(at == ply.data() + ply.size());
  }

  /// How far colours are from color_at(), at the middles of edges, the root of the mean square.
  double color_error() const {
    double sum = 0;
    for (const test::Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = t[i], w = t[(i + 1) % 3];
        const auto right = color_at(0.5 * (points[v] + points[w]));
        const test::Position color = 0.5 * (colors[v] + colors[w]);
        for (std::size_t c = 0; c < 3; ++c)
          sum += (color[c] - right[c]) * (color[c] - right[c]);
      }
    return std::sqrt(sum / static_cast<double>(9 * triangles.size()));
  }
};

TEST_CASE("Colours and other numbers of vertices go along") {
  const Folder folder;
  const Soup input = surface();
  folder.file("in.ply", coloured_ply(input));
  run<Quadric>(folder, in_chunks(folder, 8000));
  const double in_memory = Coloured(content_of(folder.path("out.ply"))).color_error();
  FileReport report = run<Quadric>(folder, in_chunks(folder, sixteenth));
  CHECK(report.dropped.empty());
  CHECK(report.chunks > 10);
  const std::string once = content_of(folder.path("out.ply"));
  CHECK(once.find("float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty "
                  "uchar red\nproperty uchar green\nproperty uchar blue\nproperty double "
                  "heat\nproperty short id\nelement face 800\n") != std::string::npos);
  const Coloured output(once);
  CHECK(output.color_error() < 1.05 * in_memory);
  CHECK(in_memory < 12);
  CHECK(topology_of({output.points, output.triangles}).genus() == 1);
  double heat_error = 0;
  for (std::size_t v = 0; v < output.points.size(); ++v) {
    CHECK(std::abs(std::sqrt(squared_length(output.normals[v])) - 1) < 1e-6);
    CHECK(output.colors[v][2] == 40);
    CHECK((output.ids[v] == 300 || output.ids[v] == -7));
    if (std::abs(output.points[v][0]) > 0.2)
      CHECK((output.ids[v] == 300) == (output.points[v][0] > 0));
    heat_error = std::max(heat_error, std::abs(output.heats[v] - 1e6 * output.points[v][2]));
  }
  CHECK(heat_error < 2e4);
  OutOfCore options = in_chunks(folder, sixteenth, 2);
  CHECK(run<Quadric>(folder, ended_early(options)).stop == StopReason::cancelled);
  options.restart = true;
  run<Quadric>(folder, options);
  CHECK(content_of(folder.path("out.ply")) == once);
}

TEST_CASE("How much they count is told, and they may be left out") {
  const Folder folder;
  folder.file("in.ply", coloured_ply(surface()));
  OutOfCore options = in_chunks(folder, sixteenth);
  run(folder, options);
  const double usual = Coloured(content_of(folder.path("out.ply"))).color_error();
  options.attribute_importance = 0.01;
  run(folder, ended_early(options));
  options.restart = true;
  options.attribute_importance = 1;
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains("of another file, or for another"));
  options.attribute_importance = 0.01;
  run(folder, options);
  CHECK(Coloured(content_of(folder.path("out.ply"))).color_error() > 1.2 * usual);
  options.attribute_importance = 0;
  CHECK_THROWS_AS(run(folder, options), std::invalid_argument);
  options.attribute_importance = 1;
  options.positions_only = true;
  CHECK(run(folder, options).dropped.size() == 8);
  const std::string alone = content_of(folder.path("out.ply"));
  folder.file("in.ply", ply_of(surface()));
  run(folder, options);
  CHECK(content_of(folder.path("out.ply")) == alone);
}

TEST_CASE("A ratio of the faces") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  simplify_file<MemorylessQuadric, OptimalPlacement>(folder.path("in.ply"), folder.path("out.ply"),
                                                     FaceRatio{0.1}, in_chunks(folder, sixteenth));
  CHECK(read_ply(folder.path("out.ply")).triangles.size() == 800);
}

// --- Interruptions -------------------------------------------------------------------------------

/// Runs in a process of its own that ends at once, with nothing put in order, when it is told how
/// far it is for the nth time. True if it came to its end.
bool run_and_die(const Folder& folder, OutOfCore options, int n) {
  const pid_t child = ::fork();
  if (child == 0) {
    options.proceed = [&](const FileStatus&) {
      if (n-- == 0)
        ::_exit(1);
      return true;
    };
    try {
      run(folder, options);
    } catch (...) {
      ::_exit(2);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  REQUIRE(WEXITSTATUS(status) != 2);
  return WEXITSTATUS(status) == 0;
}

TEST_CASE("A run that is killed anywhere goes on where it was") {
  const Folder folder;
  OutOfCore options = in_chunks(folder, sixteenth);
  const std::string once = content_at_once(folder, options);
  options.restart = true;
  int kills = 0;
  while (!run_and_die(folder, options, 7 + 60 * (kills % 8)))
    REQUIRE(++kills < 100);
  CHECK(kills > 2);
  CHECK(content_of(folder.path("out.ply")) == once);
  CHECK(folder.size() == 2); // the input and the output
}

TEST_CASE("A disk that is full ends in a sentence, and what is done stays") {
  const Folder folder;
  OutOfCore options = in_chunks(folder, sixteenth);
  const std::string once = content_at_once(folder, options);
  options.restart = true;
  for (const ::rlim_t most : {5'000U, 12'000U, 19'000U}) { // bytes of a file
    const pid_t child = ::fork();
    if (child == 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const ::rlimit limit{most, most};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      try {
        run(folder, options);
      } catch (const std::exception& error) {
        ::_exit(std::string(error.what()).find(": cannot be written in full: ") == std::string::npos
                    ? 2
                    : 1);
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 1);
    CHECK_FALSE(std::filesystem::exists(folder.path("out.ply")));
  }
  run(folder, options);
  CHECK(content_of(folder.path("out.ply")) == once);
}

std::uint64_t bytes_below(const std::filesystem::path& folder) {
  std::uint64_t bytes = 0;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      bytes += entry.is_regular_file() ? entry.file_size() : 0;
  return bytes;
}

TEST_CASE("What a job will take is told before it begins, and how far it is goes up only") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  folder.file("in.stl", test::stl_of(surface()));
  for (const char* const name : {"in.ply", "in.stl"})
    for (const std::size_t faces : {800U, 4000U}) {
      INFO(name << " to " << faces);
      OutOfCore options = in_chunks(folder, 2200);
      std::vector<FileStatus> told;
      std::uint64_t most = 0;
      options.proceed = [&](const FileStatus& status) {
        told.push_back(status);
        most = std::max(most, bytes_below(folder.path("scratch")));
        return true;
      };
      run<Quadric>(folder, options, faces, name);
      const FileEstimate estimate = told.front().estimate;
      CHECK(told.front().stage ==
            (name == std::string("in.stl") ? FileStage::weld : FileStage::survey));
      CHECK(told.front().progress == 0);
      CHECK(estimate.faces == 8000);
      CHECK(most <= estimate.scratch);
      CHECK(10 * most > 6 * estimate.scratch);
      const auto size = static_cast<double>(std::filesystem::file_size(folder.path("out.ply")));
      CHECK(std::abs(size - static_cast<double>(estimate.output)) < 0.04 * size);
      CHECK(estimate.memory > 32'000'000);
      CHECK(estimate.memory < 45'000'000);
      CHECK(std::is_sorted(told.begin(), told.end(), [](const FileStatus& a, const FileStatus& b) {
        return a.progress < b.progress - 0.02;
      }));
    }
}

TEST_CASE("A run ends when the user says so, and goes on") {
  const Folder folder;
  OutOfCore options = in_chunks(folder, sixteenth, 2);
  const std::string once = content_at_once(folder, options);
  CHECK(run(folder, ended_early(options)).stop == StopReason::cancelled);
  CHECK_FALSE(std::filesystem::exists(folder.path("out.ply")));
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains("has a job in it"));
  options.restart = true;
  CHECK_THROWS_WITH(run(folder, options, 900), Catch::Contains("of another file, or for another"));
  OutOfCore others = options;
  others.chunk_faces = 600;
  CHECK_THROWS_WITH(run(folder, others), Catch::Contains("of another file, or for another"));
  options.chunks_in_flight = 1;
  run(folder, options);
  CHECK(content_of(folder.path("out.ply")) == once);
}

TEST_CASE("Parts are run one by one, in any order, by any process") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  OutOfCore options = in_chunks(folder, sixteenth);
  run(folder, options);
  const std::string once = content_of(folder.path("out.ply"));
  using Job = PartitionedSimplifier<MemorylessQuadric, OptimalPlacement>;
  Job(folder.path("in.ply"), FaceCount{800}, options).partition();
  options.restart = true;
  bool is_over = false;
  while (!is_over) {
    Job job(folder.path("in.ply"), FaceCount{800}, options);
    job.partition();
    for (std::size_t part = job.chunks(); part-- > 1;)
      job.simplify(part);
    CHECK_THROWS_WITH(job.close(), Catch::Contains("chunk 0 of phase"));
    Job other(folder.path("in.ply"), FaceCount{800}, options);
    other.join();
    other.simplify(0);
    is_over = !job.close();
    if (is_over)
      job.merge(folder.path("out.ply"));
  }
  CHECK(content_of(folder.path("out.ply")) == once);
}

// --- The scratch folder is the user's ------------------------------------------------------------

/// All files below a folder, with their content, and all folders.
std::map<std::string, std::string> tree_of(const std::filesystem::path& path) {
  std::map<std::string, std::string> tree;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
    tree[entry.path().string()] = entry.is_directory() ? "" : content_of(entry.path());
  return tree;
}

TEST_CASE("Samples are taken one by one, in any order, by any process") {
  const Folder folder;
  OutOfCore options = in_chunks(folder, sixteenth);
  const std::string once = content_at_once(folder, options);
  using Job = PartitionedSimplifier<MemorylessQuadric, OptimalPlacement>;
  const auto made = [&] { return Job(folder.path("in.ply"), FaceCount{800}, options); };
  Job job = made();
  job.cut();
  do {
    if (job.samples() > 0) {
      CHECK(job.samples() == job.chunks());
      for (std::size_t i = job.samples(); i-- > 1;)
        job.sample(i);
      CHECK_THROWS_WITH(job.simplify(0), Catch::Contains("is not resolved"));
      Job other = made();
      other.join();
      CHECK_FALSE(other.sample(0, [] { return true; }));
      CHECK_THROWS_WITH(job.resolve(), Catch::Contains("sample 0 of phase"));
      other.sample(0);
      folder.file("scratch/quadrille-job/phase-" + std::to_string(job.phase()) + "/sample-1", "?");
      CHECK_THROWS_WITH(job.resolve(), Catch::Contains("sample 1 of phase"));
      other.sample(1);
      job.resolve();
    }
    for (std::size_t part = 0; part < job.chunks(); ++part)
      job.simplify(part);
  } while (job.regroup());
  job.merge(folder.path("out.ply"));
  CHECK(content_of(folder.path("out.ply")) == once);
  CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
}

TEST_CASE("A job removes what it has made, and nothing else") {
  const Folder folder;
  const auto scratch = folder.path("scratch");
  Soup bad = surface();
  bad.points[100][1] = std::numeric_limits<double>::quiet_NaN();
  folder.file("in.ply", ply_of(surface()));
  folder.file("in.stl", test::stl_of(surface()));
  folder.file("bad.ply", ply_of(bad));
  folder.file("bad.stl", test::stl_of(bad));
  for (const char* const name : {"phase-1/b", "welding", "empty", "quadrille-job"})
    std::filesystem::create_directories(scratch / name);
  for (const char* const name :
       {"labels", "plan", "welded-1.ply", "welding/run-0", "phase-1/plan", "phase-1/b/left-0"})
    folder.file((std::filesystem::path("scratch") / name).string(), name);
  const auto before = tree_of(scratch);
  for (const char* const input : {"in.ply", "in.stl"})
    run(folder, in_chunks(folder, sixteenth), 800, input);
  for (const char* const input : {"bad.ply", "bad.stl"})
    CHECK_THROWS_WITH(run(folder, in_chunks(folder, sixteenth), 800, input),
                      Catch::Contains(input) && Catch::Contains("not finite"));
  CHECK(tree_of(scratch) == before);

  OutOfCore options = in_chunks(folder, sixteenth, 1);
  run(folder, ended_early(options));
  folder.file("scratch/quadrille-job/phase-1/left-mine", "mine");
  std::filesystem::create_directory(scratch / "quadrille-job/phase-1/claims-7");
  folder.file("scratch/quadrille-job/phase-1/claims-7/0", ""); // of ranks that were killed
  folder.file("scratch/quadrille-job/job.unfinished-17", "");
  folder.file("scratch/quadrille-job/labels.unfinished", "");
  options.restart = true;
  run(folder, options);
  auto after = before;
  after[(scratch / "quadrille-job" / "phase-1").string()] = "";
  after[(scratch / "quadrille-job" / "phase-1" / "left-mine").string()] = "mine";
  CHECK(tree_of(scratch) == after);

  options.scratch = folder.path("a/b");
  CHECK_THROWS_WITH(run(folder, options, 800, "bad.ply"), Catch::Contains("not finite"));
  run(folder, options);
  CHECK_FALSE(std::filesystem::exists(folder.path("a")));
}

TEST_CASE("A folder that is no job's is not entered") {
  for (const char* const name : {"quadrille-job", "quadrille-job/a.txt", "quadrille-job/job",
                                 "quadrille-job/lock", "quadrille-job/phase-1/plan"}) {
    INFO(name);
    const Folder folder;
    folder.file("in.ply", ply_of(surface()));
    const auto path = folder.path("scratch") / name;
    std::filesystem::create_directories(path.parent_path());
    folder.file((std::filesystem::path("scratch") / name).string(), "of the user's");
    const auto before = tree_of(folder.path("scratch"));
    for (const bool restart : {false, true}) {
      OutOfCore options = in_chunks(folder, sixteenth);
      options.restart = restart;
      CHECK_THROWS_WITH(run(folder, options),
                        Catch::StartsWith(folder.path("scratch/quadrille-job").string()));
    }
    CHECK(tree_of(folder.path("scratch")) == before);
  }
}

TEST_CASE("One job at a time works in a folder, and who that is is told") {
  const Folder folder;
  OutOfCore options = in_chunks(folder, sixteenth);
  const std::string once = content_at_once(folder, options);
  using Job = PartitionedSimplifier<MemorylessQuadric, OptimalPlacement>;
  Job job(folder.path("in.ply"), FaceCount{800}, options);
  job.partition();
  options.restart = true;
  const auto process = "scratch: process " + std::to_string(::getpid()) + " of ";
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains(process));
  Job other(folder.path("in.ply"), FaceCount{800}, options);
  CHECK_THROWS_WITH(other.partition(), Catch::Contains(process));
  other.join(); // which may simplify parts
  other.simplify(3);
  CHECK_THROWS_WITH(other.close(), Catch::Contains(process));
  CHECK_THROWS_WITH(job.close(), Catch::Contains("chunk 0 of phase"));
  do
    for (std::size_t part = 0; part < job.chunks(); ++part)
      job.simplify(part);
  while (job.close());
  job.merge(folder.path("out.ply"));
  CHECK(content_of(folder.path("out.ply")) == once);
  CHECK_THROWS_WITH(other.join(), Catch::Contains("has no job in it"));
  std::filesystem::remove(folder.path("out.ply"));
  run(folder, options); // the lock is gone
  CHECK(content_of(folder.path("out.ply")) == once);
}

// --- What is wrong -------------------------------------------------------------------------------

void require_rejection(const std::string& name, const std::string& content,
                       const std::string& message) {
  const Folder folder;
  folder.file(name, content);
  INFO(message);
  CHECK_THROWS_WITH(run(folder, in_chunks(folder, sixteenth), 800, name),
                    Catch::Contains(folder.path(name).string() + ":") && Catch::Contains(message));
  CHECK(folder.size() == 1);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_CASE("Bad files end in a sentence that names the place") {
  const Soup soup = test::octahedron();
  const std::string ply = ply_of(soup);
  require_rejection("in.ply", "", "not a PLY file");
  require_rejection("in.ply", "OFF\n", ":1: not a PLY file");
  require_rejection("in.ply", replaced(ply, "binary_little_endian", "ascii"),
                    "ends before vertex 1 of 6");
  require_rejection("in.ply", replaced(ply, "float x", "floot x"), ":4: unknown type 'floot'");
  require_rejection("in.ply", replaced(ply, "float x", "float w"), "have no x, y and z");
  require_rejection("in.ply", replaced(ply, "float x", "int x"),
                    "neither all floats nor all doubles");
  require_rejection("in.ply", replaced(ply, "vertex 6", "vertex 6x"),
                    ":3: element count '6x' is not an integer");
  require_rejection("in.ply", replaced(ply, "vertex 6", "vertex 5000000000"),
                    "more than the indices of faces can express");
  require_rejection("in.ply", ply.substr(0, ply.size() - 60), "ends at byte");
  require_rejection("in.ply", ply.substr(0, ply.size() - 1), "within face 7 of 8");
  std::string changed = ply;
  changed[ply.size() - 13] = 4;
  require_rejection("in.ply", changed, "face 7 has 4 corners");
  changed = ply;
  changed[ply.size() - 4] = 6;
  require_rejection("in.ply", changed, "face 7 has vertex 6 of 6");
  Soup infinite = soup;
  infinite.points[2][1] = std::numeric_limits<double>::infinity();
  require_rejection("in.ply", ply_of(infinite), "vertex 2 is not finite");
  require_rejection("in.ply", ply_of({soup.points, {}}), "nothing to simplify");
  require_rejection("in.ply", ply_of({soup.points, {{0, 1, 1}}}), "nothing to simplify");
  require_rejection("in.ply", replaced(ply, "face 8", "face 7"), "goes on after the last element");
  require_rejection("in.ply", ply + '\n', "goes on after the last element");
  Soup loose;
  for (const test::Triangle& t : soup.triangles)
    for (const std::uint32_t v : t)
      loose.points.push_back(soup.points[v]);
  for (std::uint32_t v = 0; v < loose.points.size(); v += 3)
    loose.triangles.push_back({v + 1, v + 2, v});
  require_rejection("in.ply", ply_of(loose),
                    "no two of its faces share a vertex, so there is nothing to simplify: "
                    "'weld' merges vertices");
  const std::string stl = test::stl_of(soup);
  require_rejection("in.stl", test::stl_of({soup.points, {}}), "nothing to simplify");
  require_rejection("in.stl", stl.substr(0, 50), "ends within the 84 bytes");
  require_rejection("in.stl", stl.substr(0, stl.size() - 1),
                    "483 bytes; with 8 faces it would have 484");
  require_rejection("in.stl", "solid x\nendsolid\n", "is a text file");
}

TEST_CASE("Faces may stand before vertices") {
  const Folder folder;
  const Soup soup = surface();
  const std::string ply = ply_of(soup);
  const std::size_t body = ply.find("end_header\n") + 11, faces = body + 12 * soup.points.size();
  const std::size_t of_faces = ply.find("element face"), of_vertices = ply.find("element vertex");
  const std::string turned = ply.substr(0, of_vertices) +
                             ply.substr(of_faces, body - 11 - of_faces) +
                             ply.substr(of_vertices, of_faces - of_vertices) + "end_header\n" +
                             ply.substr(faces) + ply.substr(body, faces - body);
  folder.file("in.ply", ply);
  run(folder, in_chunks(folder, sixteenth));
  const std::string once = content_of(folder.path("out.ply"));
  folder.file("turned.ply", turned);
  run(folder, in_chunks(folder, sixteenth), 800, "turned.ply");
  CHECK(content_of(folder.path("out.ply")) == once);
  folder.file("turned.ply", turned + '\n');
  CHECK_THROWS_WITH(run(folder, in_chunks(folder, sixteenth), 800, "turned.ply"),
                    Catch::Contains("turned.ply: goes on after the last element"));
  std::string changed = turned;
  changed[turned.find("end_header\n") + 11 + 13] = 4;
  folder.file("turned.ply", changed);
  CHECK_THROWS_WITH(run(folder, in_chunks(folder, sixteenth), 800, "turned.ply"),
                    Catch::Contains("turned.ply: face 1 has 4 corners"));
}

TEST_CASE("Text and polygons become binary triangles first, in the order of the file") {
  const Folder folder;
  const Soup soup = surface(); // its faces are pairs that share their first edge, or their last
  folder.file("in.ply", ply_of(soup));
  run(folder, in_chunks(folder, sixteenth));
  const std::string once = content_of(folder.path("out.ply"));
  std::vector<std::vector<std::uint32_t>> triangles;
  for (const test::Triangle& t : soup.triangles)
    triangles.emplace_back(t.begin(), t.end());
  std::vector<std::vector<std::uint32_t>> with_nothing = triangles;
  with_nothing.push_back({4, 4, 7});
  with_nothing.push_back({});
  with_nothing.push_back({3, 3, 2, 3});
  for (const auto& faces : {triangles, with_nothing}) {
    const std::string text = text_ply_of(soup.points, faces);
    for (const std::string& content : {text, text.substr(0, text.size() - 1), text + " \n\n"}) {
      folder.file("text.ply", content);
      const FileReport report = run(folder, in_chunks(folder, sixteenth), 800, "text.ply");
      CHECK(report.faces_before == soup.triangles.size());
      CHECK(report.short_faces == faces.size() - triangles.size());
      CHECK(content_of(folder.path("out.ply")) == once);
      CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
    }
  }
}

TEST_CASE("Faces with vertices of their own become one surface where they meet") {
  const Folder folder;
  const Soup soup = sewn({surface()}); // its vertices are in the order of the faces
  folder.file("in.ply", ply_of(soup));
  run(folder, in_chunks(folder, sixteenth));
  const std::string once = content_of(folder.path("out.ply"));
  Soup loose;
  std::vector<std::vector<std::uint32_t>> faces;
  for (const test::Triangle& t : soup.triangles) {
    const auto v = static_cast<std::uint32_t>(loose.points.size());
    for (const std::uint32_t corner : t)
      loose.points.push_back(soup.points[corner]);
    loose.triangles.push_back({v, v + 1, v + 2});
    faces.push_back({v, v + 1, v + 2});
  }
  for (const std::string& content : {ply_of(loose), text_ply_of(loose.points, faces)}) {
    folder.file("loose.ply", content);
    OutOfCore options = in_chunks(folder, sixteenth);
    run(folder, ended_early(options), 800, "loose.ply");
    options.restart = true;
    const FileReport report = run(folder, options, 800, "loose.ply");
    CHECK(report.welded_vertices == loose.points.size() - soup.points.size());
    CHECK(content_of(folder.path("out.ply")) == once);
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  }
  folder.file("in.ply", coloured_ply(soup));
  run(folder, in_chunks(folder, sixteenth));
  const std::string with_numbers = content_of(folder.path("out.ply"));
  folder.file("loose.ply", coloured_ply(loose));
  run(folder, in_chunks(folder, sixteenth), 800, "loose.ply");
  CHECK(content_of(folder.path("out.ply")) == with_numbers);
  folder.file("loose.ply", ply_of<double>(loose));
  run(folder, in_chunks(folder, sixteenth), 800, "loose.ply");
  CHECK(topology_of(read_ply(folder.path("out.ply"))).is_closed());
  loose.points[7][0] = std::numeric_limits<double>::quiet_NaN();
  require_rejection("in.ply", ply_of(loose), "vertex 7 is not finite");
}

// Tiles in one file, each with vertices of its own.
Soup beside_each_other(const std::vector<Soup>& tiles) {
  Soup all;
  for (const Soup& tile : tiles) {
    const auto begin = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), tile.points.begin(), tile.points.end());
    for (const auto& [a, b, c] : tile.triangles)
      all.triangles.push_back({begin + a, begin + b, begin + c});
  }
  return all;
}

TEST_CASE("Vertices at exactly the same place become one if that is asked for") {
  const Folder folder;
  const std::vector<Soup> tiles = tiles_of(surface());
  const Soup slit = beside_each_other(tiles);
  OutOfCore options = in_chunks(folder, sixteenth);
  const auto simplified = [&](const std::string& content, bool welds) {
    folder.file("in.ply", content);
    options.welds = welds;
    run(folder, options);
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
    return content_of(folder.path("out.ply"));
  };
  const std::string once = simplified(ply_of(sewn(tiles)), false);
  CHECK(simplified(ply_of(slit), true) == once);
  CHECK(simplified(ply_of(slit, true), true) == once);
  CHECK_FALSE(
      topology_of(read_ply(folder.file("cut.ply", simplified(ply_of(slit), false)))).is_closed());
  CHECK(simplified(coloured_ply(slit), true) == simplified(coloured_ply(sewn(tiles)), false));
  CHECK(simplified(ply_of<double>(slit), true) == simplified(ply_of<double>(sewn(tiles)), false));

  SECTION("what no face uses is left out") {
    Soup with_unused = slit;
    with_unused.points.push_back(slit.points[0]);
    with_unused.points.push_back({{std::numeric_limits<double>::quiet_NaN(), 0, 0}});
    folder.file("in.ply", ply_of(with_unused));
    options.welds = true;
    CHECK(run(folder, options).unused_not_finite == 1);
    CHECK(topology_of(read_ply(folder.path("out.ply"))).genus() == 1);
  }
  SECTION("nothing is refused as without") {
    folder.file("in.ply", ply_of(Soup{}));
    options.welds = true;
    CHECK_THROWS_WITH(run(folder, options), Catch::Contains("in.ply: nothing to simplify"));
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  }
  SECTION("of tiles all do, not only those of their borders") {
    const std::vector<std::filesystem::path> files{
        folder.file("a.ply", ply_of(beside_each_other({tiles[0], tiles[1]}))),
        folder.file("b.ply", ply_of(beside_each_other({tiles[2], tiles[3]})))};
    options.welds = true;
    simplify_file<MemorylessQuadric, OptimalPlacement>(files, folder.path("out.ply"),
                                                       FaceCount{800}, options);
    require_whole(read_ply(folder.path("out.ply")), 800);
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
  }
  SECTION("but not where they have other numbers") {
    std::string content = coloured_ply(slit);
    const std::size_t faces = content.size() - 13 * slit.triangles.size();
    content[faces - 1] = 9; // the number of the last vertex, which lies at a border
    folder.file("in.ply", content);
    options.welds = true;
    CHECK_THROWS_WITH(run(folder, options),
                      Catch::Contains("in.ply: vertices ") &&
                          Catch::Contains(" lie at the same place and differ in nx, ny, nz, red, "
                                          "green, blue, heat, id, so they cannot be merged"));
    CHECK_FALSE(std::filesystem::exists(folder.path("scratch")));
    options.positions_only = true;
    run(folder, options);
    CHECK(content_of(folder.path("out.ply")) == once);
  }
}

TEST_CASE("Text that is not what it says is refused by the line, and nothing is left") {
  const std::string text =
      text_ply_of(test::octahedron().points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n3 0 2\n"), ":17: has fewer values");
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n3 0 2 3 4\n"),
                    ":17: has more values");
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n3 0 2 6\n"),
                    ":17: has vertex 6 of 6");
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n3 0 x 3\n"),
                    ":17: 'x' is not a number");
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n3 0 2 2.5\n"),
                    ":17: '2.5' is not a number of the type int");
  require_rejection("in.ply", replaced(text, "\n3 0 2 3\n", "\n300 0 2 3\n"),
                    ":17: '300' is not a number of the type uchar");
  require_rejection("in.ply", replaced(text, "face 3", "face 2"), ":18: goes on after the last");
  require_rejection("in.ply", replaced(text, "face 3", "face 4"), "ends before face 3 of 4");
}

TEST_CASE("Quadrilaterals and larger polygons are cut as in memory") {
  const Folder folder;
  Soup soup = test::grid(40, 40);
  std::vector<std::vector<std::uint32_t>> polygons;
  for (auto& p : soup.points)
    p[2] = 0.1 * std::sin(9 * p[0]) * p[1] * p[1];
  soup = test::as_floats(soup);
  for (std::uint32_t j = 0; j < 40; ++j)
    for (std::uint32_t i = 0; i < 40; i += 2) {
      const std::uint32_t a = 41 * j + i, b = a + 41;
      if (j % 2 == 0)
        polygons.push_back({a, a + 1, a + 2, b + 2, b + 1, b});
      else
        polygons.insert(polygons.end(), {{a, a + 1, b + 1, b}, {a + 1, a + 2, b + 2, b + 1}});
    }
  folder.file("in.ply", text_ply_of(soup.points, polygons));
  FileReport report = run(folder, in_chunks(folder, 600), 400);
  CHECK(report.faces_before == 3200);
  CHECK(report.faces_after == 400);
  CHECK(report.fans == 0);
  CHECK(rms(read_ply(folder.path("out.ply")), soup) < 0.002);
  OutOfCore options = in_chunks(folder, 600);
  run(folder, options, 4000);
  const Soup whole = read_ply(folder.path("out.ply"));
  CHECK(whole.points.size() == soup.points.size());
  CHECK(topology_of(whole).is_manifold);
  CHECK(rms(whole, soup) < 0.0005);
  polygons.push_back({0, 1, 2, 3, 4}); // in a line
  folder.file("in.ply", text_ply_of(soup.points, polygons));
  CHECK(run(folder, options, 4000).fans == 1);
}

TEST_CASE("Many colours of faces are no labels, nor are numbers of faces") {
  const Soup soup = test::as_floats(test::torus(20, 10));
  const std::string plain = ply_of(soup);
  const std::size_t header = plain.find("end_header\n");
  const std::size_t faces = header + 11 + 12 * soup.points.size();
  const auto with = [&](const std::string& name, std::size_t most) {
    std::string ply = plain.substr(0, header) + "property ushort " + name + "\n" +
                      plain.substr(header, faces - header);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      ply += plain.substr(faces + 13 * f, 13);
      test::put_number(ply, static_cast<std::uint16_t>(f * most / soup.triangles.size()));
    }
    return ply;
  };
  require_rejection("in.ply", with("red", 65), "more than 64 colours");
  require_rejection("in.ply", with("id", 201), "201 different labels");
  const Folder folder;
  for (const auto& [name, most] : {std::pair("red", 64), std::pair("id", 200)}) {
    folder.file("in.ply", with(name, static_cast<std::size_t>(most)));
    run(folder, in_chunks(folder, sixteenth), 300);
    CHECK(content_of(folder.path("out.ply")).find(std::string("ushort ") + name) < 400);
  }
  folder.file("in.ply", with("red", 400));
  OutOfCore options = in_chunks(folder, sixteenth);
  options.positions_only = true;
  CHECK(run(folder, options, 300).dropped == std::vector<std::string>{"property red of faces"});
}

TEST_CASE("What does not go along is refused before anything is written, or told") {
  const std::string ply = ply_of(test::octahedron());
  const auto with = [&](const std::string& properties, const std::string& of_vertex) {
    std::string text = replaced(ply, "element face", properties + "element face");
    std::size_t at = text.find("end_header\n") + 11;
    for (int v = 0; v < 6; ++v, at += 12 + of_vertex.size())
      text.insert(at + 12, of_vertex);
    return text;
  };
  const float infinity = std::numeric_limits<float>::infinity();
  std::string infinite;
  test::put_number(infinite, infinity);
  require_rejection("in.ply", with("property float heat\n", infinite),
                    "property heat of vertex 0 is not finite");
  std::string many;
  for (int i = 0; i < 65; ++i)
    many += "property uchar a" + std::to_string(i) + "\n";
  require_rejection("in.ply", with(many, std::string(65, '1')),
                    "its vertices have 65 different attributes");
  require_rejection("in.ply", with("property list uchar int neighbours\n", std::string(1, '\0')),
                    "its vertices have lists");
  require_rejection("in.ply", replaced(ply, "end_header", "property float area\nend_header"),
                    "has property area of faces, which cannot be kept");
  require_rejection("in.ply",
                    replaced(ply, "end_header", "property list uchar float texcoord\nend_header"),
                    "has property texcoord of faces, which");
  require_rejection("in.ply", replaced(ply, "end_header", "element edge 5\nend_header"),
                    "has element edge, which");
  const Folder folder;
  folder.file("in.ply", with("property uchar red\n", "7"));
  OutOfCore options = in_chunks(folder, sixteenth);
  CHECK(run(folder, options).dropped.empty());
  CHECK(content_of(folder.path("out.ply")).find("property uchar red\n") != std::string::npos);
  options.positions_only = true;
  CHECK(run(folder, options).dropped == std::vector<std::string>{"property red of vertices"});
  CHECK(read_ply(folder.path("out.ply")).triangles.size() == 8);
}

TEST_CASE("Files of the scratch folder that have changed end in a sentence") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  OutOfCore options = in_chunks(folder, sixteenth);
  using Job = PartitionedSimplifier<MemorylessQuadric, OptimalPlacement>;
  Job job(folder.path("in.ply"), FaceCount{800}, options);
  job.partition();
  job.simplify(1);
  const auto faces = folder.path("scratch") / "quadrille-job" / "phase-1" / "faces-0";
  const auto left = folder.path("scratch") / "quadrille-job" / "phase-1" / "left-1";
  std::string content = content_of(faces);
  content[17] ^= 1;
  folder.file("scratch/quadrille-job/phase-1/faces-0", content);
  CHECK_THROWS_WITH(job.simplify(0), Catch::Contains("faces-0: was changed after it was written"));
  content[17] ^= 1;
  folder.file("scratch/quadrille-job/phase-1/faces-0", content.substr(0, content.size() - 12));
  CHECK_THROWS_WITH(job.simplify(0), Catch::Contains("faces-0: has"));
  folder.file("scratch/quadrille-job/phase-1/faces-0", content);
  const std::string good = content_of(left);
  std::string bad = good;
  bad[bad.size() - 3] ^= 1;
  folder.file("scratch/quadrille-job/phase-1/left-1", bad);
  job.simplify(1); // is done again
  CHECK(content_of(left).substr(300) == good.substr(300));
  std::string plan = content_of(folder.path("scratch") / "quadrille-job" / "phase-1" / "plan");
  plan[40] ^= 1;
  folder.file("scratch/quadrille-job/phase-1/plan", plan);
  CHECK_THROWS_WITH(Job(folder.path("in.ply"), FaceCount{800}, options).join(),
                    Catch::Contains("plan: was changed after it was written"));
}

TEST_CASE(
    "a folder that can't be made, an output that can't be written, memory that is too small") {
  const Folder folder;
  folder.file("in.ply", ply_of(surface()));
  OutOfCore options = in_chunks(folder, sixteenth);
  options.scratch = folder.path("in.ply") / "scratch";
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains("cannot be made"));
  options.scratch.clear();
  CHECK_THROWS_AS(run(folder, options), std::invalid_argument);
  options = in_chunks(folder, sixteenth);
  options.memory = 1'000'000;
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains("is too small"));
  options = in_chunks(folder, sixteenth);
  std::filesystem::create_directory(folder.path("out.ply"));
  CHECK_THROWS_WITH(run(folder, options), Catch::Contains("out.ply: cannot be written"));
  std::filesystem::remove(folder.path("out.ply"));
  options.restart = true;
  CHECK(run(folder, options).faces_after == 800); // what was done is there
}

} // namespace
