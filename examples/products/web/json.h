#ifndef QUADRILLE_EXAMPLES_WEB_JSON_H
#define QUADRILLE_EXAMPLES_WEB_JSON_H

#include <quadrille/levels.h>
#include <quadrille/report.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace quadrille_examples {

/// An object of JSON, member by member.
class JsonObject {
public:
  void add_raw(std::string_view name, std::string_view json) {
    text_ += (text_.empty() ? "{\"" : ",\"") + std::string(name) + "\":" + std::string(json);
  }
  void add(std::string_view name, std::string_view text) { // without quotes and line ends
    add_raw(name, '"' + std::string(text) + '"');
  }
  void add(std::string_view name, bool value) { add_raw(name, value ? "true" : "false"); }
  void add(std::string_view name, std::size_t count) { add_raw(name, std::to_string(count)); }
  void add(std::string_view name, double number) { add_raw(name, text_of(number)); }
  void add(std::string_view name, const std::array<std::size_t, 2>& pair) {
    add_raw(name, '[' + std::to_string(pair[0]) + ',' + std::to_string(pair[1]) + ']');
  }

  /// What is beyond all doubles, as 1e999, is read as Infinity.
  static std::string text_of(double number) {
    if (!std::isfinite(number))
      return number > 0 ? "1e999" : "null";
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
  }

  std::string text() const { return text_.empty() ? "{}" : text_ + '}'; }

private:
  std::string text_;
};

inline std::string line_of(const quadrille::Report& report) {
  std::ostringstream line;
  line << report;
  return std::move(line).str();
}

inline std::string json_of_rejections(const quadrille::Report& report) {
  JsonObject rejections;
  for (std::size_t cause = 0; cause < quadrille::rejection_causes; ++cause)
    if (report.rejections[cause] > 0)
      rejections.add(to_string(static_cast<quadrille::Rejection>(cause)), report.rejections[cause]);
  return rejections.text();
}

inline std::string json_of(const quadrille::Report& report) {
  JsonObject json;
  json.add("facesBefore", report.faces_before);
  json.add("countedFaces", report.counted_faces);
  json.add("facesAfter", report.faces_after);
  json.add("verticesBefore", report.vertices_before);
  json.add("verticesAfter", report.vertices_after);
  json.add("contractions", report.contractions);
  json.add("componentsBefore", report.components_before);
  json.add("componentsAfter", report.components_after);
  json.add("vanishedParts", report.vanished_parts);
  json.add("largestVanishedPart", report.largest_vanished_part);
  json.add("nonManifoldEdges", report.non_manifold_edges);
  json.add("nonManifoldVertices", report.non_manifold_vertices);
  json.add("doubledFaces", report.doubled_faces);
  json.add("stop", to_string(report.stop));
  json.add("isTargetReached", is_target_reached(report.stop));
  json.add("error", report.error);
  json.add("distanceBound", report.distance_bound);
  json.add("hausdorffBound", report.hausdorff_bound);
  if (report.self_intersections)
    json.add("selfIntersections", std::array<std::size_t, 2>{report.self_intersections->before,
                                                             report.self_intersections->after});
  if (report.normal_bound_degrees)
    json.add("normalBoundDegrees", *report.normal_bound_degrees);
  json.add_raw("rejections", json_of_rejections(report));
  json.add("seconds", report.seconds.total());
  json.add("text", line_of(report));
  return json.text();
}

inline std::string json_of(const quadrille::LevelInfo& level) {
  JsonObject json;
  json.add("faces", level.faces);
  json.add("vertices", level.vertices);
  json.add("contractions", level.contractions);
  json.add("error", level.error);
  json.add("distanceBound", level.distance_bound);
  json.add("hausdorffBound", level.hausdorff_bound);
  return json.text();
}

} // namespace quadrille_examples

#endif
