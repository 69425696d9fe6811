#ifndef QUADRILLE_EXAMPLES_PROGRAM_ATTRIBUTE_ENGINE_H
#define QUADRILLE_EXAMPLES_PROGRAM_ATTRIBUTE_ENGINE_H

/// \file
/// All that an engine of attributes as further dimensions is made of, for the sources that have one
/// each: an engine takes a gigabyte of memory to compile.

#include "../attribute_run.h"
#include "../carrying_cost.h"

#include <quadrille/compiled/run_soup.h>
#include <quadrille/parameters.h>
#include <quadrille/record.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace quadrille_examples {

/// The engine places the attributes together with the positions.
template <std::size_t N, class Cost>
quadrille::Report simplify(const AttributeRun& run, const Cost& cost) {
  namespace internal = quadrille::internal;
  const quadrille::SoupOptions& options = run.options;
  std::vector<CarriedAttributes<N>> carried = run.attributes.template carried<N>();
  run.image.assign(run.mesh.points.size(), quadrille::parameters::vanished);
  std::optional<quadrille::SoupRecorder> recorder = options.recorder;
  const quadrille::Report report = quadrille::simplify(
      run.mesh.points, run.mesh.triangles, cost, internal::placement_of<Cost>(options),
      internal::pairs_of(options), internal::stop_of(options), options.topology,
      internal::normal_deviation_of(options), internal::no_self_intersection_of(options),
      internal::keep_solid_of(options), internal::record_into_given(recorder),
      quadrille::parameters::vertex_to_vertex_map(internal::PointImages{&run.image})
          .vertex_tolerance_map(internal::values_if_given(options.tolerance))
          .vertex_attribute_map(CGAL::make_property_map(carried))
          .vertex_is_constrained_map(internal::values_if_given(options.fixed))
          .visitor(internal::policy_of<internal::SoupVisitor>(options.proceed)));
  run.attributes.restore(run.mesh, carried);
  return report;
}

/// With a cost that looks at positions only, along which attributes are carried.
template <class Cost>
quadrille::Report carry(const AttributeRun& run, const Cost& cost) {
  return simplify<6>(run,
                     CarryingCost<Cost, 6>(quadrille::internal::with_weights(cost, run.options)));
}

} // namespace quadrille_examples

#endif
