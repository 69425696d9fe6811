// The algorithm of 1997 from nothing, examples/garland_heckbert_1997.cpp, beside the engine.
#include "meshes.h"
#include "soups.h"

#include <quadrille/compiled.h>
#include <quadrille/distance.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <utility>
#include <valarray>
#include <vector>

// All that it includes is above.
#define main run_as_program
namespace from_nothing {
#include "../../examples/garland_heckbert_1997.cpp"
} // namespace from_nothing
#undef main

using namespace quadrille;
using namespace test;

namespace {

Soup by_the_paper(const Soup& soup, std::size_t faces, double t) {
  std::vector<from_nothing::Vector> points;
  for (const Position& p : soup.points)
    points.push_back({p[0], p[1], p[2]});
  std::vector<from_nothing::Triangle> triangles;
  for (const Triangle& corners : soup.triangles)
    triangles.push_back({corners[0], corners[1], corners[2]});
  from_nothing::Simplification simplification(points, triangles, t);
  Soup result = soup;
  result.triangles.clear();
  for (const auto& [a, b, c] : simplification.run(faces))
    result.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                static_cast<std::uint32_t>(c)});
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      result.points[v][i] = simplification.vertices[v].point[i];
  return without_isolated_points(result);
}

Soup by_the_engine(const Soup& soup, std::size_t faces, double t) {
  std::vector<std::array<double, 3>> points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  SoupOptions options;
  options.faces = faces;
  options.pairs_closer_than = t;
  options.topology = Topology::free;
  options.weighting = Weighting::uniform;
  const SoupResult result = simplified_soup({points, soup.triangles, {}, {}}, options);
  Soup made{{}, result.triangles};
  for (const auto& p : result.points)
    made.points.push_back({p});
  return made;
}

std::size_t non_manifold_edges(const Soup& soup) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++faces[std::minmax(t[i], t[(i + 1) % 3])];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second > 2; }));
}

double rms(const Soup& a, const Soup& b) {
  return surface_distance(a.points, a.triangles, b.points, b.triangles, {.samples = 4000}).rms;
}

struct Near {
  Soup ours, engines;
  double our_rms, engines_rms;

  Near(const Soup& soup, std::size_t faces, double t)
      : ours(by_the_paper(soup, faces, t)), engines(by_the_engine(soup, faces, t)),
        our_rms(rms(soup, ours)), engines_rms(rms(soup, engines)) {
    INFO(ours.triangles.size() << " and " << engines.triangles.size() << " faces, "
                               << our_rms / diagonal(soup) << " and "
                               << engines_rms / diagonal(soup));
    CHECK(ours.triangles.size() <= faces);
    CHECK(ours.triangles.size() + 3 >= engines.triangles.size());
    CHECK(our_rms < 1.1 * engines_rms);
    CHECK(engines_rms < 1.1 * our_rms);
    CHECK_FALSE(topology_of(ours).has_duplicate_faces);
  }
};

} // namespace

TEST_CASE("the foot to 249 faces, by pairs, as in the paper") {
  const Soup foot = to_soup(read_model("bones"));
  const Near near(foot, 249, 0.318);
  CHECK(topology_of(near.ours).components == 1); // of 26
  CHECK(non_manifold_edges(near.ours) > 50);     // 61 in the paper
  CHECK(non_manifold_edges(near.ours) < 70);
}

TEST_CASE("other models, by edges") {
  Near(to_soup(read_model("cow")), 500, 0);
  Near(to_soup(read_model("blobby")), 300, 0);
}

TEST_CASE("borders stay, and what is flat") {
  const Near sheet(with_noise(grid(20, 30), 5, 0.1), 200, 0);
  CHECK(topology_of(sheet.ours).boundary_loops == 1);
  const Soup flat = grid(12, 12);
  CHECK(rms(flat, by_the_paper(flat, 20, 0)) < 1e-6);
}

TEST_CASE("pairs closer than t join what has no edge in common") {
  const Soup two = joined(sphere(2), sphere(2), {{2.05, 0, 0}});
  CHECK(topology_of(by_the_paper(two, 150, 0)).components == 2);
  CHECK(topology_of(by_the_paper(two, 150, 0.3)).components == 1);
  CHECK(by_the_paper(two, 10000, 0.3).triangles == two.triangles);
}
