#ifndef QUADRILLE_EXAMPLES_PYTHON_ARRAYS_H
#define QUADRILLE_EXAMPLES_PYTHON_ARRAYS_H

/// \file
/// Arrays of numpy as spans, and vectors as arrays, neither of which copies.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace py = pybind11;

/// An array in the order of C. What is passed as one has its type already: see _arrays.py.
template <class Number>
using Numbers = py::array_t<Number, py::array::c_style>;

/// The rows of an array of N columns.
template <std::size_t N, class Number>
std::span<const std::array<Number, N>> rows(const Numbers<Number>& array) {
  static_assert(sizeof(std::array<Number, N>) == N * sizeof(Number));
  return {reinterpret_cast<const std::array<Number, N>*>(array.data()),
          static_cast<std::size_t>(array.shape(0))};
}

template <class Number>
std::span<const Number> numbers(const Numbers<Number>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// A vector as an array of a shape, which owns it from then on.
template <class Number, class Value>
Numbers<Number> array_of(std::vector<Value> values, std::vector<py::ssize_t> shape) {
  static_assert(sizeof(Value) % sizeof(Number) == 0);
  auto owner = std::make_unique<std::vector<Value>>(std::move(values));
  const auto* const data = reinterpret_cast<const Number*>(owner->data());
  const py::capsule holder(
      owner.get(), [](void* p) { delete static_cast<typename decltype(owner)::pointer>(p); });
  owner.release();
  return Numbers<Number>(std::move(shape), data, holder);
}

template <class Number, std::size_t N>
Numbers<Number> array_of_rows(std::vector<std::array<Number, N>> values) {
  const auto count = static_cast<py::ssize_t>(values.size());
  return array_of<Number>(std::move(values), {count, static_cast<py::ssize_t>(N)});
}

template <class Number>
Numbers<Number> array_of_numbers(std::vector<Number> values) {
  const auto count = static_cast<py::ssize_t>(values.size());
  return array_of<Number>(std::move(values), {count});
}

/// Values of so many components each.
inline Numbers<double> array_of_values(std::vector<double> values, std::size_t components) {
  const auto count = static_cast<py::ssize_t>(values.size() / components);
  return array_of<double>(std::move(values), {count, static_cast<py::ssize_t>(components)});
}

} // namespace quadrille_examples

#endif
