#ifndef QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H
#define QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H

/// \file
/// Simplifies a mesh as options say.

#include "../mesh_io/attributes/mesh_channels.h"
#include "../mesh_io/mesh/bounding_box.h"
#include "../mesh_io/mesh_io.h"
#include "options.h"
#include "pairs_of_faces.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

/// With all that the mesh has. `begun`, if there is one, becomes what begun_surface() is.
quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options,
                                const std::optional<quadrille::SoupRecorder>& recorder = {},
                                quadrille::PreparedSurface* begun = nullptr);

/// Points and triangles as a mesh.
IndexedMesh bare_mesh(const quadrille::SoupPoints& points,
                      const quadrille::SoupTriangles& triangles);

/// The surface with which a run of these options begins, once it is prepared.
IndexedMesh mesh_that_runs_begin_with(const quadrille::SoupPoints& points,
                                      const quadrille::SoupTriangles& triangles,
                                      quadrille::SoupOptions options);

/// The numbers of points that have this name; at seams the one that is ahead of the others. Throws
/// std::invalid_argument where there are none.
std::vector<double> point_numbers(const IndexedMesh& mesh, const std::string& name,
                                  bool (*is_ahead)(double, double));

/// The options but for what depends on the soup.
quadrille::SoupOptions soup_options(const Options& options);

/// Sets the options that are lengths, of which some are parts of the diagonal.
void set_lengths(const Options& options, double diagonal, quadrille::SoupOptions& result);

/// The options of a soup of these points.
quadrille::SoupOptions soup_options(const Options& options, const auto& points,
                                    const auto& triangles) {
  quadrille::SoupOptions result = soup_options(options);
  if (!options.lengths.empty())
    set_lengths(options, diagonal(points, triangles), result);
  if (options.locks_boundaries)
    result.fixed = boundary_points(points.size(), triangles);
  if (!options.target.is_given() && !options.drops_components &&
      topology(options) != quadrille::Topology::free)
    leave_pairs_of_faces(points.size(), triangles, result);
  return result;
}

/// How much channels count. All do by default; else only those that the cost is asked for by name.
ChannelChoices channel_choices(const Options& options);

/// A message of the library without names of C++.
std::string in_words_of_program(std::string message);

/// What is wrong with attributes that no weight makes comparable with positions is told of the
/// file.
quadrille::Report with_errors_of_file(const Options& options, const auto& simplify) {
  try {
    return simplify();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.input + ": " + in_words_of_program(error.what()));
  } catch (const std::length_error& error) {
    throw std::runtime_error(options.input + ": " + in_words_of_program(error.what()));
  }
}

} // namespace quadrille_examples

#endif
