// The number of threads does not show in the charts of a texture.
#include "charts.h"
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <vector>

using namespace quadrille;

TEST_CASE("Any number of threads gives the same surface and texture, bit for bit") {
  for (const test::Textured& input :
       {test::textured_torus(100, 60), test::earth(120, 50), test::sphere_of_20_charts(4)})
    for (const bool refresh : {false, true}) {
      std::vector<std::vector<double>> of_one;
      for (const unsigned threads : {1U, 2U, 5U}) {
        CAPTURE(refresh, threads);
        test::PointSoup soup(input.soup);
        auto [values, triples] = test::indexed(input.texture);
        simplify(soup.points, soup.triangles, FaceRatio{0.1},
                 Texture{values, triples, {.seams = Seams::kept}},
                 RelaxedOrder{.refresh = refresh, .threads = threads});
        const test::Textured result{test::to_soup(soup), test::at_corners(values, triples),
                                    std::vector<int>(soup.triangles.size(), 0)};
        CHECK(result.labels.size() < input.labels.size() / 5);
        const bool is_same_pattern = test::pattern_of(result) == test::pattern_of(input);
        CHECK(is_same_pattern);
        if (of_one.empty())
          of_one = test::described(result);
        CHECK((test::described(result) == of_one));
      }
    }
}
