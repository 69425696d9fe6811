#ifndef QUADRILLE_EXAMPLES_PYTHON_REPORT_H
#define QUADRILLE_EXAMPLES_PYTHON_REPORT_H

/// \file
/// What a run tells, for Python.

#include <quadrille/report.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace quadrille_examples {

namespace py = pybind11;

/// All members in their order, as numbers, for `pickle`. A member that is new does not compile
/// here.
inline auto numbers_of(const quadrille::Status& status) {
  const auto& [initial_faces, initial_vertices, faces, vertices, initial_edges, edges, contractions,
               next_error, next_cost, next_distance, next_reverse_distance, next_tolerance,
               diagonal, progress, stage] = status;
  return std::tuple(initial_faces, initial_vertices, faces, vertices, initial_edges, edges,
                    contractions, next_error, next_cost, next_distance, next_reverse_distance,
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
  return used ? ToleranceNumbers({used->fraction, used->place}) : std::nullopt;
}
inline UsedTolerance used_tolerance_of(const ToleranceNumbers& used) {
  return used ? UsedTolerance({std::get<0>(*used), std::get<1>(*used)}) : std::nullopt;
}

using StatusNumbers = decltype(numbers_of(quadrille::Status{}));

/// The value of an enumeration with so many. Throws if it is none.
template <class Enum>
Enum value_of(int number, int count) {
  if (number < 0 || number >= count)
    throw py::value_error("a broken pickle: " + std::to_string(number) + " has no entry");
  return static_cast<Enum>(number);
}

inline quadrille::Status status_of(const StatusNumbers& numbers) {
  const auto& [initial_faces, initial_vertices, faces, vertices, initial_edges, edges, contractions,
               next_error, next_cost, next_distance, next_reverse_distance, next_tolerance,
               diagonal, progress, stage] = numbers;
  return {initial_faces,
          initial_vertices,
          faces,
          vertices,
          initial_edges,
          edges,
          contractions,
          next_error,
          next_cost,
          next_distance,
          next_reverse_distance,
          next_tolerance,
          diagonal,
          progress,
          value_of<quadrille::Stage>(stage, 3)};
}

/// A bound, or None where it is infinite: JSON has no infinity.
inline std::optional<double> finite(double bound) {
  return std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}
inline double bound_of(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::infinity());
}

inline py::dict counts_of(const std::array<std::size_t, quadrille::rejection_causes>& rejections) {
  py::dict counts;
  for (std::size_t cause = 0; cause < rejections.size(); ++cause)
    if (rejections[cause] > 0)
      counts[py::str(to_string(static_cast<quadrille::Rejection>(cause)))] = rejections[cause];
  return counts;
}

/// All of a report by name, as JSON can have it. A member that is new does not compile here.
inline py::dict dict_of(const quadrille::Report& report) {
  using namespace py::literals;
  const auto& [faces_before, counted_faces, faces_after, vertices_before, vertices_after,
               contractions, non_edge_contractions, components_before, components_after,
               vanished_components, largest_vanished_component, non_manifold_edges,
               non_manifold_vertices, duplicated_vertices, doubled_faces, doubled_labels, stop,
               error, distance_bound, hausdorff_bound, used_tolerance, volume_before, volume_after,
               self_intersections, normal_bound_degrees, rejections, seconds] = report;
  return py::dict(
      "faces_before"_a = faces_before, "counted_faces"_a = counted_faces,
      "faces_after"_a = faces_after, "vertices_before"_a = vertices_before,
      "vertices_after"_a = vertices_after, "contractions"_a = contractions,
      "non_edge_contractions"_a = non_edge_contractions, "components_before"_a = components_before,
      "components_after"_a = components_after, "vanished_components"_a = vanished_components,
      "largest_vanished_component"_a = largest_vanished_component,
      "non_manifold_edges"_a = non_manifold_edges,
      "non_manifold_vertices"_a = non_manifold_vertices,
      "duplicated_vertices"_a = duplicated_vertices, "doubled_faces"_a = doubled_faces,
      "doubled_labels"_a = doubled_labels, "stop"_a = to_string(stop),
      "is_target_reached"_a = is_target_reached(stop), "error"_a = error,
      "distance_bound"_a = finite(distance_bound), "hausdorff_bound"_a = finite(hausdorff_bound),
      "used_tolerance"_a = numbers_of(used_tolerance), "volume_before"_a = volume_before,
      "volume_after"_a = volume_after, "self_intersections"_a = pair_of(self_intersections),
      "normal_bound_degrees"_a = normal_bound_degrees, "rejections"_a = counts_of(rejections),
      "seconds"_a = py::dict("read"_a = seconds.read, "prepare"_a = seconds.prepare,
                             "contract"_a = seconds.contract, "write"_a = seconds.write));
}

