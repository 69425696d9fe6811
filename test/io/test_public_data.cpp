// Real surfaces that are no manifolds or of many parts, from the folder that the environment
// variable QUADRILLE_DATA names, or from its folder `public`; without it the test is skipped.
#include "on_all.h"

#include "../examples/products/mesh_io/mesh_io.h"

#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>

using namespace quadrille;
using quadrille_examples::IndexedMesh;

namespace {

namespace fs = std::filesystem;

// `pairs` may be an EdgePairs or a ThresholdPairs.
void check(const IndexedMesh& input, double ratio, const auto& pairs) {
  IndexedMesh mesh = input;
  const Report report = simplify(mesh.points, mesh.triangles, FaceRatio{ratio}, pairs);
  INFO(report);
  test::Soup result{{}, mesh.triangles};
  for (const auto& p : mesh.points)
    result.points.push_back(test::to_position(p));
  CHECK(test::is_clean(result, true));
  CHECK(result.triangles.size() == report.faces_after);
  CHECK(std::isfinite(report.error));
  if (is_target_reached(report.stop))
    CHECK(static_cast<double>(report.faces_after) <=
          ratio * static_cast<double>(report.faces_before) + 1);
  else
    CHECK((report.stop == StopReason::all_pairs_rejected ||
           report.stop == StopReason::target_unreachable));
}

} // namespace

TEST_CASE("Surfaces that are no manifolds or of many parts go to 10 % and 1 %") {
  const char* data = std::getenv("QUADRILLE_DATA");
  fs::path models = data == nullptr ? "" : data;
  if (fs::exists(models / "public"))
    models /= "public";
  if (data == nullptr || !fs::exists(models / "nonmanifold")) {
    WARN("skipped: QUADRILLE_DATA names no folder with models"); // ctest looks for this
    return;
  }
  std::size_t files = 0;
  for (const char* folder : {"nonmanifold", "multi"})
    for (const auto& entry : fs::directory_iterator(models / folder)) {
      CAPTURE(entry.path());
      ++files;
      const IndexedMesh mesh = quadrille_examples::read_mesh(entry.path());
      for (const double ratio : {0.1, 0.01}) {
        CAPTURE(ratio);
        check(mesh, ratio, EdgePairs{});
        check(mesh, ratio, ThresholdPairs::relative(0.002));
      }
    }
  CHECK(files > 0);
}
