#ifndef QUADRILLE_EXAMPLES_PROGRAM_RECORD_H
#define QUADRILLE_EXAMPLES_PROGRAM_RECORD_H

/// \file
/// Files of levels: --record writes all levels of a run, --from reads one of them.

#include "../mesh_io.h"
#include "options.h"
#include "report.h"
#include "simplify_mesh.h"

#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/record.h>
#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace quadrille_examples {

/// A recorder that tells levels of the positions only, whatever attributes vertices and corners
/// have.
class PositionRecorder {
public:
  explicit PositionRecorder(quadrille::Levels& levels) : levels_(levels) {}

  void begin(quadrille::RecordedSurface surface) {
    std::size_t end = 0;
    for (std::size_t v = 0; v < surface.values.size(); v += surface.width)
      for (std::size_t k = 0; k < dimension; ++k)
        surface.values[end++] = surface.values[v + k];
    surface.values.resize(end);
    surface.dimension = surface.width = dimension;
    surface.channels.clear();
    levels_.begin(std::move(surface));
  }
  void record(const quadrille::RecordedContraction& contraction) {
    quadrille::RecordedContraction of_positions = contraction;
    of_positions.values = contraction.values.first(std::min(dimension, contraction.values.size()));
    of_positions.wedges = {};
    levels_.record(of_positions);
  }
  void end() { levels_.end(); }

private:
  static constexpr std::size_t dimension = 3;
  quadrille::Levels& levels_;
};

/// May the record be written, and beside the result? Throws if not.
inline void require_recordable(const Options& options) {
  if (is_standard_output(options.record))
    throw std::runtime_error(options.record + ": a record does not go to standard output");
  if (options.record == options.output)
    throw std::runtime_error(options.record + ": the record and OUT are one file");
  require_replaceable(options.record, options.is_forced);
}

/// Has a mesh anything that a record of positions has not?
inline bool has_attributes(const IndexedMesh& mesh) {
  return !mesh.colors.empty() || !mesh.texture_coordinates.empty() ||
         !mesh.corner_textures.empty() || !mesh.corner_normals.empty() || mesh.parts.differ() ||
         !mesh.vertex_numbers.empty() || !mesh.face_numbers.empty();
}

inline std::string encoded_levels(const quadrille::Levels& levels) {
  std::ostringstream file;
  quadrille::write_levels(file, levels);
  return std::move(file).str();
}

/// Simplifies the mesh, and writes it and the record of the run. False if the target was not
/// reached.
inline bool run_recorded(IndexedMesh& mesh, const Options& options, const MeshFormat& format) {
  require_recordable(options);
  if (!options.is_quiet && has_attributes(mesh))
    std::cerr << options.input << ": the record holds positions only\n";
  quadrille::Levels levels;
  PositionRecorder recorder(levels);
  const quadrille::Report report = with_errors_of_file(
      options, [&] { return simplify_recorded(mesh, options, quadrille::record_into(recorder)); });
  const std::string record = encoded_levels(levels);
  const std::string result = encoded(options.output, mesh, format);
  replace_file(options.record, record, options.is_forced);
  replace_file(options.output, result, options.is_forced);
  return tell(options, report);
}

/// The level of a file that a target asks for.
inline quadrille::Level level_of(quadrille::LevelsFile& file, const Target& target) {
  if (const auto* part = std::get_if<quadrille::FaceRatio>(&target.chosen))
    return file.at(quadrille::FaceCount{static_cast<std::size_t>(
        std::llround(part->ratio * static_cast<double>(file.finest().faces)))});
  if (const auto* count = std::get_if<quadrille::FaceCount>(&target.chosen))
    return file.at(*count);
  if (const auto* count = std::get_if<quadrille::VertexCount>(&target.chosen))
    return file.at(*count);
  return file.at(quadrille::DistanceAtMost{target.distance});
}

inline IndexedMesh mesh_of(const quadrille::Level& level) {
  IndexedMesh mesh;
  for (const auto& [x, y, z] : level.points)
    mesh.points.emplace_back(x, y, z);
  mesh.triangles = level.triangles;
  return mesh;
}

/// As of a run; but a record does not know why it ends.
inline bool tell_level(const Options& options, const quadrille::LevelInfo& finest,
                       const quadrille::LevelInfo& level) {
  if (!options.is_quiet) {
    std::ostream& out = is_standard_output(options.output) ? std::cerr : std::cout;
    out << finest.faces << " -> " << level.faces << " faces, " << finest.vertices << " -> "
        << level.vertices << " vertices, " << level.contractions << " contractions, error "
        << level.error;
    if (std::isfinite(level.distance_bound))
      out << ", within " << level.distance_bound << " of the input";
    out << std::endl;
  }
  // A limit of distances is kept in any case: the next distance is not known, so beyond it.
  const bool is_reached = options.target({.initial_faces = finest.faces,
                                          .initial_vertices = finest.vertices,
                                          .faces = level.faces,
                                          .vertices = level.vertices});
  if (!is_reached)
    std::cerr << options.output << ": the target was not reached: the record ends at "
              << level.faces << " faces and " << level.vertices << " vertices\n";
  return is_reached;
}

/// Writes a level of a record. False if the record does not go as far as the target.
inline bool run_from_record(const Options& options) {
  const MeshFormat& format = output_format(options);
  require_replaceable(options.output, options.is_forced);
  quadrille::LevelsFile file(options.from);
  if (std::holds_alternative<quadrille::ErrorLimit>(options.target.chosen) &&
      !std::isfinite(file.coarsest().distance_bound))
    throw std::runtime_error(options.from + ": the record knows no distances for --error, since " +
                             "it was made without");
  const quadrille::Level level = level_of(file, options.target);
  if (!options.is_quiet && !level.channels.empty())
    std::cerr << options.from << ": not kept: attributes\n";
  write_mesh(options.output, mesh_of(in_input_order(level)), format, options.is_forced);
  return tell_level(options, file.finest(), level);
}

} // namespace quadrille_examples

#endif
