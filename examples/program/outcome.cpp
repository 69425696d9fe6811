#include "outcome.h"

#include "../mesh_io/replace_file.h"
#include "verification.h"

#include <quadrille/topology.h>
#include <quadrille/version.h>

#include <nlohmann/json.hpp>

#include <langinfo.h>

#include <clocale>
#include <cstring>
#include <numeric>

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

std::string line(const Options& options, const Outcome& outcome) {
  const Report& report = outcome.report;
  std::string text = options.input + ": " + with_commas(report.faces_before) + arrow() +
                     with_commas(report.faces_after) + " faces";
  if (report.counted_faces > 0)
    text += " (" +
            percent_text(static_cast<double>(report.faces_after) /
                         static_cast<double>(report.counted_faces)) +
            (report.counted_faces < report.faces_before
                 ? " of the " + with_commas(report.counted_faces) + " that count)"
                 : ")");
  if (!options.levels.empty())
    text += " in " + outcome.file;
  text += ", " + duration_text(report.seconds.total());
  if (std::isfinite(report.hausdorff_bound))
    text += ", no point of OUT is further than " +
            bound_text(report.hausdorff_bound, outcome.diagonal) + " from IN, nor of IN from OUT";
  else if (std::isfinite(report.distance_bound))
    text += ", no point of OUT is further than " +
            bound_text(report.distance_bound, outcome.diagonal) + " from IN";
  else
    text += ", error about " + distance_text(report.error, outcome.diagonal);
  if (report.used_tolerance)
    text += ", " + percent_text(rounded_up(report.used_tolerance->part)) + " of " +
            outcome.target.tolerance + " used";
  if (outcome.parts)
    text += ", by " + counted(outcome.parts->parts, "part") + " in " +
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
  if (report.vanished_parts > 0)
    text += ", " + with_commas(report.vanished_parts) + " parts vanished";
  const quadrille::Status input{.initial_faces = report.counted_faces,
                                .initial_vertices = report.vertices_before,
                                .faces = report.counted_faces,
                                .vertices = report.vertices_before};
  if (options.from.empty() && outcome.target.is_given() && outcome.target.is_coarse_enough(input))
    text += ": IN meets the target already";
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
                    {"held", finding.is_held}});
    if (finding.place && !finding.is_held)
      json.back()["place"] = finding.place->coordinates;
  }
  return json;
}

Json json_of(const quadrille::FileReport& parts) {
  return {{"phases", parts.phases},
          {"parts", parts.parts},
          {"faces_of_phases", parts.faces_of_phases},
          {"count_exact", parts.is_count_exact},
          {"shared_vertices", parts.shared_vertices},
          {"bytes_read", parts.bytes_read},
          {"bytes_written", parts.bytes_written},
          {"peak_memory", parts.peak_memory},
          {"left_out", parts.dropped}};
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
               {"vanished_parts", report.vanished_parts},
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
    json["used_tolerance"] = {{"part", report.used_tolerance->part},
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
  if (outcome.verdict)
    json["verified"] = json_of(*outcome.verdict);
  return json;
}

void write_report(const Options& options, const std::vector<Outcome>& outcomes) {
  Json json = {{"quadrille", QUADRILLE_PROGRAM_VERSION},
               {"input", options.input},
               {"results", Json::array()}};
  for (const Outcome& outcome : outcomes)
    json["results"].push_back(json_of(outcome));
  const auto replace = Json::error_handler_t::replace; // names of files that are not UTF-8
  replace_file(options.report, json.dump(2, ' ', false, replace) + '\n', options.is_forced);
}

/// What helps where parts of the surface, each of which keeps some faces, are in the way.
std::string hint_of_parts(const Options& options, const Report& report) {
  const std::string parts = with_commas(report.components_after) + " parts are left";
  if (topology(options) == quadrille::Topology::free)
    return options.joins_pairs() ? ""
                                 : parts + ": --pairs joins those that are closer than a distance";
  std::string text = parts + ", and each keeps some faces: ";
  if (!options.drops_parts)
    text += "--drop-parts lets small ones vanish, ";
  text += "--topology free lets holes close and thin parts become sheets, --pairs also joins parts";
  if (!options.weld)
    text += ", and --weld TOLERANCE makes vertices one that only nearly touch";
  return text;
}

} // namespace

std::vector<std::string> hints(const Options& options, const Outcome& outcome) {
  const Report& report = outcome.report;
  std::vector<std::string> hints;
  const auto add_if = [&](bool applies, const std::string& hint) {
    if (applies && !hint.empty())
      hints.push_back(hint);
  };
  const std::size_t all_refused =
      std::accumulate(report.rejections.begin(), report.rejections.end(), std::size_t{0});
  const auto counts = [&](std::size_t refusals) {
    return refusals > 0 && 100 * refusals >= all_refused; // what is rarer is not in the way
  };
  const auto refused = [&](Rejection cause) { return with_commas(report.rejected(cause)); };
  add_if(report.components_after > 1, hint_of_parts(options, report));
  add_if(topology(options) != quadrille::Topology::free && report.components_after <= 1 &&
             counts(report.rejected(Rejection::topology)),
         "topology is kept: --topology free lets holes close and thin parts become sheets");
  const bool keeps_seams = options.seams == quadrille::Seams::kept;
  add_if(counts(report.rejected(Rejection::seam)),
         "borders of materials and labels stay" +
             std::string(keeps_seams ? ", and seams of textures" : "") + " (" +
             refused(Rejection::seam) + " contractions refused)" +
             (keeps_seams ? ": --seams held lets seams vanish where that shows little" : ""));
  add_if(
      report.rejected(Rejection::destruction) > 0,
      with_commas(report.faces_after) +
          " faces are the least that can be reached like that: most of the surface can lose none, "
          "and the rest would lose its shape");
  add_if(counts(report.rejected(Rejection::constraint)) && options.locks_boundaries,
         "the boundary is locked (" + refused(Rejection::constraint) +
             " contractions refused): --boundary WEIGHT lets it move");
  return hints;
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
      broken = outcome.file + ": what was promised is not kept";
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
