#ifndef QUADRILLE_EXAMPLES_FIGURES_EDGES_AND_PAIRS_H
#define QUADRILLE_EXAMPLES_FIGURES_EDGES_AND_PAIRS_H

#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

namespace figures {

/// A surface simplified by edges and by pairs, to the same number of faces.
struct EdgesAndPairs {
  struct Result {
    Soup soup;
    quadrille::Report report;
    quadrille::SurfaceDistance error;
  };
  std::string name;
  Soup original;
  Result by_edges, by_pairs;

  EdgesAndPairs(std::string named, Soup soup, const quadrille::Quadric& cost, std::size_t faces,
                double threshold)
      : name(std::move(named)), original(std::move(soup)),
        by_edges(simplified(cost, faces, quadrille::EdgePairs{})),
        by_pairs(simplified(cost, faces, quadrille::ThresholdPairs{threshold})) {}

  void print() const {
    std::printf(
        "                  faces   components  non-manifold edges  Hausdorff, %% of diagonal\n");
    print_row("edges", by_edges);
    print_row("pairs", by_pairs);
  }

  void write(const fs::path& folder) const {
    figures::write(original, folder, name);
    figures::write(by_edges.soup, folder, name + "_edges");
    figures::write(by_pairs.soup, folder, name + "_pairs");
  }

protected:
  /// Of another simplifier: what there is to count in it, and how far it is from the original.
  Result measured(Soup soup) const {
    using namespace quadrille;
    Result result{std::move(soup), {}, {}};
    Soup counted = result.soup;
    result.report = simplify(counted.points, counted.triangles, FaceCount{counted.triangles.size()},
                             Topology::free);
    result.report.components_before = by_edges.report.components_before;
    result.error = surface_distance(original.points, original.triangles, result.soup.points,
                                    result.soup.triangles);
    return result;
  }

  void print_row(const char* pairs, const Result& result) const {
    const quadrille::Report& report = result.report;
    std::printf("%-15s %7zu %6zu -> %-3zu %19zu %25.2f\n", pairs, report.faces_after,
                report.components_before, report.components_after, report.non_manifold_edges,
                100 * result.error.hausdorff / quadrille::bounding_box_diagonal(original.points));
  }

private:
  Result simplified(const quadrille::Quadric& cost, std::size_t faces, const auto& pairs) const {
    using namespace quadrille;
    Result result{original, {}, {}};
    auto& [points, triangles] = result.soup;
    const NormalFlip as_in_the_paper(90, FoldOvers::allowed);
    result.report =
        simplify(points, triangles, cost, FaceCount{faces}, pairs, Topology::free, as_in_the_paper);
    result.error = surface_distance(original.points, original.triangles, points, triangles);
    return result;
  }
};

} // namespace figures

#endif