/// The value of an enumeration with so many that has this name. Throws if none has.
template <class Enum>
Enum named(std::string_view name, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (to_string(static_cast<Enum>(i)) == name)
      return static_cast<Enum>(i);
  throw py::value_error("not a report: it has the unknown name '" + std::string(name) + "'");
}

/// What a dict has by a name. Throws if that is missing, or something else.
template <class T>
T member(const py::dict& dict, const char* name) {
  if (!dict.contains(name))
    throw py::value_error(std::string("not a report: it has no ") + name);
  try {
    return dict[name].cast<T>();
  } catch (const py::cast_error&) {
    throw py::value_error(std::string("not a report: its ") + name + " is " +
                          py::repr(dict[name]).cast<std::string>());
  }
}

inline quadrille::Report::Seconds seconds_of(const py::dict& dict) {
  const auto second = [&](const char* name) { return member<double>(dict, name); };
  return {second("read"), second("prepare"), second("contract"), second("write")};
}

/// The inverse of dict_of. Throws for what is none of these.
inline quadrille::Report report_of(const py::dict& dict) {
  const auto count = [&](const char* name) { return member<std::size_t>(dict, name); };
  const auto real = [&](const char* name) { return member<std::optional<double>>(dict, name); };
  quadrille::Report report{count("faces_before"),
                           count("counted_faces"),
                           count("faces_after"),
                           count("vertices_before"),
                           count("vertices_after"),
                           count("contractions"),
                           count("non_edge_contractions"),
                           count("components_before"),
                           count("components_after"),
                           count("vanished_components"),
                           member<double>(dict, "largest_vanished_component"),
                           count("non_manifold_edges"),
                           count("non_manifold_vertices"),
                           count("duplicated_vertices"),
                           count("doubled_faces"),
                           count("doubled_labels"),
                           named<quadrille::StopReason>(member<std::string>(dict, "stop"), 6),
                           member<double>(dict, "error"),
                           bound_of(real("distance_bound")),
                           bound_of(real("hausdorff_bound")),
                           used_tolerance_of(member<ToleranceNumbers>(dict, "used_tolerance")),
                           real("volume_before"),
                           real("volume_after"),
                           self_intersections_of(member<OptionalPair>(dict, "self_intersections")),
                           real("normal_bound_degrees"),
                           {},
                           seconds_of(member<py::dict>(dict, "seconds"))};
  for (const auto& [cause, times] : member<std::map<std::string, std::size_t>>(dict, "rejections"))
    report.rejections[static_cast<std::size_t>(
        named<quadrille::Rejection>(cause, quadrille::rejection_causes))] = times;
  return report;
}

inline std::string text_of(const quadrille::Report& report) {
  std::ostringstream text;
  text << report;
  return std::move(text).str();
}

inline void add_status(py::module_& m) {
  using quadrille::Status;
  py::class_<Status>(m, "Status", "The argument of a progress function.")
      .def_readonly("initial_faces", &Status::initial_faces)
      .def_readonly("initial_vertices", &Status::initial_vertices)
      .def_readonly("faces", &Status::faces, "the current number of faces")
      .def_readonly("vertices", &Status::vertices)
      .def_readonly("contractions", &Status::contractions)
      .def_readonly("next_error", &Status::next_error)
      .def_readonly("diagonal", &Status::diagonal, "the diagonal of the input's bounding box")
      .def_readonly("progress", &Status::progress,
                    "the completed fraction, from 0 to 1; 1 only at the end")
      .def(py::pickle([](const Status& status) { return numbers_of(status); }, &status_of));
}

