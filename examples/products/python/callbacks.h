#ifndef QUADRILLE_EXAMPLES_PYTHON_CALLBACKS_H
#define QUADRILLE_EXAMPLES_PYTHON_CALLBACKS_H

/// \file
/// Policies that are functions of Python. They are called with the lock of the interpreter, which a
/// call does not need to have; what they raise ends a simplification. The objects have to live as
/// long as what is made of them.

#include "engines.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <pybind11/pybind11.h>

#include <functional>

namespace quadrille_examples {

CostFunction cost_of(const pybind11::object& function);
std::function<bool(const quadrille::Status&)> stop_of(const pybind11::object& function);
std::function<bool(const quadrille::SoupContraction&)> filter_of(const pybind11::object& function);

/// The classes of what functions are given.
void add_callbacks(pybind11::module_& m);

} // namespace quadrille_examples

#endif
