// SPDX-License-Identifier: MIT
//
// Quadrille's modes.

#include "contender.h"

#include <quadrille/cluster.h>
#include <quadrille/simplify.h>

namespace bench {
namespace {

template <class Cost, class Order>
auto simplify_in(const Order& order) {
  return [order](Mesh& mesh, std::size_t faces) {
    const Stopwatch stopwatch;
    const auto report = quadrille::simplify<Cost, quadrille::OptimalPlacement>(
        mesh, quadrille::FaceCount{faces}, order);
    const auto& seconds = report.seconds; // of wall clock time
    const double own_part = (seconds.prepare + seconds.contract) / seconds.total();
    return Answer{.own_seconds = own_part * stopwatch.seconds(), .soup = {}};
  };
}

auto cluster_with(quadrille::ClusterPlacement placement) {
  return [placement](Mesh& mesh, std::size_t faces) {
    Soup soup = to_soup(mesh);
    const Stopwatch stopwatch;
    cluster_vertices(soup.points, soup.triangles, quadrille::FaceCount{faces}, placement);
    const double seconds = stopwatch.seconds();
    to_mesh(soup, mesh);
    return Answer{.own_seconds = seconds, .soup = std::move(soup)};
  };
}

} // namespace

std::vector<Contender> our_contenders() {
  using namespace quadrille;
  return {{"Quadrille", "Quadric, OptimalPlacement, GreedyOrder, Surface_mesh",
           simplify_in<Quadric>(GreedyOrder{})},
          {"Quadrille memoryless", "MemorylessQuadric, OptimalPlacement, GreedyOrder, Surface_mesh",
           simplify_in<MemorylessQuadric>(GreedyOrder{})},
          {"Quadrille memoryless eager",
           "MemorylessQuadric, OptimalPlacement, GreedyOrder{.eager = true}, Surface_mesh",
           simplify_in<MemorylessQuadric>(GreedyOrder{.eager = true})},
          {"Quadrille thin features",
           "ThinFeatureQuadric, OptimalPlacement, GreedyOrder, Surface_mesh",
           simplify_in<ThinFeatureQuadric>(GreedyOrder{})},
          {"Quadrille relaxed", "Quadric, OptimalPlacement, RelaxedOrder{}, Surface_mesh",
           simplify_in<Quadric>(RelaxedOrder{})},
          {"Quadrille relaxed refreshed",
           "Quadric, OptimalPlacement, RelaxedOrder{.share = 0.2, .refresh = true}, Surface_mesh",
           simplify_in<Quadric>(RelaxedOrder{.share = 0.2, .refresh = true})},
          {"Quadrille clustering", "cluster_vertices, mean; double points",
           cluster_with(ClusterPlacement::mean)},
          {"Quadrille clustering quadrics", "cluster_vertices, quadric; double points",
           cluster_with(ClusterPlacement::quadric)}};
}

} // namespace bench
