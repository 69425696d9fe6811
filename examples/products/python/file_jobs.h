#ifndef QUADRILLE_EXAMPLES_PYTHON_FILE_JOBS_H
#define QUADRILLE_EXAMPLES_PYTHON_FILE_JOBS_H

#include <pybind11/pybind11.h>

namespace quadrille_examples {

/// Surfaces from file to file, by parts: see quadrille/file.h.
void add_file_jobs(pybind11::module_& m);

} // namespace quadrille_examples

#endif
