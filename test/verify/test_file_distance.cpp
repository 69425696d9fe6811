// Distances of files that are measured by parts, against those in memory.
#include "../file/surface_files.h"
#include "folder.h"
#include "soups.h"

#include <quadrille/file_distance.h>
#include <quadrille/verify.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace {

using namespace quadrille;
using test::Folder;
using test::Soup;

/// 8,000 faces, and 1,250 that are near them.
Soup input_surface() {
  return test::as_floats(test::with_noise(test::torus(100, 40), 1, 0.01));
}
Soup result_surface() {
  return test::as_floats(test::with_noise(test::torus(50, 12), 2, 0.01));
}

struct Files {
  Files(const Soup& input, const Soup& result) : in(input), out(result) {
    folder.file("in.ply", test::ply_of<double>(input));
    folder.file("out.ply", test::ply_of<double>(result));
  }

  OutOfCore in_chunks(std::uint64_t faces) const {
    OutOfCore options;
    options.scratch = folder.path("scratch");
    options.chunk_faces = faces;
    return options;
  }
  SurfaceDistance distance(std::uint64_t chunk_faces, const DistanceSampling& sampling = {}) const {
    return file_distance(folder.path("in.ply"), folder.path("out.ply"), in_chunks(chunk_faces),
                         sampling);
  }
  SurfaceDistance distance_in_memory(const DistanceSampling& sampling = {}) const {
    return surface_distance(in.points, in.triangles, out.points, out.triangles, sampling);
  }
  Verdict verdict(const Claims& claims, std::uint64_t chunk_faces) const {
    return verify_files(folder.path("in.ply"), folder.path("out.ply"), claims,
                        in_chunks(chunk_faces));
  }
  Verdict verdict_in_memory(const Claims& claims) const {
    return verify(in.points, in.triangles, out.points, out.triangles, claims);
  }

  Folder folder;
  Soup in, out;
};

// What both have measured is right by half of the error of each.
void require_alike(const Verdict& a, const Verdict& b) {
  REQUIRE(a.findings.size() == b.findings.size());
  for (std::size_t i = 0; i < a.findings.size(); ++i) {
    CHECK(a.findings[i].claim == b.findings[i].claim);
    CHECK(a.findings[i].promised == b.findings[i].promised);
    CHECK(a.findings[i].error == Approx(b.findings[i].error).epsilon(1e-9));
    CHECK(std::abs(a.findings[i].measured - b.findings[i].measured) <= a.findings[i].error);
    CHECK(a.findings[i].is_met == b.findings[i].is_met);
  }
}

} // namespace

