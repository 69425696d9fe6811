// From what a file says to a mesh: polygons are triangulated, vertices welded.
#include "mesh/assemble.h"
#include "mesh/polygon_soup.h"
#include "mesh_io.h"
#include "text.h"

namespace quadrille_examples {

IndexedMesh read_mesh(const Source& source, const MeshFormat& format, Weld weld,
                      const Amount& tolerance) {
  return Assembly(format.read(source), source.path).mesh(weld, tolerance);
}

IndexedMesh read_mesh(const std::filesystem::path& path, const MeshFormat& format, Weld weld,
                      const Amount& tolerance) {
  return read_mesh(read_source(path), format, weld, tolerance);
}

IndexedMesh read_mesh(const std::filesystem::path& path, Weld weld) {
  return read_mesh(path, mesh_format(path), weld);
}

} // namespace quadrille_examples
