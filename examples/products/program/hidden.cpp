#include "hidden.h"

#include "../mesh_io/attributes/soup_arrays.h"
#include "../mesh_io/mesh/follow_triangles.h"
#include "figures.h"
#include "interruption.h"
#include "options.h"
#include "progress_line.h"
#include "runs.h"

#include <quadrille/hidden.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <thread>
#include <utility>

namespace quadrille_examples {

namespace {

unsigned threads_of(const Options& options) {
#ifdef QUADRILLE_WITH_TBB
  return options.threads > 0 ? options.threads
                             : (std::max)(1U, std::thread::hardware_concurrency());
#else
  static_cast<void>(options);
  return 1;
#endif
}

std::function<bool(double)> shown_by(ProgressLine& progress) {
  return [&progress](double fraction) {
    progress.show_part("looking for hidden faces", fraction);
    return !Interruption::is_asked();
  };
}

HiddenSummary summary_of(const Options& options, const quadrille::HiddenFaces& found,
                         double threshold) {
  HiddenSummary summary{.mode = options.hidden.mode,
                        .threshold = threshold,
                        .faces = found.is_hidden.size(),
                        .hidden = found.count,
                        .area_fraction = found.whole_area > 0 ? found.area / found.whole_area : 0,
                        .cut_edges = found.cut_edges};
  for (const quadrille::HiddenGroup& group : found.groups)
    summary.groups.push_back({std::string(to_string(group.kind)), group.faces.size(), group.area,
                              group.volume, group.diagonal});
  return summary;
}

void print_group(const Options& options, const HiddenSummary::Group& group) {
  print_remark(options, "  " + group.kind + ": " + with_commas(group.faces) + " faces, area " +
                            two_digits(group.area) +
                            (group.volume > 0 ? ", volume " + two_digits(group.volume) : "") +
                            ", diagonal " + two_digits(group.diagonal));
}

void print_summary(const Options& options, const HiddenSummary& summary) {
  constexpr std::size_t most_groups = 5;
  const bool drops = options.hidden.drops();
  print_remark(options, "hidden faces: " + with_commas(summary.hidden) + " of " +
                            with_commas(summary.faces) + ", " +
                            percent_text(summary.area_fraction) + " of the area" +
                            (drops && summary.hidden > 0 ? ", dropped" : ""));
  for (std::size_t i = 0; i < (std::min)(most_groups, summary.groups.size()); ++i)
    print_group(options, summary.groups[i]);
  if (summary.groups.size() > most_groups)
    print_remark(options,
                 "  and " + with_commas(summary.groups.size() - most_groups) + " smaller groups");
  if (drops && summary.cut_edges > 0)
    print_remark(options, "boundary edges where hidden faces were dropped: " +
                              with_commas(summary.cut_edges));
}

/// Drops triangles with whatever belongs to them; points stay.
void drop(const std::vector<bool>& is_dropped, Options& options, IndexedMesh& mesh) {
  const std::vector<std::size_t> kept = kept_triangles(is_dropped);
  follow_triangles(mesh.triangles, kept);
  follow_triangles(mesh.value_triangles, kept);
  follow_triangles(mesh.corner_textures.triples, kept);
  follow_triangles(mesh.corner_normals.triples, kept);
  follow_triangles(mesh.parts.of_faces, kept);
  for (NamedNumbers& numbers : mesh.face_numbers)
    follow_triangles(numbers.values, kept);
  follow_triangles(options.soup.selected, kept);
}

std::vector<double> weights_of(const Options& options, const quadrille::SoupPoints& points,
                               const quadrille::SoupTriangles& triangles, ProgressLine& progress) {
  const quadrille::Visibility seen = quadrille::visibility(
      points, triangles, {.threads = threads_of(options), .progress = shown_by(progress)});
  progress.clear();
  if (seen.faces.size() != triangles.size())
    throw Interrupted();
  return quadrille::visibility_importance(seen);
}

} // namespace

HiddenAnswer find_hidden(const Options& options, const quadrille::SoupPoints& points,
                         const quadrille::SoupTriangles& triangles, ProgressLine& progress) {
  if (!options.hidden.is_given())
    return {};
  if (options.hidden.mode == "weight")
    return {.importances = weights_of(options, points, triangles, progress)};
  quadrille::HiddenOptions how{.threads = threads_of(options), .progress = shown_by(progress)};
  how.threshold = options.hidden.threshold.value_or(how.threshold);
  quadrille::HiddenFaces found = quadrille::hidden_faces(points, triangles, how);
  progress.clear();
  if (found.is_cancelled)
    throw Interrupted();
  HiddenAnswer answer{.summary = summary_of(options, found, how.threshold)};
  print_summary(options, *answer.summary);
  if (found.count == triangles.size() && found.count > 0)
    throw std::runtime_error(options.input + ": no face is seen from more of the directions than "
                                             "the threshold of --hidden");
  if (options.hidden.drops())
    answer.is_dropped = std::move(found.is_hidden);
  return answer;
}

std::optional<HiddenSummary> prepare_hidden(Options& options, IndexedMesh& mesh,
                                            ProgressLine& progress) {
  if (!options.hidden.is_given())
    return std::nullopt;
  HiddenAnswer answer = find_hidden(options, soup_points(mesh.points), mesh.triangles, progress);
  if (!answer.is_dropped.empty())
    drop(answer.is_dropped, options, mesh);
  if (!answer.importances.empty())
    options.soup.importance.resize(mesh.points.size(), 1);
  for (std::size_t v = 0; v < answer.importances.size(); ++v)
    options.soup.importance[v] *= answer.importances[v];
  return std::move(answer.summary);
}

} // namespace quadrille_examples