TEST_CASE("file distance: vertices are as far as in memory, samples about as far") {
  const Files files(input_surface(), result_surface());
  const SurfaceDistance vertices = files.distance_in_memory({0, 0});
  const SurfaceDistance samples = files.distance_in_memory({20'000, 0});
  for (const std::uint64_t chunk_faces : {100'000U, 2000U, 500U}) {
    INFO(chunk_faces << " faces a part");
    const SurfaceDistance by_vertices = files.distance(chunk_faces, {0, 0});
    CHECK(by_vertices.hausdorff_a_to_b == Approx(vertices.hausdorff_a_to_b).epsilon(1e-9));
    CHECK(by_vertices.hausdorff_b_to_a == Approx(vertices.hausdorff_b_to_a).epsilon(1e-9));
    const SurfaceDistance by_samples = files.distance(chunk_faces, {20'000, 0});
    CHECK(by_samples.rms_a_to_b == Approx(samples.rms_a_to_b).epsilon(0.02));
    CHECK(by_samples.rms_b_to_a == Approx(samples.rms_b_to_a).epsilon(0.02));
    CHECK(by_samples.rms == Approx(samples.rms).epsilon(0.02));
    CHECK_FALSE(std::filesystem::exists(files.folder.path("scratch")));
  }
}

TEST_CASE("file distance: what is gone is far from all that is left") {
  const Soup torus = test::torus(60, 30);
  const Files files(test::joined(torus, test::sphere(2), {{40, 0, 0}}), torus);
  const SurfaceDistance in_memory = files.distance_in_memory({0, 0});
  const SurfaceDistance by_parts = files.distance(600, {0, 0});
  CHECK(by_parts.hausdorff_a_to_b == Approx(in_memory.hausdorff_a_to_b).epsilon(1e-9));
  CHECK(by_parts.hausdorff_b_to_a < 1e-9);
  const Claims claims{.distance_both_ways = 0.01};
  require_alike(files.verdict(claims, 600), files.verdict_in_memory(claims));
}

TEST_CASE("file distance: surfaces that lie far apart") {
  const Soup torus = test::torus(60, 30);
  Soup moved = torus;
  for (auto& p : moved.points)
    p = p + test::Position{{7, 1, 2}};
  const Files files(torus, moved);
  const SurfaceDistance in_memory = files.distance_in_memory({0, 0});
  const SurfaceDistance by_parts = files.distance(600, {0, 0});
  CHECK(by_parts.hausdorff_a_to_b == Approx(in_memory.hausdorff_a_to_b).epsilon(1e-9));
  CHECK(by_parts.hausdorff_b_to_a == Approx(in_memory.hausdorff_b_to_a).epsilon(1e-9));
  const Claims claims{.distance_both_ways = 0.2};
  require_alike(files.verdict(claims, 600), files.verdict_in_memory(claims));
}

TEST_CASE("file distance: faces in the corner of the box that is looked into are not the nearest") {
  Soup ball = test::sphere(1);
  for (auto& p : ball.points)
    p = 0.1 * p;
  const Soup aside = test::joined({}, ball, {{1.35, 0, 0}});
  const Files files(ball, test::joined(aside, ball, {{1.2, 1.2, 1.2}}));
  const Claims claims{.distance_both_ways = 1};
  require_alike(files.verdict(claims, 600), files.verdict_in_memory(claims));
}

TEST_CASE("file distance: claims are held or broken as in memory") {
  const Files files(input_surface(), result_surface());
  const double apart = files.distance_in_memory().hausdorff;
  for (const double promised : {0.5 * apart, 1.5 * apart}) {
    INFO(promised << " promised");
    for (const Claims& claims :
         {Claims{.distance = promised}, Claims{.distance_both_ways = promised}})
      require_alike(files.verdict(claims, 600), files.verdict_in_memory(claims));
  }
  CHECK(files.verdict({}, 600).findings.empty());
}

TEST_CASE("file distance: tolerances are held or broken as in memory") {
  const Files files(input_surface(), result_surface());
  const double apart = files.distance_in_memory().hausdorff;
  OutOfCore how = files.in_chunks(600);
  how.tolerance = "allowed";
  for (const double least : {0.0, 1.2 * apart}) {
    INFO(least << " promised, and more elsewhere");
    Claims claims;
    for (const auto& p : files.in.points)
      claims.tolerances.push_back(p[0] < 0 ? least : p[1] < 0 ? 3 * least : 1e3);
    files.folder.file("in.ply", test::ply_with(files.in, "allowed", claims.tolerances));
    const Verdict verdict =
        verify_files(files.folder.path("in.ply"), files.folder.path("out.ply"), {}, how);
    require_alike(verdict, files.verdict_in_memory(claims));
    CHECK(verdict.findings.size() == 2);
    CHECK(verdict.is_met() == (least > apart));
  }
  CHECK_FALSE(std::filesystem::exists(files.folder.path("scratch")));
}

TEST_CASE("file distance: large faces are measured piece by piece against many small ones") {
  Soup plane = test::grid(60, 60);
  for (auto& p : plane.points)
    p[2] = 0.01 * std::sin(10 * p[0]) * std::sin(10 * p[1]);
  const Files files(plane, test::grid(1, 1));
  const Claims claims{.distance_both_ways = 0.011};
  require_alike(files.verdict(claims, 1000), files.verdict_in_memory(claims));
  CHECK(files.verdict(claims, 1000));
}

TEST_CASE("file distance: soups are welded, and files of other kinds are measured") {
  const Files files(input_surface(), result_surface());
  const Claims claims{.distance_both_ways = 0.2};
  files.folder.file("in.stl", test::stl_of(files.in));
  const Verdict verdict = verify_files(files.folder.path("in.stl"), files.folder.path("out.ply"),
                                       claims, files.in_chunks(2000));
  require_alike(verdict, files.verdict_in_memory(claims));
  CHECK_FALSE(std::filesystem::exists(files.folder.path("scratch")));
}

TEST_CASE("file distance: what can't be looked at is refused, and nothing is left behind") {
  const Files files(input_surface(), result_surface());
  CHECK_THROWS_AS(files.verdict({.solid = true}, 600), std::invalid_argument);
  CHECK_THROWS_AS(files.verdict({.distance = -1}, 600), std::invalid_argument);
  OutOfCore options = files.in_chunks(600);
  options.proceed = [](const FileStatus& status) { return status.progress < 0.3; };
  CHECK_THROWS_AS(file_distance(files.folder.path("in.ply"), files.folder.path("out.ply"), options),
                  internal::JobCancelled);
  CHECK_FALSE(std::filesystem::exists(files.folder.path("scratch")));
  files.folder.file("out.ply", "ply\nend_header\n");
  CHECK_THROWS_AS(files.distance(600), std::runtime_error);
  CHECK_FALSE(std::filesystem::exists(files.folder.path("scratch")));
  std::filesystem::create_directories(files.folder.path("scratch/quadrille-job/phase-1"));
  files.folder.file("scratch/quadrille-job/own.txt", "");
  CHECK_THROWS_AS(files.distance(600), std::runtime_error);
  CHECK(std::filesystem::exists(files.folder.path("scratch/quadrille-job/own.txt")));
}
