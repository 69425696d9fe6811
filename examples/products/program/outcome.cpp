#include "outcome.h"

#include "../mesh_io/replace_file.h"
#include "option_names.h"
#include "verification.h"

#include <quadrille/pairs.h>
#include <quadrille/version.h>

#include <nlohmann/json.hpp>

#include <langinfo.h>

#include <clocale>
#include <cstring>
#include <numeric>
#include <optional>
#include <string_view>
#include <type_traits>

namespace quadrille_examples {

namespace {

using Json = nlohmann::ordered_json;
using quadrille::Rejection;
using quadrille::Report;

/// An arrow, if the terminal's character set has one.
const char* arrow() {
  return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0 ? " → " : " -> ";
}

/// As a part of the diagonal, if there is one.
std::string distance_text(double distance, double diagonal) {
  return diagonal > 0 ? percent_text(distance / diagonal) + " of the diagonal"
                      : two_digits(distance) + " in units of the mesh";
}

std::string bound_text(double bound, double diagonal) {
  return diagonal > 0 ? percent_text(rounded_up(100 * bound / diagonal) / 100) + " of the diagonal"
                      : two_digits(rounded_up(bound)) + " in units of the mesh";
}

std::string measured_text(const Measurement& measured, double diagonal) {
  std::string text = ", measured " + distance_text(measured.greatest, diagonal) + " apart, " +
                     distance_text(measured.rms, diagonal) + " RMS";
  if (measured.texture)
    text += ", the texture " + distance_text(measured.texture->rms, diagonal) + " RMS";
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return with_commas(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string vanished_text(const Report& report, double diagonal) {
  const bool are_small = report.largest_vanished_component < 0.05 * diagonal;
  return counted(report.vanished_components, are_small ? "small component" : "component") +
         " vanished, the largest of size " +
         distance_text(report.largest_vanished_component, diagonal);
}

std::string line(const Options& options, const Outcome& outcome) {
  const Report& report = outcome.report;
  std::string text = options.input + ": " + with_commas(report.faces_before) + arrow() +
                     with_commas(report.faces_after) + " faces";
  if (report.counted_faces > 0)
    text += " (" +
            percent_text(static_cast<double>(report.faces_after) /
                         static_cast<double>(report.counted_faces)) +
            (report.counted_faces < report.faces_before
                 ? " of the " + with_commas(report.counted_faces) + " to be simplified)"
                 : ")");
  if (!options.levels.empty())
    text += " in " + outcome.file;
  text += ", " + duration_text(report.seconds.total());
  const double least_distance = 1e-9 * outcome.diagonal; // less is rounding
  const std::string cuts = report.cut_distance > least_distance ? " with its cuts" : "";
  if (std::isfinite(report.hausdorff_bound))
    text += ", no point of OUT is further than " +
            bound_text(report.hausdorff_bound, outcome.diagonal) + " from IN" + cuts +
            ", and no point of IN further than that from OUT";
  else if (std::isfinite(report.distance_bound))
    text += ", no point of OUT is further than " +
            bound_text(report.distance_bound, outcome.diagonal) + " from IN" + cuts;
  else
    text += ", error about " + distance_text(report.error, outcome.diagonal);
  if (report.used_tolerance)
    text += ", " + percent_text(rounded_up(report.used_tolerance->fraction)) + " of " +
            outcome.target.tolerance + " used";
  if (outcome.parts)
    text += ", in " + counted(outcome.parts->chunks, "chunk") + " in " +
            counted(outcome.parts->phases, "phase") + ", " +
            two_digits(static_cast<double>(outcome.parts->peak_memory) / 1e9) + " GB of memory";
  if (outcome.measured)
    text += measured_text(*outcome.measured, outcome.diagonal);
  if (report.self_intersections)
    text += ", " + with_commas(report.self_intersections->before) + arrow() +
            with_commas(report.self_intersections->after) + " pairs of faces intersect";
  if (report.volume_before && report.volume_after && *report.volume_before != 0)
    text += ", " + percent_text(*report.volume_after / *report.volume_before) + " of the volume";
  if (report.normal_bound_degrees)
    text += ", normals within " + two_digits(rounded_up(*report.normal_bound_degrees)) + " degrees";
  if (report.vanished_components > 0)
    text += ", " + vanished_text(report, outcome.diagonal);
  if (report.kept_planes > 0)
    text += ", " + counted(report.kept_planes, "plane region") + " kept";
  if (report.joined_gaps > 0)
    text += ", " + counted(report.joined_gaps, "gap") + " joined";
  if (report.open_gaps > 0)
    text += ", " + counted(report.open_gaps, "gap") + " left open";
  if (report.cut_handles > 0)
    text += ", " + counted(report.cut_handles, "handle") + " cut";
  if (report.split_components > 0)
    text += ", " + counted(report.split_components, "component") + " cut in two";
  if (report.cut_distance > least_distance)
    text += ", closed within " + distance_text(report.cut_distance, outcome.diagonal) + " of IN";
  if (report.split_vertices + report.split_edges > 0)
    text += ", made manifold: " + with_commas(report.split_vertices) + " vertices split, " +
            with_commas(report.split_edges) + " edges split in their middle";
  const quadrille::Status input{.initial_faces = report.counted_faces,
                                .initial_vertices = report.vertices_before,
                                .faces = report.counted_faces,
                                .vertices = report.vertices_before};
  if (options.from.empty() && outcome.target.is_given() && outcome.target.is_coarse_enough(input))
    text += ": IN already meets the target";
  return text;
}

Json json_of(const Target& target) {
  Json json = Json::object();
  if (target.faces)
    json["faces"] = *target.faces;
  if (target.ratio || !target.is_given())
    json["ratio"] = target.ratio.value_or(0.5);
  if (target.vertices)
    json["vertices"] = *target.vertices;
  if (target.error)
    json[target.error->is_percentage ? "relative_error" : "error"] = target.error->value;
  if (target.both_ways)
    json["both_ways"] = true;
  if (target.is_calibrated)
    json["calibrated"] = true;
  if (!target.tolerance.empty())
    json["tolerance"] = target.tolerance;
  return json;
}

Json json_of(const Measurement& measured) {
  Json json = {{"rms", measured.rms},
               {"greatest", measured.greatest},
               {"greatest_to_input", measured.to_input},
               {"greatest_from_input", measured.from_input}};
  if (measured.texture)
    json["texture"] = {{"rms", measured.texture->rms},
                       {"greatest", measured.texture->greatest},
                       {"percentile_99", measured.texture->percentile_99},
                       {"bleeding", measured.texture->bleeding},
                       {"flipped", measured.texture->flipped}};
  return json;
}

Json json_of(const quadrille::Verdict& verdict) {
  Json json = Json::array();
  for (const quadrille::Finding& finding : verdict.findings) {
    json.push_back({{"claim", finding.claim},
                    {"promised", finding.promised},
                    {"measured", finding.measured},
                    {"error", finding.error},
                    {"held", finding.is_met}});
    if (finding.place && !finding.is_met)
      json.back()["place"] = finding.place->coordinates;
  }
  return json;
}

Json json_of(const quadrille::FileReport& parts) {
  return {{"phases", parts.phases},
          {"chunks", parts.chunks},
          {"faces_of_phases", parts.faces_of_phases},
          {"count_exact", parts.is_count_exact},
          {"shared_vertices", parts.shared_vertices},
          {"bytes_read", parts.bytes_read},
          {"bytes_written", parts.bytes_written},
          {"peak_memory", parts.peak_memory},
          {"left_out", parts.dropped}};
}

Json json_of(const HiddenSummary& hidden) {
  Json groups = Json::array();
  for (const HiddenSummary::Group& group : hidden.groups)
    groups.push_back({{"kind", group.kind},
                      {"faces", group.faces},
                      {"area", group.area},
                      {"volume", group.volume},
                      {"diagonal", group.diagonal}});
  return {{"mode", hidden.mode},          {"threshold", hidden.threshold},
          {"faces", hidden.faces},        {"hidden", hidden.hidden},
          {"area", hidden.area_fraction}, {"cut_edges", hidden.cut_edges},
          {"dropped", hidden.dropped},    {"caps", hidden.caps},
          {"groups", std::move(groups)}};
}

/// Adds an option of the table unless it has its default. Arrays are told by the scalar that they
/// come from.
template <class Owner>
void add_option(Json& json, const char* name, const auto& value, const auto& fallback) {
  using Value = quadrille::internal::OptionValue<std::remove_cvref_t<decltype(value)>>;
  if constexpr (!std::is_arithmetic_v<Value> && !std::is_enum_v<Value>)
    return;
  else if (value == fallback)
    return;
  else if constexpr (std::is_enum_v<Value>) {
    for (const OptionWord& word : quadrille::internal::words_of<Owner>())
      if (word.option == std::string_view(name) && value == static_cast<Value>(word.value))
        json[name] = word.word;
  } else if constexpr (std::is_same_v<Value, std::remove_cvref_t<decltype(value)>>)
    json[name] = value;
  else
    json[name] = *value;
}

/// Returns the options of the table that the program was called with, by their names in it;
/// `diagonal` is that of the input. See option_table.py for their schema.
Json json_of(const Options& options, double diagonal) {
  Json json = Json::object();
  const quadrille::internal::SoupJob defaults;
  const quadrille::ChannelOptions textures;
#define QUADRILLE_OPTION(kind, field, ...)                                                         \
  add_option<quadrille::SoupOptions>(json, #field, options.soup.field, defaults.field);
#define QUADRILLE_JOB_OPTION QUADRILLE_OPTION
#define QUADRILLE_CHANNEL_OPTION(kind, field, ...)                                                 \
  add_option<quadrille::ChannelOptions>(json, #field, options.textures.field, textures.field);
#include <quadrille/compiled/options.def>
  for (const auto& [option, amount] : options.lengths)
    json[option] = length_of(amount, diagonal);
  for (const auto& [option, scalar] : options.scalars)
    json[option] = scalar;
  if (const std::optional<Amount>& error = options.target.error)
    json[error->is_percentage ? "relative_error" : "error"] = error->value;
  if (!options.target.tolerance.empty())
    json["tolerance"] = options.target.tolerance;
  return json;
}

Json before_and_after(std::size_t before, std::size_t after) {
  return {{"before", before}, {"after", after}};
}

Json json_of(const Outcome& outcome) {
  const Report& report = outcome.report;
  Json rejections = Json::object();
  for (std::size_t cause = 0; cause < quadrille::rejection_causes; ++cause)
    if (report.rejections[cause] > 0)
      rejections[std::string(to_string(static_cast<Rejection>(cause)))] = report.rejections[cause];
  Json json = {{"output", outcome.file},
               {"target", json_of(outcome.target)},
               {"target_met", outcome.is_target_met()},
               {"stop", to_string(report.stop)},
               {"faces", before_and_after(report.faces_before, report.faces_after)},
               {"counted_faces", report.counted_faces},
               {"doubled_faces", report.doubled_faces},
               {"vertices", before_and_after(report.vertices_before, report.vertices_after)},
               {"components", before_and_after(report.components_before, report.components_after)},
               {"contractions", report.contractions},
               {"non_edge_contractions", report.non_edge_contractions},
               {"vanished_components", report.vanished_components},
               {"largest_vanished_component", report.largest_vanished_component},
               {"joined_gaps", report.joined_gaps},
               {"open_gaps", report.open_gaps},
               {"cut_handles", report.cut_handles},
               {"split_components", report.split_components},
               {"cut_distance", report.cut_distance},
               {"split_vertices", report.split_vertices},
               {"split_edges", report.split_edges},
               {"non_manifold_edges", report.non_manifold_edges},
               {"non_manifold_vertices", report.non_manifold_vertices},
               {"error", report.error},
               {"distance_bound", nullptr},
               {"hausdorff_bound", nullptr},
               {"used_tolerance", nullptr},
               {"self_intersections", nullptr},
               {"volume", nullptr},
               {"normal_bound_degrees", nullptr},
               {"diagonal", outcome.diagonal},
               {"rejections", rejections},
               {"seconds",
                {{"read", report.seconds.read},
                 {"prepare", report.seconds.prepare},
                 {"contract", report.seconds.contract},
                 {"write", report.seconds.write}}}};
  if (std::isfinite(report.distance_bound)) // JSON has no infinity
    json["distance_bound"] = report.distance_bound;
  if (std::isfinite(report.hausdorff_bound))
    json["hausdorff_bound"] = report.hausdorff_bound;
  if (report.used_tolerance)
    json["used_tolerance"] = {{"part", report.used_tolerance->fraction},
                              {"place", report.used_tolerance->place}};
  if (report.self_intersections)
    json["self_intersections"] =
        before_and_after(report.self_intersections->before, report.self_intersections->after);
  if (report.volume_before && report.volume_after)
    json["volume"] = {{"before", *report.volume_before}, {"after", *report.volume_after}};
  if (report.normal_bound_degrees)
    json["normal_bound_degrees"] = *report.normal_bound_degrees;
  if (outcome.measured)
    json["measured"] = json_of(*outcome.measured);
  if (outcome.parts) {
    json["out_of_core"] = json_of(*outcome.parts);
    for (const char* const unknown : {"components", "non_manifold_edges", "non_manifold_vertices"})
      json[unknown] = nullptr;
  }
  if (outcome.hidden)
    json["hidden"] = json_of(*outcome.hidden);
  if (outcome.verdict)
    json["verified"] = json_of(*outcome.verdict);
  return json;
}

void write_report(const Options& options, const std::vector<Outcome>& outcomes) {
  Json json = {{"quadrille", QUADRILLE_PROGRAM_VERSION},
               {"input", options.input},
               {"options", json_of(options, outcomes.empty() ? 0 : outcomes.front().diagonal)},
               {"results", Json::array()}};
  for (const Outcome& outcome : outcomes)
    json["results"].push_back(json_of(outcome));
  const auto replace = Json::error_handler_t::replace; // names of files that are not UTF-8
  replace_file(options.report, json.dump(2, ' ', false, replace) + '\n', options.is_forced);
}

/// What is in the way of a target, and what would help.
class Hints {
public:
  Hints(const Options& options, const Outcome& outcome)
      : options_(options), outcome_(outcome), report_(outcome.report),
        is_free_(topology(options) == quadrille::Topology::free),
        rejections_(std::accumulate(report_.rejections.begin(), report_.rejections.end(),
                                    std::size_t{0})) {}

  std::vector<std::string> all() {
    if (outcome_.trials)
      for (const Trial& trial : *outcome_.trials)
        add_trial(trial);
    if (are_components_obstacles())
      add_components();
    else if (!is_free_ && counts(Rejection::topology))
      add("topology is kept", "--topology free lets holes close and thin features collapse");
    if (counts(Rejection::seam))
      add_seams();
    if (report_.stop == quadrille::StopReason::target_unreachable)
      hints_.push_back(
          "the run stopped at " + with_commas(report_.faces_after) +
          " faces: most of the remaining regions cannot lose a face, and the others would lose "
          "their shape");
    if (is_blocked_by_topology_alone())
      hints_.push_back("the topology needs all " + with_commas(report_.faces_after) +
                       " remaining faces: no edge can be contracted without changing it");
    if (are_pairs_of_faces_left())
      hints_.emplace_back(
          "components of two faces are kept by default: --faces or --keep asks for fewer");
    if (counts(Rejection::constraint) && options_.locks_boundaries)
      hints_.push_back("the boundary is locked (" + refused(Rejection::constraint) +
                       " contractions rejected): --boundary WEIGHT lets it move");
    return std::move(hints_);
  }

private:
  /// What would help is named where nothing was tried.
  void add(const std::string& cause, const std::string& help) {
    hints_.push_back(outcome_.trials ? cause : cause + ": " + help);
  }

  void add_trial(const Trial& trial) {
    std::string text = "with " + trial.option + " the result has " +
                       with_commas(trial.report.faces_after) + " faces, error about " +
                       distance_text(trial.report.error, outcome_.diagonal);
    if (trial.report.vanished_components > report_.vanished_components)
      text += ", " + vanished_text(trial.report, outcome_.diagonal);
    hints_.push_back(text);
  }

  /// What is rarer is not in the way.
  bool counts(Rejection cause) const {
    return report_.rejected(cause) > 0 && 100 * report_.rejected(cause) >= rejections_;
  }
  std::string refused(Rejection cause) const { return with_commas(report_.rejected(cause)); }

  /// Each keeps four faces, or one if it has a border.
  bool are_components_obstacles() const {
    return report_.components_after > 1 && 10 * report_.components_after >= report_.faces_after;
  }

  /// A closed surface keeps its topology to the end; where nothing else was ever refused, that is
  /// what the faces that are left owe it.
  bool is_blocked_by_topology_alone() const {
    return !is_free_ && report_.stop == quadrille::StopReason::all_pairs_rejected &&
           report_.rejected(Rejection::topology) == rejections_;
  }

  /// They are where no target is asked for, and there is nothing else.
  bool are_pairs_of_faces_left() const {
    return !outcome_.target.is_given() && report_.contractions == 0 &&
           report_.rejected(Rejection::constraint) > 0 && !options_.locks_boundaries;
  }

  void add_components() {
    std::string text = with_commas(report_.components_after) + " components are left";
    if (is_free_ && options_.joins_pairs())
      return;
    if (is_free_) {
      hints_.push_back(text + ": --pairs DISTANCE joins those that are closer than that");
      return;
    }
    text += ", and each keeps some faces: ";
    if (!outcome_.trials && topology(options_) != quadrille::Topology::components_may_vanish)
      text += "--drop-parts removes small ones, ";
    if (!outcome_.trials)
      text += "--topology free lets holes close and thin features collapse, ";
    text += outcome_.trials ? "--pairs DISTANCE joins those that are closer than that"
                            : "--pairs DISTANCE joins components";
    if (!options_.weld && !is_gltf(extension_of(options_.input, options_)))
      text += ", and --weld TOLERANCE merges vertices that nearly touch";
    hints_.push_back(text);
  }

  /// Seams of textures are among those that hold only where they are kept.
  void add_seams() {
    const bool holds_textures = options_.textures.seams == quadrille::Seams::kept;
    std::string text = outcome_.has_labels ? "boundaries of materials and labels stay" : "";
    if (holds_textures)
      text += outcome_.has_labels ? ", and so do texture seams" : "texture seams stay";
    if (text.empty())
      return;
    text += " (" + refused(Rejection::seam) + " contractions rejected)";
    if (holds_textures)
      add(text, "--seams soft removes seams where this is hardly visible");
    else
      hints_.push_back(text);
  }

  const Options& options_;
  const Outcome& outcome_;
  const Report& report_;
  bool is_free_;
  std::size_t rejections_; // of all causes
  std::vector<std::string> hints_;
};

} // namespace

std::vector<std::string> hints(const Options& options, const Outcome& outcome) {
  return Hints(options, outcome).all();
}

bool tell(const Options& options, const std::vector<Outcome>& outcomes) {
  bool is_reached = true;
  std::string broken;
  std::setlocale(LC_CTYPE, "");
  if (!options.report.empty())
    write_report(options, outcomes);
  for (const Outcome& outcome : outcomes) {
    if (!options.is_quiet)
      output_of_figures(options) << line(options, outcome) << std::endl;
    if (options.is_verbose)
      output_of_figures(options) << outcome.file << ": " << outcome.report << std::endl;
    if (outcome.verdict && !options.is_quiet)
      output_of_figures(options) << outcome.file << ": verified: " << *outcome.verdict << std::endl;
    if (outcome.verdict && !*outcome.verdict)
      broken = outcome.file + ": a promise is not kept";
    if (outcome.is_target_met())
      continue;
    is_reached = false;
    std::cerr << outcome.file << ": the target was not reached: " << to_string(outcome.report.stop)
              << '\n';
    if (!options.is_quiet && outcome.report.stop != quadrille::StopReason::cancelled)
      for (const std::string& hint : hints(options, outcome))
        std::cerr << outcome.file << ": " << hint << '\n';
  }
  if (!broken.empty())
    throw BrokenPromise(broken);
  return is_reached;
}

} // namespace quadrille_examples
