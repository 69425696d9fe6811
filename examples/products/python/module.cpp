// The compiled part of the Python module quadrille: what quadrille/*.py calls, with arrays whose
// types and shapes have been looked at there.

#include "../mesh_io/mesh/winding.h"
#include "arrays.h"
#include "calibration.h"
#include "callbacks.h"
#include "engines.h"
#include "file_jobs.h"
#include "files.h"
#include "gltf.h"
#include "interruptible.h"
#include "levels.h"
#include "measures.h"
#include "report.h"

#include <quadrille/compiled.h>
#include <quadrille/importance.h>
#include <quadrille/levels.h>
#include <quadrille/version.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using namespace quadrille;

/// Kind, values, indices of corners or None, options.
using ChannelArrays = std::tuple<SoupChannelView::Kind, Numbers<double>,
                                 std::optional<Numbers<std::uint32_t>>, ChannelOptions>;

SoupChannelView view_of(const ChannelArrays& arrays) {
  const auto& [kind, values, triangles, options] = arrays;
  return {kind, static_cast<std::size_t>(values.shape(1)), numbers(values),
          triangles ? rows<3>(*triangles) : std::span<const std::array<std::uint32_t, 3>>(),
          options};
}

py::dict arrays_of(SoupResult result) {
  py::dict arrays;
  arrays["points"] = array_of_rows(std::move(result.points));
  arrays["faces"] = array_of_rows(std::move(result.triangles));
  arrays["labels"] = array_of_numbers(std::move(result.labels));
  arrays["input_faces"] = array_of_numbers(std::move(result.input_faces));
  const auto count = static_cast<py::ssize_t>(result.vertex_map.size());
  arrays["vertex_map"] =
      array_of<std::int64_t>(std::move(result.vertex_map), {count}); // vanished is -1
  py::list channels;
  for (SoupChannel& channel : result.channels)
    channels.append(py::make_tuple(array_of_values(std::move(channel.values), channel.components),
                                   array_of_rows(std::move(channel.triangles))));
  arrays["channels"] = channels;
  arrays["report"] = result.report;
  return arrays;
}

/// By which engines a call runs.
enum class Way { compiled, calibrated, outer_hull, inner_hull, same_volume };

/// `cost` is a function in place of a cost of the options, or None.
SoupResult simplified_by(Way way, const SoupView& soup, const SoupOptions& options,
                         const py::object& cost) {
  if (!cost.is_none())
    return soup_by_cost(soup, options, cost_of(cost));
  switch (way) {
  case Way::calibrated:
    return calibrated_soup(soup, options);
  case Way::outer_hull:
  case Way::inner_hull:
    return hull_of_soup(soup, options, way == Way::outer_hull);
  case Way::same_volume:
    return soup_of_same_volume(soup, options);
  default:
    return simplified_soup(soup, options);
  }
}

py::dict simplify_arrays(const Numbers<double>& points, const Numbers<std::uint32_t>& faces,
                         const std::optional<Numbers<std::uint32_t>>& labels,
                         const std::vector<ChannelArrays>& channels, SoupOptions options,
                         SharedLevels* levels, py::object progress, Way way, const py::object& cost,
                         const py::object& filter, const py::object& stop) {
  SoupView soup{rows<3>(points), rows<3>(faces), {}, {}};
  if (labels)
    soup.labels = numbers(*labels);
  for (const ChannelArrays& channel : channels)
    soup.channels.push_back(view_of(channel));
  Interruptible proceed(std::move(progress));
  options.proceed = [&](const Status& status) { return proceed(status); };
  options.allows = filter_of(filter);
  options.stop = stop_of(stop);
  const auto run = [&] {
    const py::gil_scoped_release unlocked;
    return simplified_by(way, soup, options, cost);
  };
  if (!levels)
    return arrays_of(run());
  return arrays_of(levels->record([&](Levels& recorded) {
    options.recorder = record_into(recorded);
    return run();
  }));
}

