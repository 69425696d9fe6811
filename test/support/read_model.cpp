// A translation unit of its own, as the readers of CGAL take long to compile.
#include "meshes.h"

#include <CGAL/boost/graph/IO/OFF.h>

#include <stdexcept>

test::Mesh test::read_model(const std::string& name) {
  Mesh mesh;
  if (!CGAL::IO::read_OFF(CGAL::data_file_path("meshes/" + name + ".off"), mesh))
    throw std::runtime_error(name + ".off cannot be read");
  return mesh;
}
