// It includes <quadrille/verify.h> and <quadrille/distance.h>, which include GPL parts of CGAL.
#include "measures.h"

#include "arrays.h"
#include "interruptible.h"

#include <quadrille/distance.h>
#include <quadrille/verify.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using Points = Numbers<double>;
using Faces = Numbers<std::uint32_t>;

quadrille::SurfaceDistance distance(const Points& a, const Faces& faces_a, const Points& b,
                                    const Faces& faces_b, std::size_t samples, std::uint64_t seed) {
  const auto pa = rows<3>(a), pb = rows<3>(b);
  const auto fa = rows<3>(faces_a), fb = rows<3>(faces_b);
  const py::gil_scoped_release unlocked;
  return quadrille::surface_distance(pa, fa, pb, fb, {samples, seed});
}

quadrille::Verdict verdict(const Points& input, const Faces& input_faces, const Points& result,
                           const Faces& result_faces, const quadrille::Claims& claims) {
  const auto pa = rows<3>(input), pb = rows<3>(result);
  const auto fa = rows<3>(input_faces), fb = rows<3>(result_faces);
  const py::gil_scoped_release unlocked;
  return quadrille::verify(pa, fa, pb, fb, claims);
}

} // namespace

void add_measures(py::module_& m) {
  using quadrille::Claims;
  py::class_<Claims>(m, "Claims")
      .def(py::init<>())
      .def_readwrite("distance", &Claims::distance)
      .def_readwrite("distance_both_ways", &Claims::distance_both_ways)
      .def_readwrite("tolerances", &Claims::tolerances)
      .def_readwrite("no_self_intersection", &Claims::no_self_intersection)
      .def_readwrite("solid", &Claims::solid)
      .def_readwrite("normal_deviation", &Claims::normal_deviation)
      .def_readwrite("vertex_map", &Claims::vertex_map);
  m.def("surface_distance", [](const Points& a, const Faces& faces_a, const Points& b,
                               const Faces& faces_b, std::size_t samples, std::uint64_t seed) {
    const auto d = distance(a, faces_a, b, faces_b, samples, seed);
    return std::tuple(d.rms, d.hausdorff, d.rms_a_to_b, d.rms_b_to_a, d.hausdorff_a_to_b,
                      d.hausdorff_b_to_a);
  });
  m.def("verify", [](const Points& input, const Faces& input_faces, const Points& result,
                     const Faces& result_faces, Claims claims, py::object progress) {
    using Place = std::optional<std::array<double, 3>>;
    using Row = std::tuple<std::string, double, double, double, bool, Place>;
    Interruptible proceed(std::move(progress));
    claims.progress = [&proceed](double part) { return proceed(part); };
    quadrille::Verdict told = verdict(input, input_faces, result, result_faces, claims);
    std::vector<Row> findings;
    for (auto& f : told.findings)
      findings.emplace_back(std::move(f.claim), f.promised, f.measured, f.error, f.is_met,
                            f.place ? Place(f.place->coordinates) : Place());
    return std::pair(std::move(findings), told.is_cancelled);
  });
}

} // namespace quadrille_examples
