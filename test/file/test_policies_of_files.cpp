// What a guard, a placement or a filter promises, over 16 parts of a file. Those that do not hold
// by parts do not compile: see compile_fail/file_promises.cpp.

#include "folder.h"
#include "soups.h"
#include "surface_files.h"

#include <quadrille/file.h>
#include <quadrille/filters.h>
#include <quadrille/guard.h>
#include <quadrille/placement.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using namespace quadrille;
using test::Folder;
using test::ply_of;
using test::read_ply;
using test::Soup;

struct Run {
  Soup input, output;
  FileReport report;
};

template <class Placement, class... Policies>
Run run(const Soup& input, std::size_t faces, const Policies&... policies) {
  const Folder folder;
  folder.file("in.ply", ply_of(input));
  OutOfCore options;
  options.scratch = folder.path("scratch");
  options.chunk_faces = input.triangles.size() / 16;
  const FileReport report =
      simplify_file(folder.path("in.ply"), folder.path("out.ply"), FaceCount{faces}, options,
                    Quadric{}, Placement{}, policies...);
  CHECK(report.chunks >= 16);
  return {input, read_ply(folder.path("out.ply")), report};
}

Soup torus() {
  return test::as_floats(test::with_noise(test::torus(100, 40), 1, 0.004));
}

using Cell = std::array<double, 3>;

// No vertex leaves its cell of a grid: that holds over parts, since none is left in any phase.
struct SameCell {
  static constexpr bool works_in_passes = true;
  static constexpr bool works_in_chunks = true;
  static constexpr double size = 0.25;

  static Cell cell(const auto& p) {
    return {std::floor(p[0] / size), std::floor(p[1] / size), std::floor(p[2] / size)};
  }
  struct State {
    std::vector<Cell> cells;
    bool allows(const auto& contraction) const {
      const Cell& first = cells[contraction.first()];
      return first == cells[contraction.second()] && first == cell(contraction.target());
    }
    void follow(const auto&) {}
  };
  State begin(const GuardedSurface& surface) const {
    State state{std::vector<Cell>(surface.vertex_count)};
    for (const auto& [index, point] : surface.vertices)
      state.cells[index] = cell(point);
    return state;
  }
};

std::set<Cell> cells_of(const Soup& soup) {
  std::set<Cell> cells;
  for (const auto& p : soup.points)
    cells.insert(SameCell::cell(p));
  return cells;
}

} // namespace

TEST_CASE("A guard that works in parts holds over all of them") {
  const Run guarded = run<OptimalPlacement>(torus(), 100, SameCell{});
  CHECK(guarded.report.faces_after < guarded.input.triangles.size() / 2);
  CHECK(cells_of(guarded.output) == cells_of(guarded.input));
  const Run free = run<OptimalPlacement>(torus(), guarded.report.faces_after);
  CHECK(cells_of(free.output) != cells_of(free.input)); // without it some lose all vertices
}

TEST_CASE("Placements place the same over parts: at ends, and where the volume stays") {
  const Run ends = run<EndpointPlacement>(torus(), 800);
  std::set<std::array<double, 3>> places;
  for (const auto& p : ends.input.points)
    places.insert(p.coordinates);
  std::size_t elsewhere = 0;
  for (const auto& p : ends.output.points)
    elsewhere += !places.contains(p.coordinates);
  CHECK(elsewhere == 0);

  const Run kept = run<VolumeKeeping<OptimalPlacement>>(torus(), 800);
  const double volume = test::volume(kept.input);
  CHECK(std::abs(test::volume(kept.output) - volume) < 1e-5 * volume);
  const Run lost = run<MidpointPlacement>(torus(), 800);
  CHECK(std::abs(test::volume(lost.output) - volume) > 1e-3 * volume);
}

TEST_CASE("A filter is asked in every part") {
  Soup terrain = test::grid(80, 80);
  for (auto& p : terrain.points)
    p[2] = 0.05 * std::sin(40 * p[0]) * std::sin(40 * p[1]);
  const Run run = ::run<OptimalPlacement>(test::as_floats(terrain), 400, HeightField{{0, 0, 1}});
  std::size_t turned = 0;
  for (const test::Triangle& t : run.output.triangles)
    turned += !(test::area_vector(run.output, t)[2] > 0);
  CHECK(turned == 0);
}
