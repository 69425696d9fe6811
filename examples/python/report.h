#ifndef QUADRILLE_EXAMPLES_PYTHON_REPORT_H
#define QUADRILLE_EXAMPLES_PYTHON_REPORT_H

/// \file
/// What a run tells, for Python.

#include <quadrille/report.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace quadrille_examples {

namespace py = pybind11;

/// All members in their order, as numbers, for `pickle`. A member that is new does not compile
/// here.
inline auto numbers_of(const quadrille::Status& status) {
  const auto& [initial_faces, initial_vertices, faces, vertices, initial_edges, edges, contractions,
               next_error, next_cost, next_distance, next_distance_back, next_tolerance, diagonal,
               progress, stage] = status;
  return std::tuple(initial_faces, initial_vertices, faces, vertices, initial_edges, edges,
                    contractions, next_error, next_cost, next_distance, next_distance_back,
                    next_tolerance, diagonal, progress, static_cast<int>(stage));
}

using SelfIntersections = std::optional<quadrille::Report::SelfIntersections>;
using OptionalPair = std::optional<std::array<std::size_t, 2>>;

inline OptionalPair pair_of(const SelfIntersections& counts) {
  return counts ? OptionalPair({counts->before, counts->after}) : std::nullopt;
}
inline SelfIntersections self_intersections_of(const OptionalPair& counts) {
  return counts ? SelfIntersections({(*counts)[0], (*counts)[1]}) : std::nullopt;
}

using UsedTolerance = std::optional<quadrille::Report::UsedTolerance>;
using ToleranceNumbers = std::optional<std::tuple<double, std::array<double, 3>>>;

inline ToleranceNumbers numbers_of(const UsedTolerance& used) {
  return used ? ToleranceNumbers({used->part, used->place}) : std::nullopt;
}
inline UsedTolerance used_tolerance_of(const ToleranceNumbers& used) {
  return used ? UsedTolerance({std::get<0>(*used), std::get<1>(*used)}) : std::nullopt;
}

/// The same of a report.
inline auto numbers_of(const quadrille::Report& report) {
  const auto& [faces_before, counted_faces, faces_after, vertices_before, vertices_after,
               contractions, non_edge_contractions, components_before, components_after,
               vanished_parts, non_manifold_edges, non_manifold_vertices, duplicated_vertices,
               doubled_faces, doubled_labels, stop, error, distance_bound, hausdorff_bound,
               used_tolerance, volume_before, volume_after, self_intersections,
               normal_bound_degrees, rejections, seconds] = report;
  return std::tuple(faces_before, counted_faces, faces_after, vertices_before, vertices_after,
                    contractions, non_edge_contractions, components_before, components_after,
                    vanished_parts, non_manifold_edges, non_manifold_vertices, duplicated_vertices,
                    doubled_faces, doubled_labels, static_cast<int>(stop), error, distance_bound,
                    hausdorff_bound, numbers_of(used_tolerance), volume_before, volume_after,
                    pair_of(self_intersections), normal_bound_degrees, rejections,
                    std::array{seconds.read, seconds.prepare, seconds.contract, seconds.write});
}

using StatusNumbers = decltype(numbers_of(quadrille::Status{}));
using ReportNumbers = decltype(numbers_of(quadrille::Report{}));

/// The value of an enumeration with so many. Throws if it is none.
template <class Enum>
Enum value_of(int number, int count) {
  if (number < 0 || number >= count)
    throw py::value_error("a broken pickle: " + std::to_string(number) + " names nothing");
  return static_cast<Enum>(number);
}

inline quadrille::Status status_of(const StatusNumbers& numbers) {
  const auto& [initial_faces, initial_vertices, faces, vertices, initial_edges, edges, contractions,
               next_error, next_cost, next_distance, next_distance_back, next_tolerance, diagonal,
               progress, stage] = numbers;
  return {initial_faces, initial_vertices,   faces,
          vertices,      initial_edges,      edges,
          contractions,  next_error,         next_cost,
          next_distance, next_distance_back, next_tolerance,
          diagonal,      progress,           value_of<quadrille::Stage>(stage, 3)};
}

inline quadrille::Report report_of(const ReportNumbers& numbers) {
  const auto& [faces_before, counted_faces, faces_after, vertices_before, vertices_after,
               contractions, non_edge_contractions, components_before, components_after,
               vanished_parts, non_manifold_edges, non_manifold_vertices, duplicated_vertices,
               doubled_faces, doubled_labels, stop, error, distance_bound, hausdorff_bound,
               used_tolerance, volume_before, volume_after, self_intersections,
               normal_bound_degrees, rejections, seconds] = numbers;
  return {faces_before,
          counted_faces,
          faces_after,
          vertices_before,
          vertices_after,
          contractions,
          non_edge_contractions,
          components_before,
          components_after,
          vanished_parts,
          non_manifold_edges,
          non_manifold_vertices,
          duplicated_vertices,
          doubled_faces,
          doubled_labels,
          value_of<quadrille::StopReason>(stop, 6),
          error,
          distance_bound,
          hausdorff_bound,
          used_tolerance_of(used_tolerance),
          volume_before,
          volume_after,
          self_intersections_of(self_intersections),
          normal_bound_degrees,
          rejections,
          {seconds[0], seconds[1], seconds[2], seconds[3]}};
}

