#include "hidden.h"

#include "../mesh_io/attributes/soup_arrays.h"
#include "../mesh_io/mesh/mesh_values.h"
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
  const std::string dropped = summary.dropped == summary.hidden
                                  ? ", dropped"
                                  : ", dropped: " + with_commas(summary.dropped);
  print_remark(options, "hidden faces: " + with_commas(summary.hidden) + " of " +
                            with_commas(summary.faces) + ", " +
                            percent_text(summary.area_fraction) + " of the area" +
                            (options.hidden.drops() && summary.hidden > 0 ? dropped : ""));
  for (std::size_t i = 0; i < (std::min)(most_groups, summary.groups.size()); ++i)
    print_group(options, summary.groups[i]);
  if (summary.groups.size() > most_groups)
    print_remark(options,
                 "  and " + with_commas(summary.groups.size() - most_groups) + " smaller groups");
  if (summary.caps > 0)
    print_remark(options,
                 "loops closed where hidden faces were dropped: " + with_commas(summary.caps));
}

quadrille::HiddenOptions hidden_options(const Options& options, ProgressLine& progress) {
  quadrille::HiddenOptions result{.threads = threads_of(options), .progress = shown_by(progress)};
  result.threshold = options.hidden.threshold.value_or(result.threshold);
  return result;
}

void require_seen(const Options& options, const quadrille::HiddenFaces& found,
                  ProgressLine& progress) {
  progress.clear();
  if (found.is_cancelled)
    throw Interrupted();
  if (found.count == found.is_hidden.size() && found.count > 0)
    throw std::runtime_error(options.input + ": no face is seen from more of the directions than "
                                             "the threshold of --hidden");
}

/// Drops hidden faces, with whatever belongs to them; what is added has what is next to it.
HiddenSummary drop(Options& options, IndexedMesh& mesh, ProgressLine& progress) {
  const quadrille::HiddenOptions how = hidden_options(options, progress);
  quadrille::SoupPoints points = soup_points(mesh.points);
  quadrille::SoupTriangles triangles = mesh.triangles;
  const std::size_t points_before = points.size(), faces_before = triangles.size();
  const quadrille::HiddenRemoval changes = quadrille::remove_hidden(points, triangles, how);
  require_seen(options, changes.found, progress);
  mesh.points = mesh_points(points);
  mesh.triangles = std::move(triangles);
  follow(mesh, points_before, changes.origins, changes.triangles, faces_before - changes.removed);
  follow_triangles(options.soup.selected, changes.triangles);
  for (std::size_t i = 0; i < changes.origins.size() && !options.soup.importance.empty(); ++i)
    options.soup.importance.push_back(double{options.soup.importance[changes.origins[i][0]]});
  HiddenSummary summary = summary_of(options, changes.found, how.threshold);
  summary.dropped = changes.removed;
  summary.caps = changes.caps;
  print_summary(options, summary);
  return summary;
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
  const quadrille::HiddenOptions how = hidden_options(options, progress);
  quadrille::HiddenFaces found = quadrille::hidden_faces(points, triangles, how);
  require_seen(options, found, progress);
  HiddenAnswer answer{.summary = summary_of(options, found, how.threshold)};
  answer.summary->dropped = options.hidden.drops() ? found.count : 0;
  print_summary(options, *answer.summary);
  if (options.hidden.drops() && found.cut_edges > 0)
    print_remark(options,
                 "boundary edges where hidden faces were dropped: " + with_commas(found.cut_edges));
  if (options.hidden.drops())
    answer.is_dropped = std::move(found.is_hidden);
  return answer;
}

std::optional<HiddenSummary> prepare_hidden(Options& options, IndexedMesh& mesh,
                                            ProgressLine& progress) {
  if (!options.hidden.is_given())
    return std::nullopt;
  if (options.hidden.drops())
    return drop(options, mesh, progress);
  HiddenAnswer answer = find_hidden(options, soup_points(mesh.points), mesh.triangles, progress);
  if (!answer.importances.empty())
    options.soup.importance.resize(mesh.points.size(), 1);
  for (std::size_t v = 0; v < answer.importances.size(); ++v)
    options.soup.importance[v] *= answer.importances[v];
  return std::move(answer.summary);
}

} // namespace quadrille_examples
