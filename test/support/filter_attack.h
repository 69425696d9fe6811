#ifndef TEST_SUPPORT_FILTER_ATTACK_H
#define TEST_SUPPORT_FILTER_ATTACK_H

#include "properties.h"
#include "random_surfaces.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/filters.h>
#include <quadrille/levels.h>
#include <quadrille/simplify.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// A cost, a placement and an order.
template <class CostType, class PlacementType, class OrderType>
struct Way {
  using Cost = CostType;
  using Placement = PlacementType;
  using Order = OrderType;
};

/// Simplifies a surface with each filter, and with limits of the distance, each in one of some
/// ways, and looks at levels of the record: is no face worse than its filter says, or than the face
/// of the input that it has been, and is no level further away than it tells?
template <class... Ways>
class FilterAttack {
public:
  FilterAttack(std::uint64_t seed, const Surface& surface)
      : seed_(seed), random_(seed + 9), surface_(surface), diagonal_(diagonal(surface.soup)),
        edge_(diagonal_ / std::sqrt(double(surface.soup.triangles.size()))) {}

  /// What is broken, in a line each.
  std::vector<std::string> broken() {
    const double degrees = random_(3, 40), length = edge_ * std::pow(10, random_(-0.5, 1)),
                 limit = diagonal_ * std::pow(10, random_(-3.5, -1));
    const std::size_t degree = 6 + random_.below(6);
    run(quadrille::SmallestAngle(degrees), {.smallest_angle = degrees});
    run(quadrille::LongestEdge(length), {.longest_edge = length});
    run(quadrille::HighestDegree(degree), {.degree = degree});
    run(quadrille::DistanceLimit(limit), {.distance = limit});
    run(quadrille::HausdorffLimit(limit), {.distance_both_ways = limit});
    return broken_;
  }

private:
  template <class Policy>
  void run(const Policy& policy, Asked asked) {
    asked.soup = surface_.soup;
    quadrille::Levels levels;
    constexpr std::array topologies{quadrille::Topology::kept, quadrille::Topology::kept,
                                    quadrille::Topology::free,
                                    quadrille::Topology::components_may_vanish};
    const quadrille::Topology topology = topologies[random_.below(4)];
    const std::size_t way = random_.below(sizeof...(Ways));
    std::size_t next = 0;
    (void)((next++ == way && (record<Ways>(levels, policy, topology), true)) || ...);
    const std::size_t count = levels.coarsest().contractions;
    for (std::size_t i = 1; i <= 5; ++i) {
      const quadrille::Level level =
          levels.at(quadrille::AfterContractions{count - count * (i * i - 1) / 25});
      if (level.faces == 0)
        continue; // it is at no distance
      const std::string complaint =
          test::broken(asked, result_of(levels, level), properties_of_levels());
      if (!complaint.empty())
        tell(complaint, level);
    }
  }

  template <class Way, class Policy>
  void record(quadrille::Levels& levels, const Policy& policy, quadrille::Topology topology) {
    using Cost = typename Way::Cost;
    using Placement = typename Way::Placement;
    std::vector<std::array<double, 3>> points;
    for (const Position& p : surface_.soup.points)
      points.push_back(p.coordinates);
    std::vector<Triangle> triangles = surface_.soup.triangles;
    const typename Way::Order order;
    if constexpr (quadrille::StopPolicy<Policy>)
      quadrille::simplify<Cost, Placement>(points, triangles, policy, topology, order,
                                           record_into(levels));
    else
      quadrille::simplify<Cost, Placement>(points, triangles,
                                           quadrille::FaceRatio{random_(0.01, 0.4)}, policy,
                                           topology, order, record_into(levels));
  }

  static Result result_of(const quadrille::Levels& levels, const quadrille::Level& level) {
    Result result;
    for (const auto& p : level.points)
      result.soup.points.push_back({p});
    result.soup.triangles = level.triangles;
    result.report.distance_bound = level.distance_bound;
    result.report.hausdorff_bound = level.hausdorff_bound;
    result.images = levels.vertex_map(level);
    result.input_faces = level.input_faces;
    return result;
  }

  void tell(const std::string& complaint, const quadrille::Level& level) {
    broken_.push_back("seed " + std::to_string(seed_) + ", " + surface_.name + ", " + complaint +
                      ", at " + std::to_string(level.faces) + " of " +
                      std::to_string(surface_.soup.triangles.size()) + " faces");
  }

  std::uint64_t seed_;
  Random random_;
  const Surface& surface_;
  double diagonal_, edge_;
  std::vector<std::string> broken_;
};

} // namespace test

#endif // TEST_SUPPORT_FILTER_ATTACK_H