inline std::string text_of(const quadrille::Report& report) {
  std::ostringstream text;
  text << report;
  return std::move(text).str();
}

inline void add_status(py::module_& m) {
  using quadrille::Status;
  py::class_<Status>(m, "Status", "What a progress function is told.")
      .def_readonly("initial_faces", &Status::initial_faces)
      .def_readonly("initial_vertices", &Status::initial_vertices)
      .def_readonly("faces", &Status::faces, "how many there are now")
      .def_readonly("vertices", &Status::vertices)
      .def_readonly("contractions", &Status::contractions)
      .def_readonly("next_error", &Status::next_error)
      .def_readonly("diagonal", &Status::diagonal, "of the input's bounding box")
      .def_readonly("progress", &Status::progress,
                    "which part is done, from 0 to 1; 1 at the end only")
      .def(py::pickle([](const Status& status) { return numbers_of(status); }, &status_of));
}

inline void add_report(py::module_& m) {
  using quadrille::Report;
  py::class_<Report> report(m, "Report", "What simplify() did. str(report) is one line.");
  report.def_readonly("faces_before", &Report::faces_before)
      .def_readonly("faces_after", &Report::faces_after)
      .def_readonly("counted_faces", &Report::counted_faces,
                    "of the input, without degenerate and doubled ones: what shares are of")
      .def_readonly("doubled_faces", &Report::doubled_faces,
                    "of the input, left out for having the corners of another one")
      .def_readonly("vertices_before", &Report::vertices_before)
      .def_readonly("vertices_after", &Report::vertices_after)
      .def_readonly("contractions", &Report::contractions, "pairs of vertices made one")
      .def_readonly("non_edge_contractions", &Report::non_edge_contractions)
      .def_readonly("components_before", &Report::components_before)
      .def_readonly("components_after", &Report::components_after)
      .def_readonly("vanished_parts", &Report::vanished_parts)
      .def_readonly("non_manifold_edges", &Report::non_manifold_edges)
      .def_readonly("non_manifold_vertices", &Report::non_manifold_vertices)
      .def_readonly("error", &Report::error,
                    "an estimate of the greatest distance, in the units of the points; no bound")
      .def_readonly("distance_bound", &Report::distance_bound,
                    "no point of the result is further from the input; infinite but with error= "
                    "and relative_error=")
      .def_readonly("hausdorff_bound", &Report::hausdorff_bound,
                    "nor any point of the input further from the result; infinite but with "
                    "both_ways=True")
      .def_property_readonly(
          "used_tolerance", [](const Report& r) { return numbers_of(r.used_tolerance); },
          "how much of its tolerance a triangle has used at most, 1 if all may be, and the middle "
          "of "
          "that triangle of the result; None but with tolerance")
      .def_property_readonly(
          "self_intersections", [](const Report& r) { return pair_of(r.self_intersections); },
          "how many pairs of faces of the input intersect, and of the result; None but with "
          "no_self_intersection=True")
      .def_readonly("volume_before", &Report::volume_before,
                    "that the input encloses; None but with hull and keep_volume")
      .def_readonly("volume_after", &Report::volume_after, "that the result encloses")
      .def_readonly(
          "normal_bound_degrees", &quadrille::Report::normal_bound_degrees,
          "no normal of the result is further from those of the input that it stands for; None but "
          "with normal_deviation")
      .def("__repr__", [](const Report& r) { return "<quadrille.Report: " + text_of(r) + '>'; })
      .def("__str__", text_of);
  report.def(py::pickle([](const Report& r) { return numbers_of(r); }, &report_of));
  report.def_property_readonly(
      "stop", [](const Report& r) { return to_string(r.stop); },
      "why it stopped: 'target met', 'target passed', 'no pair left', 'all pairs rejected', "
      "'target unreachable' or 'cancelled'");
  report.def_property_readonly(
      "is_target_reached", [](const Report& r) { return is_target_reached(r.stop); },
      "whether the target was met, or passed by a face or so");
  report.def_property_readonly(
      "seconds", [](const Report& r) { return r.seconds.total(); }, "that it took");
  report.def_property_readonly(
      "rejections",
      [](const Report& r) {
        py::dict counts;
        for (std::size_t cause = 0; cause < quadrille::rejection_causes; ++cause)
          if (r.rejections[cause] > 0)
            counts[py::str(to_string(static_cast<quadrille::Rejection>(cause)))] =
                r.rejections[cause];
        return counts;
      },
      "how many contractions were refused, by cause");
}

} // namespace quadrille_examples

#endif
