// SPDX-License-Identifier: MIT
//
// Quadrille's modes.

#include "contender.h"

#include <quadrille/cluster.h>
#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

namespace bench {
namespace {

using quadrille::FaceCount;
using quadrille::Quadric;
using quadrille::simplify; // CGAL has one too

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

/// By what vertices remember beside planes; `noise` is of places, in mean edge lengths.
auto simplify_by(Quadric cost, double noise = 0) {
  return [=](Mesh& mesh, std::size_t faces) mutable {
    cost.position_noise = noise > 0 ? noise * mean_edge_length(mesh) : 0;
    simplify(mesh, cost, FaceCount{faces});
    return Answer{};
  };
}

/// With what promises something more.
template <class Cost>
auto simplify_with(const auto& promise) {
  return [promise](Mesh& mesh, std::size_t faces) {
    simplify<Cost, quadrille::OptimalPlacement>(mesh, FaceCount{faces}, promise);
    return Answer{};
  };
}

/// With a limit that is never reached, so that what it costs to know the distance is measured.
template <class Limit>
Answer simplify_knowing(Mesh& mesh, std::size_t faces) {
  simplify<Quadric, quadrille::OptimalPlacement>(
      mesh, quadrille::AnyOf{FaceCount{faces}, Limit::relative(1)});
  return {};
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
          {"Quadrille thin features",
           "ThinFeatureQuadric, OptimalPlacement, GreedyOrder, Surface_mesh",
           simplify_in<ThinFeatureQuadric>(GreedyOrder{})},
          {"Quadrille relaxed", "Quadric, OptimalPlacement, RelaxedOrder{}, Surface_mesh",
           simplify_in<Quadric>(RelaxedOrder{})},
          {"Quadrille relaxed refreshed",
           "Quadric, OptimalPlacement, RelaxedOrder{.share = 0.2, .refresh = true}, Surface_mesh",
           simplify_in<Quadric>(RelaxedOrder{.share = 0.2, .refresh = true})},
          {"Quadrille lines 0.001", "Quadric{.line_weight = 0.001}, Surface_mesh",
           simplify_by(Quadric{.line_weight = 0.001})},
          {"Quadrille lines 0.01", "Quadric{.line_weight = 0.01}, Surface_mesh",
           simplify_by(Quadric{.line_weight = 0.01})},
          {"Quadrille noise of normals", "Quadric{.normal_noise = 0.05}, Surface_mesh",
           simplify_by(Quadric{.normal_noise = 0.05})},
          {"Quadrille noise of places",
           "Quadric{.position_noise = 0.1 of the mean edge length}, Surface_mesh",
           simplify_by(Quadric{}, 0.1)},
          {"Quadrille triangle quadrics",
           "Quadric{.weighting = Weighting::by_squared_area}, Surface_mesh",
           simplify_by(Quadric{.weighting = Weighting::by_squared_area})},
          {"Quadrille error limit", "Quadric, DistanceLimit beside the count, Surface_mesh",
           simplify_knowing<DistanceLimit>},
          {"Quadrille both ways", "Quadric, HausdorffLimit beside the count, Surface_mesh",
           simplify_knowing<HausdorffLimit>},
          {"Quadrille normals", "Quadric, NormalDeviation{60}, Surface_mesh",
           simplify_with<Quadric>(NormalDeviation{60})},
          {"Quadrille apart", "Quadric, NoSelfIntersection, Surface_mesh",
           simplify_with<Quadric>(NoSelfIntersection{})},
          {"Quadrille memoryless apart", "MemorylessQuadric, NoSelfIntersection, Surface_mesh",
           simplify_with<MemorylessQuadric>(NoSelfIntersection{})},
          {"Quadrille clustering", "cluster_vertices, mean; double points",
           cluster_with(ClusterPlacement::mean)},
          {"Quadrille clustering quadrics", "cluster_vertices, quadric; double points",
           cluster_with(ClusterPlacement::quadric)}};
}

} // namespace bench
