#ifndef QUADRILLE_C_REPORT_MEMBERS_H
#define QUADRILLE_C_REPORT_MEMBERS_H

#include <quadrille/report.h>

#include <string>

/// \file
/// The members of a report by name.

namespace quadrille::internal {

template <class Visit>
void visit_each(const Visit&) {}
/// Calls visit(name, member) for each pair of arguments.
template <class Visit, class Member, class... Rest>
void visit_each(const Visit& visit, const char* name, const Member& member, const Rest&... rest) {
  visit(name, member);
  visit_each(visit, rest...);
}

/// Calls visit(name, member) for all members of a report. A new member does not compile here.
template <class Visit>
void visit_members(const Report& report, const Visit& visit) {
  const auto& [faces_before, counted_faces, faces_after, vertices_before, vertices_after,
               contractions, non_edge_contractions, components_before, components_after,
               vanished_components, largest_vanished_component, joined_gaps, open_gaps, cut_handles,
               split_components, cut_distance, split_vertices, split_edges, kept_planes,
               non_manifold_edges, non_manifold_vertices, duplicated_vertices, doubled_faces,
               doubled_labels, stop, error, distance_bound, hausdorff_bound, used_tolerance,
               volume_before, volume_after, self_intersections, normal_bound_degrees, rejections,
               seconds] = report;
  visit("faces_before", faces_before);
  visit("counted_faces", counted_faces);
  visit("faces_after", faces_after);
  visit("vertices_before", vertices_before);
  visit("vertices_after", vertices_after);
  visit("contractions", contractions);
  visit("non_edge_contractions", non_edge_contractions);
  visit("components_before", components_before);
  visit("components_after", components_after);
  visit("vanished_components", vanished_components);
  visit("largest_vanished_component", largest_vanished_component);
  visit_each(visit, "joined_gaps", joined_gaps, "open_gaps", open_gaps);
  visit_each(visit, "cut_handles", cut_handles, "split_components", split_components,
             "cut_distance", cut_distance);
  visit_each(visit, "split_vertices", split_vertices, "split_edges", split_edges);
  visit("kept_planes", kept_planes);
  visit_each(visit, "non_manifold_edges", non_manifold_edges, "non_manifold_vertices",
             non_manifold_vertices, "duplicated_vertices", duplicated_vertices);
  visit_each(visit, "doubled_faces", doubled_faces, "doubled_labels", doubled_labels);
  visit("stop", stop);
  visit("is_target_reached", is_target_reached(stop));
  visit("error", error);
  visit("distance_bound", distance_bound);
  visit("hausdorff_bound", hausdorff_bound);
  visit("used_tolerance", used_tolerance);
  visit_each(visit, "volume_before", volume_before, "volume_after", volume_after);
  visit("self_intersections", self_intersections);
  visit("normal_bound_degrees", normal_bound_degrees);
  visit("rejections", rejections);
  visit("seconds", seconds);
}

/// Returns a report as an object of JSON. A number that is unknown or infinite is null.
std::string json_of(const Report& report);

} // namespace quadrille::internal

#endif // QUADRILLE_C_REPORT_MEMBERS_H
