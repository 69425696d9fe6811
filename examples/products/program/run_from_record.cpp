#include "../mesh_io/mesh/bounding_box.h"
#include "../mesh_io/mesh_io.h"
#include "../mesh_io/replace_file.h"
#include "outcome.h"
#include "runs.h"

#include <quadrille/levels.h>
#include <quadrille/levels_file.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace quadrille_examples {

namespace {

using quadrille::LevelInfo;

/// How many contractions lead to the level that a target asks for: the first of its parts that is
/// met.
std::size_t contractions_to(quadrille::LevelsFile& file, const Target& target, double distance) {
  std::size_t contractions = file.coarsest().contractions;
  const auto stop_at = [&](const auto& stop) {
    contractions = std::min(contractions, file.info(stop).contractions);
  };
  if (target.ratio || !target.is_given())
    stop_at(quadrille::FaceCount{static_cast<std::size_t>(
        std::llround(target.ratio.value_or(0.5) * static_cast<double>(file.finest().faces)))});
  if (target.faces)
    stop_at(quadrille::FaceCount{*target.faces});
  if (target.vertices)
    stop_at(quadrille::VertexCount{*target.vertices});
  if (target.error)
    stop_at(quadrille::DistanceAtMost{distance});
  return contractions;
}

IndexedMesh mesh_of(const quadrille::Level& level) {
  IndexedMesh mesh;
  for (const auto& [x, y, z] : level.points)
    mesh.points.emplace_back(x, y, z);
  mesh.triangles = level.triangles;
  return mesh;
}

/// As of a run; but a record does not know why it ends.
quadrille::Report report_of(const LevelInfo& finest, const LevelInfo& level, const Target& target) {
  quadrille::Report report;
  report.faces_before = report.counted_faces = finest.faces;
  report.vertices_before = finest.vertices;
  report.faces_after = level.faces;
  report.vertices_after = level.vertices;
  report.contractions = level.contractions;
  report.error = level.error;
  report.distance_bound = level.distance_bound;
  report.hausdorff_bound = level.hausdorff_bound;
  const bool is_met = target.is_coarse_enough({.initial_faces = finest.faces,
                                               .initial_vertices = finest.vertices,
                                               .faces = level.faces,
                                               .vertices = level.vertices});
  report.stop = is_met ? quadrille::StopReason::target_met : quadrille::StopReason::no_pair_left;
  return report;
}

} // namespace

bool run_from_record(const Options& options, ProgressLine& progress) {
  const MeshFormat& format = output_format(options);
  require_replaceable(options.output, options.is_forced);
  progress.show_stage("reading");
  const auto begin = std::chrono::steady_clock::now();
  quadrille::LevelsFile file(options.from);
  if (options.target.error && !std::isfinite(file.coarsest().distance_bound))
    throw std::runtime_error(options.from +
                             ": the record contains no distances for --error, since " +
                             "it was written by a run without --error");
  const Amount limit = options.target.error.value_or(Amount{});
  Outcome outcome{.file = options.output, .target = options.target, .report = {}};
  if (limit.is_percentage) { // all of the file is read for it
    const quadrille::Level finest = file.at(quadrille::AfterContractions{0});
    outcome.diagonal = diagonal(finest.points, finest.triangles);
  }
  const std::size_t contractions =
      contractions_to(file, options.target, length_of(limit, outcome.diagonal));
  const quadrille::Level level = file.at(quadrille::AfterContractions{contractions});
  outcome.report = report_of(file.finest(), level, options.target);
  outcome.report.seconds.read =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  progress.clear();
  if (!level.channels.empty())
    print_remark(options, "not kept: attributes");
  require_not_interrupted(options);
  write_mesh(options.output, mesh_of(in_input_order(level)), format, options.is_forced);
  return tell(options, {outcome});
}

} // namespace quadrille_examples