inline void add_dicts(py::class_<quadrille::Report>& report) {
  using quadrille::Report;
  const auto json = [](const char* name) { return py::module_::import("json").attr(name); };
  report.def(py::pickle([](const Report& r) { return dict_of(r); }, &report_of))
      .def(
          "to_dict", [](const Report& r) { return dict_of(r); },
          "Returns all figures by name, as values that JSON can represent: an infinite bound "
          "is None, and seconds are given by phase.")
      .def_static("from_dict", report_of, "Returns the report that to_dict() has converted.")
      .def(
          "to_json", [=](const Report& r) { return json("dumps")(dict_of(r)); },
          "Returns to_dict() as a JSON str.")
      .def_static(
          "from_json", [=](const py::str& text) { return report_of(json("loads")(text)); },
          "Returns the report that to_json() has converted.")
      .def("keys", [](const Report& r) { return dict_of(r).attr("keys")(); })
      .def("__getitem__",
           [](const Report& r, const char* name) { return dict_of(r).attr("__getitem__")(name); })
      .def("__eq__", [](const Report& a, const py::object& b) {
        return py::isinstance<Report>(b) && dict_of(a).equal(dict_of(b.cast<const Report&>()));
      });
}

inline void add_report(py::module_& m) {
  using quadrille::Report;
  py::class_<Report> report(m, "Report", "What simplify() did. str(report) is one line.");
  report.def_readonly("faces_before", &Report::faces_before)
      .def_readonly("faces_after", &Report::faces_after)
      .def_readonly(
          "counted_faces", &Report::counted_faces,
          "the faces of the input without degenerate and duplicate ones; ratios refer to them")
      .def_readonly("doubled_faces", &Report::doubled_faces,
                    "the faces of the input that were left out as duplicates")
      .def_readonly("vertices_before", &Report::vertices_before)
      .def_readonly("vertices_after", &Report::vertices_after)
      .def_readonly("contractions", &Report::contractions, "the number of contracted pairs")
      .def_readonly("non_edge_contractions", &Report::non_edge_contractions)
      .def_readonly("components_before", &Report::components_before)
      .def_readonly("components_after", &Report::components_after)
      .def_readonly("vanished_components", &Report::vanished_components,
                    "the number of components that were removed entirely")
      .def_readonly("largest_vanished_component", &Report::largest_vanished_component,
                    "the diagonal of the bounding box of the largest removed component")
      .def_readonly("non_manifold_edges", &Report::non_manifold_edges)
      .def_readonly("non_manifold_vertices", &Report::non_manifold_vertices)
      .def_readonly("error", &Report::error,
                    "an estimate of the largest distance, in the units of the points; not a bound")
      .def_readonly("distance_bound", &Report::distance_bound,
                    "no point of the result is further from the input; infinite without error= or "
                    "relative_error=")
      .def_readonly(
          "hausdorff_bound", &Report::hausdorff_bound,
          "no point of the input is further from the result, or the other way round; infinite "
          "without both_ways=True")
      .def_property_readonly(
          "used_tolerance", [](const Report& r) { return numbers_of(r.used_tolerance); },
          "the largest fraction of its tolerance that a triangle may have used, and the centre "
          "of that triangle in the result; None without tolerance")
      .def_property_readonly(
          "self_intersections", [](const Report& r) { return pair_of(r.self_intersections); },
          "the numbers of intersecting pairs of faces in the input and in the result; None "
          "without no_self_intersection=True")
      .def_readonly("volume_before", &Report::volume_before,
                    "the volume that the input encloses; None without hull or keep_volume")
      .def_readonly("volume_after", &Report::volume_after, "the volume that the result encloses")
      .def_readonly(
          "normal_bound_degrees", &quadrille::Report::normal_bound_degrees,
          "no normal of the result deviates by more than this from the normals of the input "
          "that it replaces; None without normal_deviation")
      .def("__repr__", [](const Report& r) { return "<quadrille.Report: " + text_of(r) + '>'; })
      .def("__str__", text_of);
  add_dicts(report);
  report.def_property_readonly(
      "stop", [](const Report& r) { return to_string(r.stop); },
      "why it stopped: 'target met', 'target passed', 'no pair left', 'all pairs rejected', "
      "'target unreachable' or 'cancelled'");
  report.def_property_readonly(
      "is_target_reached", [](const Report& r) { return is_target_reached(r.stop); },
      "whether the target was met, exactly or almost");
  report.def_property_readonly(
      "seconds", [](const Report& r) { return r.seconds.total(); }, "the duration of the call");
  report.def_property_readonly(
      "rejections", [](const Report& r) { return counts_of(r.rejections); },
      "the number of rejected contractions, by cause");
}

} // namespace quadrille_examples

#endif
