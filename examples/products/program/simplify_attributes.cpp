#include "carrying_cost.h"
#include "simplify_mesh.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/compiled/run_soup.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/quadric.h>
#include <quadrille/record.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace quadrille_examples {

namespace {

/// Attributes on their way through `simplify`.
class AttributeRun {
public:
  AttributeRun(const MeshAttributes& attributes, IndexedMesh& mesh,
               const quadrille::SoupOptions& options, std::vector<std::size_t>& image)
      : attributes_(attributes), mesh_(mesh), options_(options), image_(image) {}

  /// With a cost that looks at positions only, along which attributes are carried.
  template <class Cost>
  quadrille::Report carry(const Cost& cost) {
    return simplify<6>(CarryingCost<Cost, 6>(quadrille::internal::with_weights(cost, options_)));
  }

  /// As further dimensions, as many as vary: rounded up, since each number takes an engine.
  quadrille::Report simplify() {
    if (attributes_.size() <= 2)
      return simplify_dimensions<2>();
    if (attributes_.size() == 3)
      return simplify_dimensions<3>();
    return simplify_dimensions<6>();
  }

private:
  /// They are lengths already.
  template <std::size_t N>
  quadrille::Report simplify_dimensions() {
    auto cost = quadrille::internal::with_weights(quadrille::AttributeQuadric<N>{}, options_);
    cost.weights.emplace().coordinates.fill(1);
    return simplify<N>(cost);
  }

  /// The engine places the attributes together with the positions.
  template <std::size_t N, class Cost>
  quadrille::Report simplify(const Cost& cost) {
    namespace internal = quadrille::internal;
    std::vector<CarriedAttributes<N>> carried = attributes_.carried<N>();
    image_.assign(mesh_.points.size(), quadrille::parameters::vanished);
    std::optional<quadrille::SoupRecorder> recorder = options_.recorder;
    const quadrille::Report report = quadrille::simplify(
        mesh_.points, mesh_.triangles, cost, internal::placement_of<Cost>(options_),
        internal::pairs_of(options_), internal::stop_of(options_), options_.topology,
        internal::normal_deviation_of(options_), internal::no_self_intersection_of(options_),
        internal::keep_solid_of(options_), internal::record_into_given(recorder),
        quadrille::parameters::vertex_to_vertex_map(internal::PointImages{&image_})
            .vertex_tolerance_map(internal::values_if_given(options_.tolerance))
            .vertex_attribute_map(CGAL::make_property_map(carried))
            .vertex_is_constrained_map(internal::values_if_given(options_.fixed))
            .visitor(internal::policy_of<internal::SoupVisitor>(options_.proceed)));
    attributes_.restore(mesh_, carried);
    return report;
  }

  const MeshAttributes& attributes_;
  IndexedMesh& mesh_;
  const quadrille::SoupOptions& options_;
  std::vector<std::size_t>& image_;
};

} // namespace

quadrille::Report simplify_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                      const Options& options, const quadrille::SoupOptions& soup,
                                      std::vector<std::size_t>* image) {
  std::vector<std::size_t> unasked;
  AttributeRun run(attributes, mesh, soup, image ? *image : unasked);
  if (options.cost == "length")
    return run.carry(quadrille::EdgeLength{});
  if (options.cost == "memoryless")
    return run.carry(quadrille::MemorylessQuadric{});
  if (options.cost == "thin-features")
    return run.carry(quadrille::ThinFeatureQuadric{});
  if (options.cost == "quadric")
    return run.carry(quadrille::Quadric{});
  return run.simplify();
}

} // namespace quadrille_examples
