// All that is told at run time makes no engine of its own, and is told as its type says.
#include "meshes.h"

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>
#include <vector>

using namespace quadrille;
using internal::NotGiven;
using internal::pick_policies;

namespace {

struct OwnStop {
  bool operator()(const Status& status) const { return status.faces <= 100; }
};
// What its type does not say is not compiled.
struct NeedsMoreThanItSays : OwnStop {
  static constexpr Needs needs = {.cost = true};
  Needs needs_now() const { return {.distance = true, .cost = true}; }
};
struct OwnPlacement {
  auto operator()(const auto&, const auto& pair) const { return pair.second; }
};
struct RejectsAll {
  static constexpr Rejection cause = Rejection::shape;
  int* calls;
  bool allows(const auto&) const { return ++*calls, false; }
};
struct Watcher : Visitor {};
struct Listener {
  int contractions = 0;
  void begin(RecordedSurface) {}
  void record(const RecordedContraction&) { ++contractions; }
  void end() {}
};

template <class A, class B>
bool are_alike(const A&, const B&) {
  return std::is_same_v<A, B>;
}

} // namespace

TEST_CASE("One engine is compiled for a cost and the placements that are built in") {
  int calls = 0;
  Listener listener;
  const auto plain = pick_policies<NotGiven, NotGiven>();
  CHECK(are_alike(plain, pick_policies<NotGiven, NotGiven>(OwnStop{}, EndpointPlacement{},
                                                           RelaxedOrder{}, RejectsAll{&calls},
                                                           Topology::free, record_into(listener),
                                                           CGAL::parameters::visitor(Watcher()))));
  CHECK(are_alike(plain,
                  pick_policies<Quadric, MidpointPlacement>(DistanceLimit(1), NormalFlip(60))));
  CHECK_FALSE(are_alike(plain, pick_policies<MemorylessQuadric, NotGiven>()));
  CHECK_FALSE(are_alike(plain, pick_policies<NotGiven, NotGiven>(OwnPlacement{})));
  std::vector<Vector<3>> colors;
  CHECK_FALSE(
      are_alike(plain, pick_policies<NotGiven, NotGiven>(Colors(CGAL::make_property_map(colors)))));
}

TEST_CASE("What a call cannot need is not compiled for it") {
  const auto plain = pick_policies<NotGiven, NotGiven>(FaceCount{10});
  CHECK(plain.optional.run_passes == nullptr);
  CHECK(plain.optional.make_recording == nullptr);
  CHECK(plain.optional.make_distances == nullptr);
  const auto more = pick_policies<NotGiven, NotGiven>(NeedsMoreThanItSays{});
  CHECK(more.optional.make_distances == nullptr);
  CHECK(more.stop.needs() == Needs{.cost = true});
  Listener listener;
  CHECK(pick_policies<NotGiven, NotGiven>(RelaxedOrder{}).optional.run_passes != nullptr);
  CHECK(pick_policies<NotGiven, NotGiven>(record_into(listener)).optional.make_recording !=
        nullptr);
  CHECK(pick_policies<NotGiven, NotGiven>(DistanceLimit(1)).optional.make_distances != nullptr);
}

TEST_CASE("A stop policy needs what those in it need, and what that implies") {
  const auto needs = [](const auto& stop) {
    return pick_policies<NotGiven, NotGiven>(stop).stop.needs();
  };
  const Needs one_way{.distance = true};
  const Needs both_ways{.distance = true, .reverse_distance = true};
  const Needs tolerance{.distance = true, .reverse_distance = true, .tolerance = true};
  CHECK(needs(OwnStop{}) == Needs{});
  CHECK(needs(DistanceLimit(1)) == one_way);
  CHECK(needs(HausdorffLimit(1)) == both_ways);
  CHECK(needs(ToleranceLimit{}) == tolerance);
  CHECK(needs(AnyOf{FaceCount{10}, AllOf{EdgeCount{10}, CostLimit(1)}}) ==
        Needs{.cost = true, .edges = true});
  CHECK(needs(AllOf{CostLimit(1), HausdorffLimit(1)}) ==
        Needs{.distance = true, .reverse_distance = true, .cost = true});
}

TEST_CASE("Filters are asked in their order after the first NormalFlip, and as which they refuse") {
  test::PointSoup soup(test::sphere(3));
  int first = 0, second = 0;
  const Report report = simplify(soup.points, soup.triangles, FaceCount{100}, RejectsAll{&first},
                                 RejectsAll{&second});
  CHECK(first > 0);
  CHECK(second == 0);
  CHECK(report.contractions == 0);
  CHECK(report.rejected(Rejection::shape) == static_cast<std::size_t>(first));

  soup = test::PointSoup(test::sphere(3));
  first = 0;
  simplify(soup.points, soup.triangles, FaceCount{100}, RejectsAll{&first}, NormalFlip(1e-6));
  CHECK(first == 0); // the other refuses all that moves a face
}
