#include "outcome.h"
#include "runs.h"

#ifdef QUADRILLE_WITH_PAGE
#include "../mesh_io/mesh/bounding_box.h"
#include "../mesh_io/mesh/split_seams.h"
#include "../mesh_io/mesh_io.h"
#include "../mesh_io/replace_file.h"
#include "../page/file.h"
#include "../page/gltf_scene.h"
#include "../page/materials.h"
#include "simplify_mesh.h"

#include <quadrille/levels_file.h>
#include <quadrille/record.h>
#endif

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

#ifdef QUADRILLE_WITH_PAGE

namespace {

/// Without a target a page goes down to so few faces, or as far as the topology lets it.
constexpr std::size_t least_faces_of_page = 4;

ShownMesh read_shown(const Options& options) {
  if (is_gltf(extension_of(options.input, options)))
    return GltfScene::read(options.input);
  ShownMesh shown;
  shown.mesh = with_vertices_of_values(read_mesh(options.input, format_of(options.input, options),
                                                 options.weld ? Weld::places : Weld::surfaces,
                                                 options.weld.value_or(Amount{})));
  ObjMaterials(options.input, shown.looks).read(shown.mesh.parts);
  read_ply_image(options.input, shown.mesh, shown.looks);
  return shown;
}

/// Records a run.
Outcome record(Options options, PageSource& source, ProgressLine& progress) {
  progress.show_stage("reading");
  ShownMesh shown = read_shown(options);
  require_fit(options, shown.mesh);
  take_scalars(options, shown.mesh);
  progress.clear();
  print_remarks(options, shown.mesh);
  print_preset(options);
  orient(options, shown.mesh);
  std::optional<HiddenSummary> hidden = prepare_hidden(options, shown.mesh, progress);
  Outcome outcome{.file = options.output,
                  .target = options.target,
                  .report = {},
                  .diagonal = diagonal(shown.mesh.points, shown.mesh.triangles),
                  .has_labels = !FaceRegions(shown.mesh).labels().empty(),
                  .hidden = std::move(hidden)};
  if (!options.target.is_given())
    options.target.faces = least_faces_of_page;
  AttributeRecorder recorder(shown, source.levels);
  outcome.report = with_errors_of_file(options, [&] {
    return simplify_mesh(shown.mesh, options, quadrille::record_into(recorder));
  });
  require_not_interrupted(options);
  if (!outcome.target.is_given() && outcome.report.stop != quadrille::StopReason::cancelled)
    outcome.report.stop = quadrille::StopReason::target_met; // as far as it goes
  source.attributes = recorder.take();
  source.looks = std::move(shown.looks);
  return outcome;
}

void write(const Options& options, const PageSource& source, ProgressLine& progress) {
  progress.show_stage("writing");
  const EncodedPage page = encode_page(source);
  require_not_interrupted(options);
  replace_file(options.output, page.content, options.is_forced);
  progress.clear();
  for (const std::string& note : source.looks.notes)
    print_remark(options, note);
  if (const std::size_t faces = source.levels.finest().faces; page.faces < faces)
    print_remark(options, "the finest level of the page has " + std::to_string(page.faces) +
                              " of " + std::to_string(faces) + " faces");
}

} // namespace

bool run_page(const Options& options, ProgressLine& progress) {
  if (!options.levels.empty() || !options.record.empty() || options.measures)
    throw std::runtime_error(options.output +
                             ": a page contains all levels: --levels, --record and " +
                             "--measure do not go with it");
  if (!options.from.empty() && (options.target.is_given() || !options.report.empty()))
    throw std::runtime_error(options.output +
                             ": a page contains all levels of a record: --report and " +
                             "targets do not go with it");
  require_replaceable(options.output, options.is_forced);
  PageSource source;
  source.name = std::filesystem::path(options.input).filename();
  if (options.from.empty()) {
    const Outcome outcome = record(options, source, progress);
    write(options, source, progress);
    return tell(options, {outcome});
  }
  progress.show_stage("reading");
  source.levels = quadrille::read_levels(options.from);
  if (!source.levels.at(quadrille::AfterContractions{0}).channels.empty())
    source.looks.notes.emplace_back("The page does not show the attributes of the record");
  write(options, source, progress);
  return true;
}

#else

bool run_page(const Options& options, ProgressLine&) {
  throw std::runtime_error(options.output + ": this program was built without the viewer of " +
                           "pages (.html), which needs npm and its registry");
}

#endif

} // namespace quadrille_examples
