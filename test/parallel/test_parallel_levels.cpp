// The number of threads does not show in what a recorder is told.
#include "meshes.h"
#include "replay.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/levels.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <tuple>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

struct RejectionLog : Log {
  std::vector<std::tuple<RecordedIndex, RecordedIndex, Rejection, double>> rejections;
  void reject(const RecordedRejection& rejection) {
    rejections.emplace_back(rejection.first, rejection.second, rejection.cause, rejection.error);
  }
};

} // namespace

TEST_CASE("any number of threads tells the same contractions and rejections in the same order") {
  std::size_t rejections = 0;
  for (const Soup& soup :
       {shuffled(with_noise(sphere(5), 3, 0.002), 11), with_holes(grid(120, 90), 7, 9)})
    for (const Topology topology : {Topology::kept, Topology::free}) {
      RejectionLog of_one;
      for (const unsigned threads : {1U, 2U, 4U}) {
        CAPTURE(threads);
        RejectionLog log;
        PointSoup points(soup);
        simplify<MemorylessQuadric, OptimalPlacement>(
            points.points, points.triangles, FaceRatio{0.02}, topology,
            RelaxedOrder{.threads = threads}, record_into(log));
        CHECK(log.contractions.size() > soup.points.size() / 2);
        if (threads == 1)
          of_one = log;
        CHECK((log == of_one));
        CHECK(log.rejections == of_one.rejections);
      }
      rejections += of_one.rejections.size();
      Replay replay(of_one);
      bool is_right = true;
      while (replay.steps() < of_one.contractions.size() / 20) // a naive replay takes long
        is_right = replay.step() && is_right;
      CHECK(is_right);
    }
  CHECK(rejections > 50);
}

TEST_CASE("any number of threads gives the same levels with a texture") {
  const Textured surface = textured_torus(100, 60);
  std::vector<Level> of_one;
  for (const unsigned threads : {1U, 2U, 4U}) {
    CAPTURE(threads);
    PointSoup soup(surface.soup);
    auto [values, triples] = indexed(surface.texture);
    Levels levels;
    simplify(soup.points, soup.triangles, FaceRatio{0.05}, Texture{values, triples},
             RelaxedOrder{.threads = threads}, record_into(levels));
    for (std::size_t i = 0; i < 8; ++i) {
      const Level level = levels.at(FaceCount{surface.soup.triangles.size() >> i});
      if (threads == 1)
        of_one.push_back(level);
      CHECK(level.points == of_one[i].points);
      CHECK(level.triangles == of_one[i].triangles);
      CHECK(level.channels[0].values == of_one[i].channels[0].values);
      CHECK(level.channels[0].triangles == of_one[i].channels[0].triangles);
    }
  }
}
