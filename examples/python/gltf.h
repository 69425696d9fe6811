#ifndef QUADRILLE_EXAMPLES_PYTHON_GLTF_H
#define QUADRILLE_EXAMPLES_PYTHON_GLTF_H

/// \file
/// glTF documents for Python.

#include <pybind11/pybind11.h>

namespace quadrille_examples {

void add_gltf(pybind11::module_& m);

} // namespace quadrille_examples

#endif
