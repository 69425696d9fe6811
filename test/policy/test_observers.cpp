// What a recorder is told beside contractions: each rejection with its cause, and why that has
// ended.
#include "meshes.h"
#include "replay.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/hull.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

struct Observer : Log {
  std::vector<RecordedRejection> rejections;
  std::vector<std::size_t> contractions_before; // each rejection
  std::optional<StopReason> stopped;
  bool has_ended = false, stopped_before_end = false;

  void reject(const RecordedRejection& rejection) {
    rejections.push_back(rejection);
    contractions_before.push_back(contractions.size());
  }
  void stop(StopReason reason) {
    stopped = reason;
    stopped_before_end = !has_ended;
  }
  void end() { has_ended = true; }

  std::array<std::size_t, rejection_causes> counts() const {
    std::array<std::size_t, rejection_causes> counts{};
    for (const RecordedRejection& rejection : rejections)
      ++counts[static_cast<std::size_t>(rejection.cause)];
    return counts;
  }
};

bool is_edge(const Replay& replay, std::uint32_t v, std::uint32_t w) {
  const auto has = [](const Triangle& t, std::uint32_t i) {
    return std::find(t.begin(), t.end(), i) != t.end();
  };
  return std::any_of(replay.faces().begin(), replay.faces().end(),
                     [&](const auto& face) { return has(face.second, v) && has(face.second, w); });
}

const Soup& input() {
  static const Soup soup = with_noise(torus(30, 20), 1, 0.02);
  return soup;
}

template <class... Arguments>
std::pair<Observer, Report> observed(const Soup& soup, const Arguments&... arguments) {
  Observer observer;
  PointSoup points(soup);
  const Report report =
      simplify(points.points, points.triangles, arguments..., record_into(observer));
  CHECK(observer.counts() == report.rejections);
  CHECK(observer.stopped == report.stop);
  CHECK(observer.stopped_before_end);
  CHECK(observer.contractions.size() == report.contractions + report.vanished_components);
  return {observer, report};
}

} // namespace

TEST_CASE("Each rejection is told with its cause and its ends, in greedy order when it happens") {
  const auto [observer, report] = observed(input(), FaceCount{24}, NormalFlip{40});
  CHECK(report.rejected(Rejection::topology) > 0);
  CHECK(report.rejected(Rejection::normal_flip) > 0);
  Replay replay(observer);
  bool are_edges = true, are_errors = true, is_right = true;
  for (std::size_t i = 0; i < observer.rejections.size(); ++i) {
    while (replay.steps() < observer.contractions_before[i])
      is_right = replay.step() && is_right;
    const RecordedRejection& rejection = observer.rejections[i];
    are_edges = are_edges && rejection.first != rejection.second &&
                is_edge(replay, rejection.first, rejection.second);
    are_errors = are_errors && rejection.error >= 0 && rejection.error < 10 * report.error;
  }
  CHECK(is_right);
  CHECK(are_edges);
  CHECK(are_errors);
  CHECK(observer.contractions_before.back() > observer.contractions_before.front());
}

TEST_CASE("Rejections of passes are told by input indices, behind each stage") {
  const Soup soup = with_noise(torus(160, 80), 1, 0.01);
  const auto [observer, report] =
      observed(soup, FaceRatio{0.02}, NormalFlip{40}, RelaxedOrder{.refresh = true});
  CHECK(observer.rejections.size() > 100);
  double longest = 0;
  for (const RecordedRejection& rejection : observer.rejections) {
    REQUIRE(rejection.first < soup.points.size());
    REQUIRE(rejection.second < soup.points.size());
    CHECK(rejection.first != rejection.second);
    longest = (std::max)(
        longest, squared_distance(soup.points[rejection.first], soup.points[rejection.second]));
  }
  CHECK(std::sqrt(longest) < 0.6); // no numbers of packed vertices, which are anywhere
}

TEST_CASE("A placement that finds no place is told of, in any order") {
  const auto check = [](const auto& order) {
    Observer observer;
    PointSoup points(input());
    const Report report = simplify<MemorylessQuadric>(points.points, points.triangles, OuterHull{},
                                                      FaceCount{0}, order, record_into(observer));
    CHECK(report.rejected(Rejection::hull) > 0);
    CHECK(observer.counts() == report.rejections);
  };
  check(GreedyOrder{});
  check(RelaxedOrder{});
}

TEST_CASE("A part that may not vanish is told without ends") {
  const Soup small = mapped(sphere(1), [](const Position& p) { return 0.05 * p; });
  const Soup soup = joined(sphere(3), small, {{5, 0, 0}});
  const auto [observer, report] =
      observed(soup, DistanceLimit{0.09}, Topology::components_may_vanish);
  const bool has_one = std::any_of(
      observer.rejections.begin(), observer.rejections.end(), [](const auto& rejection) {
        return rejection.first == not_recorded && rejection.second == not_recorded;
      });
  CHECK(has_one);
}

TEST_CASE("The reason to stop is told as the report has it") {
  CHECK(observed(input(), FaceCount{400}).first.stopped == StopReason::target_met);
  CHECK(observed(input(), FaceCount{401}).first.stopped == StopReason::target_passed);
  CHECK(observed(tetrahedron(), FaceCount{0}).first.stopped != StopReason::target_met);
}