void add_options(py::module_& m) {
  py::class_<SoupOptions> options(m, "Options");
  options.def(py::init<>())
      .def_readwrite("faces", &SoupOptions::faces)
      .def_readwrite("ratio", &SoupOptions::ratio)
      .def_readwrite("vertices", &SoupOptions::vertices)
      .def_readwrite("error", &SoupOptions::error)
      .def_readwrite("relative_error", &SoupOptions::relative_error)
      .def_readwrite("both_ways", &SoupOptions::both_ways)
      .def_readwrite("tolerance", &SoupOptions::tolerance)
      .def_readwrite("cost", &SoupOptions::cost)
      .def_readwrite("boundary_weight", &SoupOptions::boundary_weight)
      .def_readwrite("crease_weight", &SoupOptions::crease_weight)
      .def_readwrite("crease_degrees", &SoupOptions::crease_degrees)
      .def_readwrite("weighting", &SoupOptions::weighting)
      .def_readwrite("line_weight", &SoupOptions::line_weight)
      .def_readwrite("normal_noise", &SoupOptions::normal_noise)
      .def_readwrite("position_noise", &SoupOptions::position_noise)
      .def_readwrite("placement", &SoupOptions::placement)
      .def_readwrite("order", &SoupOptions::order)
      .def_readwrite("share", &SoupOptions::share)
      .def_readwrite("refresh", &SoupOptions::refresh)
      .def_readwrite("threads", &SoupOptions::threads)
      .def_readwrite("pairs_closer_than", &SoupOptions::pairs_closer_than)
      .def_readwrite("topology", &SoupOptions::topology)
      .def_readwrite("normal_flip", &SoupOptions::normal_flip)
      .def_readwrite("no_self_intersection", &SoupOptions::no_self_intersection)
      .def_readwrite("normal_deviation", &SoupOptions::normal_deviation)
      .def_readwrite("keep_solid", &SoupOptions::keep_solid)
      .def_readwrite("coordinates_are_floats", &SoupOptions::coordinates_are_floats)
      .def_readwrite("fixed", &SoupOptions::fixed)
      .def_readwrite("importance", &SoupOptions::importance)
      .def_readwrite("selected", &SoupOptions::selected)
      .def_readwrite("region_boundary_weight", &SoupOptions::region_boundary_weight)
      .def_readwrite("split_vertices", &SoupOptions::split_vertices);
}

void add_choices(py::module_& m) {
  py::enum_<SoupOptions::Cost>(m, "Cost")
      .value("quadric", SoupOptions::Cost::quadric)
      .value("memoryless_quadric", SoupOptions::Cost::memoryless_quadric)
      .value("thin_feature_quadric", SoupOptions::Cost::thin_feature_quadric)
      .value("edge_length", SoupOptions::Cost::edge_length);
  py::enum_<Weighting>(m, "Weighting")
      .value("by_area", Weighting::by_area)
      .value("uniform", Weighting::uniform)
      .value("by_squared_area", Weighting::by_squared_area);
  py::enum_<SoupOptions::Placement>(m, "Placement")
      .value("optimal", SoupOptions::Placement::optimal)
      .value("endpoint", SoupOptions::Placement::endpoint)
      .value("midpoint", SoupOptions::Placement::midpoint);
  py::enum_<SoupOptions::Order>(m, "Order")
      .value("greedy", SoupOptions::Order::greedy)
      .value("relaxed", SoupOptions::Order::relaxed);
  py::enum_<Topology>(m, "Topology")
      .value("kept", Topology::kept)
      .value("free", Topology::free)
      .value("components_may_vanish", Topology::components_may_vanish);
}

void add_ways(py::module_& m) {
  py::enum_<Way>(m, "Way")
      .value("compiled", Way::compiled)
      .value("calibrated", Way::calibrated)
      .value("outer_hull", Way::outer_hull)
      .value("inner_hull", Way::inner_hull)
      .value("same_volume", Way::same_volume);
}

void add_channels(py::module_& m) {
  py::enum_<SoupChannelView::Kind>(m, "Kind")
      .value("texture", SoupChannelView::Kind::texture)
      .value("normals", SoupChannelView::Kind::normals)
      .value("colors", SoupChannelView::Kind::colors)
      .value("attributes", SoupChannelView::Kind::attributes);
  py::enum_<Seams>(m, "Seams")
      .value("kept", Seams::kept)
      .value("soft", Seams::soft)
      .value("priced", Seams::priced)
      .value("free", Seams::free);
  py::enum_<NewValues>(m, "NewValues")
      .value("optimal", NewValues::optimal)
      .value("weights", NewValues::weights)
      .value("existing", NewValues::existing)
      .value("recomputed", NewValues::recomputed);
  py::class_<ChannelOptions>(m, "ChannelOptions")
      .def(py::init<>())
      .def_readwrite("importance", &ChannelOptions::importance)
      .def_readwrite("weights", &ChannelOptions::weights)
      .def_readwrite("seams", &ChannelOptions::seams)
      .def_readwrite("chart_boundary_weight", &ChannelOptions::chart_boundary_weight)
      .def_readwrite("new_values", &ChannelOptions::new_values)
      .def_readwrite("linear_light", &ChannelOptions::linear_light);
}

/// Writes a mesh, and returns what could not be written.
std::string write_arrays(const std::filesystem::path& path, const WrittenArrays& arrays,
                         const IndexedMesh* source,
                         const std::optional<Numbers<std::uint32_t>>& faces) {
  const std::string extension = path.extension().string();
  const MeshFormat& format =
      is_gltf(extension) ? format_of_gltf() : mesh_format(path, " .gltf .glb");
  IndexedMesh mesh = mesh_of(arrays);
  if (source && faces)
    set_faces(mesh, *source, *faces);
  if (mesh.parts.of_faces.empty())
    set_one_chunk(mesh);
  fit_to_format(mesh, format);
  const py::gil_scoped_release unlocked;
  if (is_gltf(extension)) {
    write_gltf_mesh(path, mesh);
  } else {
    write_mesh(path, mesh, format);
  }
  return mesh.losses.text();
}

