#include "callbacks.h"

#include "arrays.h"

#include <pybind11/numpy.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using quadrille::SoupContraction;
using quadrille::Status;

/// Whether what a function returned is true: numpy's bool is, and a forgotten return is not.
bool truth_of(const py::object& answer, const char* name) {
  if (answer.is_none())
    throw py::value_error(std::string(name) + " returned None instead of True or False");
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0)
    throw py::error_already_set();
  return truth == 1;
}

double number_of(const py::object& answer) {
  const double cost = PyFloat_AsDouble(answer.ptr());
  if (PyErr_Occurred()) {
    PyErr_Clear();
    throw py::value_error("cost returned " + py::repr(answer).cast<std::string>() +
                          ", not a number");
  }
  if (!std::isfinite(cost) || cost < 0)
    throw py::value_error("cost returned " + py::repr(answer).cast<std::string>() +
                          ", which is negative or not finite");
  return cost;
}

Numbers<double> array_of_place(const std::array<double, 3>& place) {
  return Numbers<double>(3, place.data());
}

/// The corners of faces, of the shape (faces, 3, 3).
template <class Moving>
Numbers<double> corners_of(const SoupContraction& contraction, Moving moving) {
  std::vector<double> corners;
  for (const SoupContraction::Face& face : contraction.faces)
    for (const std::array<double, 3>* place : {&(face.*moving), &face.second, &face.third})
      corners.insert(corners.end(), place->begin(), place->end());
  const auto count = static_cast<py::ssize_t>(contraction.faces.size());
  return array_of<double>(std::move(corners), {count, 3, 3});
}

Numbers<std::int64_t> array_of_indices(const std::vector<std::size_t>& indices) {
  std::vector<std::int64_t> numbers(indices.begin(), indices.end());
  return array_of_numbers(std::move(numbers));
}

Numbers<std::int64_t> faces_of(const SoupContraction& contraction) {
  std::vector<std::size_t> indices;
  for (const SoupContraction::Face& face : contraction.faces)
    indices.push_back(face.index);
  return array_of_indices(indices);
}

template <class Class, std::array<double, 3> Class::*member>
Numbers<double> place_of(const Class& object) {
  return array_of_place(object.*member);
}

} // namespace

CostFunction cost_of(const py::object& function) {
  return [&function](const CostedPair& pair) {
    const py::gil_scoped_acquire lock;
    return number_of(function(pair));
  };
}

std::function<bool(const Status&)> stop_of(const py::object& function) {
  if (function.is_none())
    return {};
  return [&function](const Status& status) {
    const py::gil_scoped_acquire lock;
    return truth_of(function(status), "stop");
  };
}

std::function<bool(const SoupContraction&)> filter_of(const py::object& function) {
  if (function.is_none())
    return {};
  return [&function](const SoupContraction& contraction) {
    const py::gil_scoped_acquire lock;
    return truth_of(function(contraction), "filter");
  };
}

void add_callbacks(py::module_& m) {
  py::class_<CostedPair>(
      m, "Pair", "The argument of a cost function: two points that may be contracted to one.")
      .def_readonly("first_index", &CostedPair::first_index, "an index of the input's points")
      .def_readonly("second_index", &CostedPair::second_index)
      .def_property_readonly("first", place_of<CostedPair, &CostedPair::first>,
                             "its current position, of the shape (3,)")
      .def_property_readonly("second", place_of<CostedPair, &CostedPair::second>)
      .def_property_readonly("target", place_of<CostedPair, &CostedPair::target>,
                             "the position of the new point")
      .def_readonly("quadric", &CostedPair::quadric, "the cost by cost='quadric'");
  py::class_<SoupContraction>(m, "Contraction", "The argument of a filter: the next contraction.")
      .def_readonly("first", &SoupContraction::first, "one end, as an index of the input's points")
      .def_readonly("second", &SoupContraction::second)
      .def_property_readonly("target", place_of<SoupContraction, &SoupContraction::target>,
                             "the position of the new point, of the shape (3,)")
      .def_property_readonly("faces", faces_of, "the faces that change, as indices of the input's")
      .def_property_readonly(
          "before",
          [](const SoupContraction& c) { return corners_of(c, &SoupContraction::Face::before); },
          "their current corners, of the shape (faces, 3, 3), the moving corner first")
      .def_property_readonly(
          "after",
          [](const SoupContraction& c) { return corners_of(c, &SoupContraction::Face::after); },
          "their corners after the contraction")
      .def_property_readonly(
          "removed_faces",
          [](const SoupContraction& c) { return array_of_indices(c.removed_faces); },
          "the faces that are removed, as indices of the input's")
      .def_readonly("highest_degree", &SoupContraction::highest_degree,
                    "the larger number of faces at one of the two ends");
}

} // namespace quadrille_examples
