#ifndef QUADRILLE_EXAMPLES_PYTHON_MEASURES_H
#define QUADRILLE_EXAMPLES_PYTHON_MEASURES_H

/// \file
/// What can be measured of two surfaces, for Python.

#include <pybind11/pybind11.h>

namespace quadrille_examples {

void add_measures(pybind11::module_& m);

} // namespace quadrille_examples

#endif
