#ifndef QUADRILLE_SIMPLIFY_H
#define QUADRILLE_SIMPLIFY_H

#include <quadrille/concepts.h>
#include <quadrille/filters.h>
#include <quadrille/internal/face_graph_adapter.h>
#include <quadrille/internal/greedy_order.h>
#include <quadrille/internal/pair_contraction.h>
#include <quadrille/pairs.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>
#include <quadrille/visitor.h>

#include <chrono>

namespace quadrille {

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class Stop>
Report simplify(Mesh& mesh, Stop stop) {
  using Clock = std::chrono::steady_clock;
  auto t0 = Clock::now();
  auto lap = [&] {
    auto t = Clock::now();
    double s = std::chrono::duration<double>(t - t0).count();
    t0 = t;
    return s;
  };
  auto vpm = get(CGAL::vertex_point, mesh);
  auto vim = CGAL::get_initialized_vertex_index_map(mesh);
  internal::FaceGraphAdapter<Mesh, decltype(vpm), decltype(vim)> adapter(mesh, vpm, vim);
  using P = internal::Policies<Cost, Placement, EdgePairs, Stop, Visitor, NormalFlip>;
  P policies{{}, {}, {}, stop, {}, Topology::kept, std::tuple<NormalFlip>(NormalFlip{})};
  Report report;
  auto input = adapter.template read<Cost::dimension>();
  report.seconds.read = lap();
  internal::PairContraction<P> surface(std::move(input), policies);
  internal::GreedyOrder<P> order(surface, report);
  report.seconds.prepare = lap();
  order.run();
  report.seconds.contract = lap();
  adapter.write(surface);
  report.seconds.write = lap();
  report.faces_before = surface.status().initial_faces;
  report.faces_after = surface.status().faces;
  report.vertices_before = surface.status().initial_vertices;
  report.vertices_after = surface.status().vertices;
  report.contractions = surface.status().contractions;
  return report;
}

} // namespace quadrille

#endif // QUADRILLE_SIMPLIFY_H
