// When visitors are called, that their own state is kept, and what cancelling leaves.
#include "meshes.h"
#include "snapshot.h"

#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

// It is no Visitor, and changes.
struct Recorder {
  std::vector<Status> seen;
  std::size_t most_calls = ~std::size_t{0};
  bool proceed(const Status& status) {
    seen.push_back(status);
    return seen.size() < most_calls;
  }
};

struct NotCopied : Recorder {
  NotCopied() = default;
  NotCopied(const NotCopied&) = delete;
};

struct ConstantAndNotCopied {
  mutable std::size_t calls = 0;
  ConstantAndNotCopied() = default;
  ConstantAndNotCopied(const ConstantAndNotCopied&) = delete;
  bool proceed(const Status&) const { return ++calls > 0; }
};

struct Counter {
  std::size_t* calls;
  bool proceed(const Status&) { return ++*calls > 0; }
};

const Soup& input() {
  static const Soup soup = with_noise(torus(160, 80), 1, 0.01);
  return soup;
}

void check_calls(const std::vector<Status>& seen, const Report& report) {
  REQUIRE(seen.size() > 6);
  CHECK(seen.front().contractions == 0);
  CHECK(seen.front().progress == 0);
  CHECK(seen.front().faces == report.faces_before);
  CHECK(seen[2].contractions == 0); // it is called while the surface is prepared
  CHECK(seen[2].progress == 0);
  CHECK(seen[2].stage == Stage::prepare);
  const auto begun = std::find_if(seen.begin(), seen.end(), [](const Status& status) {
    return status.stage == Stage::contract;
  });
  CHECK(begun->contractions == 0); // told before the first contraction
  CHECK(seen.back().progress == 1);
  CHECK(seen.back().faces == report.faces_after);
  CHECK(seen.back().contractions == report.contractions);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    CHECK(seen[i].progress >= seen[i - 1].progress);
    CHECK(seen[i].stage >= seen[i - 1].stage);
    CHECK((seen[i].stage == Stage::write) == (i + 1 == seen.size()));
    CHECK((seen[i].progress < 1 || i + 1 == seen.size()));
  }
  const Status& middle = seen[seen.size() / 2];
  const auto gone = static_cast<double>(report.faces_before - middle.faces);
  const auto all = static_cast<double>(report.faces_before - report.faces_after);
  CHECK(middle.progress == Approx(gone / all).margin(0.01));
}

} // namespace

TEST_CASE("A visitor is called at the beginning, while preparing, in between and at the end") {
  Recorder greedy, relaxed, soup;
  Mesh mesh = make_mesh(input());
  Report report = simplify(mesh, FaceRatio{0.1}, CGAL::parameters::visitor(std::ref(greedy)));
  check_calls(greedy.seen, report);
  mesh = make_mesh(input());
  report =
      simplify(mesh, FaceRatio{0.1}, RelaxedOrder{}, CGAL::parameters::visitor(std::ref(relaxed)));
  check_calls(relaxed.seen, report);
  PointSoup points(input());
  report = simplify(points.points, points.triangles, FaceRatio{0.1},
                    CGAL::parameters::visitor(std::ref(soup)));
  check_calls(soup.seen, report);
}

TEST_CASE("A visitor may be a temporary, change, and be no copy") {
  std::size_t calls = 0;
  Mesh mesh = make_mesh(input());
  simplify(mesh, FaceRatio{0.5}, CGAL::parameters::visitor(Counter{&calls}));
  CHECK(calls > 10);

  NotCopied not_copied;
  simplify(mesh, FaceRatio{0.5}, CGAL::parameters::visitor(std::ref(not_copied)));
  CHECK(not_copied.seen.size() > 10);

  ConstantAndNotCopied constant;
  simplify(mesh, FaceRatio{0.5}, CGAL::parameters::visitor(constant));
  CHECK(constant.calls > 10);
}

TEST_CASE("Cancelling before the first contraction leaves the surface as it was") {
  // With what would be dropped on reading.
  Soup soup = input();
  soup.triangles.push_back(soup.triangles[0]);
  soup.points.push_back({{7, 7, 7}});
  const auto check = [&](const auto& order) {
    for (std::size_t at = 1; at < 8; ++at) {
      CAPTURE(at);
      Recorder visitor{{}, at};
      PointSoup points(soup);
      const PointSoup before = points;
      const Report report = simplify(points.points, points.triangles, FaceRatio{0.1}, order,
                                     CGAL::parameters::visitor(std::ref(visitor)));
      CHECK(visitor.seen.size() == at);
      CHECK(report.stop == StopReason::cancelled);
      const bool is_untouched =
          points.points == before.points && points.triangles == before.triangles;
      CHECK(is_untouched == (visitor.seen.back().contractions == 0));
      CHECK(report.faces_after == points.triangles.size());
      CHECK(report.vertices_after == points.points.size());
    }
  };
  check(GreedyOrder{});
  check(RelaxedOrder{});

  Recorder visitor{{}, 3};
  Mesh mesh = make_mesh(input());
  const Snapshot before = snapshot(mesh);
  CHECK(simplify(mesh, CGAL::parameters::visitor(std::ref(visitor))).stop == StopReason::cancelled);
  CHECK((snapshot(mesh) == before));
}
