#include "run_engine.h"
#include "simplify_mesh.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/record.h>

#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

/// As simplify_mesh without attributes, which records nothing.
quadrille::Report simplify_positions(IndexedMesh& mesh, const Options& options, const auto& into) {
  if (options.cost == "memoryless") { // LocalCost rounds differently
    std::vector<std::size_t> images(mesh.points.size());
    return simplify_in_order(
        quadrille::GreedyOrder{}, mesh, options,
        with_weights(quadrille::MemorylessQuadric{}, options), into,
        quadrille::parameters::vertex_image_map(CGAL::make_property_map(images)));
  }
  IndexedMesh bare;
  bare.points = std::move(mesh.points);
  bare.triangles = std::move(mesh.triangles);
  const quadrille::Report report = simplify_channels(bare, MeshChannels(bare), options, into);
  mesh.points = std::move(bare.points);
  mesh.triangles = std::move(bare.triangles);
  return report;
}

} // namespace

/// By fewer types of costs, since each of them is compiled once more for recordings.
quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options, Recorder& recorder) {
  const auto into = quadrille::record_into(recorder);
  if (goes_by_channels(mesh, options))
    return simplify_channels(mesh, MeshChannels(mesh), options, into);
  const MeshAttributes attributes(mesh, importance(options));
  if (attributes.size() == 0) {
    const quadrille::Report report = simplify_positions(mesh, options, into);
    attributes.restore(mesh);
    return report;
  }
  const auto carrying = [&](const auto& cost) {
    return simplify_carrying(attributes, mesh, options, cost, into);
  };
  if (options.cost.empty() || options.cost == "color" || options.cost == "texture")
    return simplify_dimensions(attributes, mesh, options, into);
  if (options.cost == "memoryless") // as above
    return carrying(with_weights(quadrille::MemorylessQuadric{}, options));
  return with_cost_of_positions(options, carrying);
}

} // namespace quadrille_examples