/// Which faces are wound against the others of their pieces, and how many pieces have but one side.
py::tuple winding(const Numbers<std::uint32_t>& faces, std::size_t points) {
  const Winding winding(rows<3>(faces), points);
  const std::vector<bool>& is_against = winding.is_against();
  const auto count = static_cast<py::ssize_t>(is_against.size());
  std::vector<std::uint8_t> against(is_against.begin(), is_against.end());
  return py::make_tuple(array_of<bool>(std::move(against), {count}), winding.one_sided());
}

void add_mesh_file(py::module_& m) {
  py::class_<IndexedMesh>(m, "MeshFile")
      .def_property_readonly("points", points_of)
      .def_property_readonly("faces",
                             [](const IndexedMesh& mesh) { return array_of_rows(mesh.triangles); })
      .def_property_readonly(
          "vertex_uv",
          [](const IndexedMesh& mesh) { return array_of_rows(mesh.texture_coordinates); })
      .def_property_readonly(
          "uv", [](const IndexedMesh& mesh) { return corners_of(mesh.corner_textures); })
      .def_property_readonly(
          "normals", [](const IndexedMesh& mesh) { return corners_of(mesh.corner_normals); })
      .def_property_readonly("colors", colors_of)
      .def_property_readonly("labels", labels_of)
      .def_property_readonly("vertex_numbers", vertex_numbers_of)
      .def_property_readonly("remarks",
                             [](const IndexedMesh& mesh) {
                               std::vector<std::string> remarks = mesh.remarks;
                               if (!mesh.losses.empty())
                                 remarks.push_back("not kept: " + mesh.losses.text());
                               return remarks;
                             })
      .def("__deepcopy__", [](py::object self, const py::dict&) { return self; }) // it is constant
      .def(py::pickle(&FileNumbers::of, &FileNumbers::mesh));
}

void add_written_arrays(py::module_& m) {
  py::class_<WrittenArrays>(m, "WrittenArrays")
      .def(py::init([](Numbers<double> points, Numbers<std::uint32_t> faces) {
        return WrittenArrays{std::move(points), std::move(faces), {}, {}, {}, false, {}};
      }))
      .def_readwrite("uv", &WrittenArrays::uv)
      .def_readwrite("normals", &WrittenArrays::normals)
      .def_readwrite("colors", &WrittenArrays::colors)
      .def_readwrite("has_alpha", &WrittenArrays::has_alpha)
      .def_readwrite("vertex_numbers", &WrittenArrays::vertex_numbers);
}

/// Maps of importance, one number for each point.
void add_importance(py::module_& m) {
  using Points = Numbers<double>;
  using Faces = Numbers<std::uint32_t>;
  m.def("curvature_importance", [](const Points& points, const Faces& faces, double strength) {
    return array_of_numbers(curvature_importance(rows<3>(points), rows<3>(faces), {strength}));
  });
  m.def("view_importance",
        [](const Points& points, const Faces& faces, const std::array<double, 3>& eye,
           double turned_away, double outline) {
          return array_of_numbers(
              view_importance(rows<3>(points), rows<3>(faces), {{eye}, turned_away, outline}));
        });
}

void add_files(py::module_& m) {
  add_mesh_file(m);
  add_written_arrays(m);
  m.def(
      "read_mesh",
      [](const std::filesystem::path& path, bool welds) {
        IndexedMesh mesh = is_gltf(path.extension().string())
                               ? read_gltf_mesh(path)
                               : read_mesh(path, mesh_format(path, " .gltf .glb"),
                                           welds ? Weld::places : Weld::surfaces);
        const bool has_seams = !mesh.value_triangles.empty(); // at which points are there twice
        return std::pair(with_vertices_of_values(std::move(mesh)), has_seams);
      },
      py::call_guard<py::gil_scoped_release>());
  m.def("write_mesh", write_arrays);
  m.def("winding", winding);
}

} // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of the module quadrille.";
  m.attr("version") = std::to_string(QUADRILLE_VERSION_MAJOR) + '.' +
                      std::to_string(QUADRILLE_VERSION_MINOR) + '.' +
                      std::to_string(QUADRILLE_VERSION_PATCH);
#ifdef QUADRILLE_WITH_TBB
  m.attr("has_threads") = true;
#else
  m.attr("has_threads") = false;
#endif
  add_options(m);
  add_choices(m);
  add_ways(m);
  add_channels(m);
  add_status(m);
  add_report(m);
  add_levels(m);
  add_importance(m);
  add_files(m);
  add_measures(m);
  add_callbacks(m);
  add_file_jobs(m);
#ifdef QUADRILLE_PYTHON_WITH_GLTF
  add_gltf(m);
#endif
  m.def("simplify", simplify_arrays);
}

} // namespace quadrille_examples
