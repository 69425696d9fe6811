#ifndef QUADRILLE_EXAMPLES_WEB_JSON_H
#define QUADRILLE_EXAMPLES_WEB_JSON_H

#include "../mesh_io/json_object.h"

#include <quadrille/levels.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace quadrille_examples {

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
  json.add("vanishedComponents", report.vanished_components);
  json.add("joinedGaps", report.joined_gaps);
  json.add("openGaps", report.open_gaps);
  json.add("cutHandles", report.cut_handles);
  json.add("splitComponents", report.split_components);
  json.add("cutDistance", report.cut_distance);
  json.add("largestVanishedComponent", report.largest_vanished_component);
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
