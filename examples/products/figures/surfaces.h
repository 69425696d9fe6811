#ifndef QUADRILLE_EXAMPLES_FIGURES_SURFACES_H
#define QUADRILLE_EXAMPLES_FIGURES_SURFACES_H

#include <quadrille/quadric_form.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

/// The surfaces of the figures: meshes and soups, read and written.

namespace figures {

namespace fs = std::filesystem;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

/// A surface that may be non-manifold.
struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// One of the models that come with CGAL.
inline Mesh read_model(const fs::path& folder, const std::string& name) {
  const std::string path = (folder / (name + ".off")).string();
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(path, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("not a triangle mesh: " + path);
  return mesh;
}

inline Soup soup_of(const Mesh& mesh) {
  Soup soup;
  std::vector<std::size_t> index(mesh.num_vertices());
  for (const Vertex v : mesh.vertices()) {
    index[v] = soup.points.size();
    soup.points.push_back(mesh.point(v));
  }
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.triangles.push_back(
        {index[mesh.target(h)], index[mesh.target(mesh.next(h))], index[mesh.source(h)]});
  }
  return soup;
}

inline void require_written(bool is_written, const fs::path& path) {
  if (!is_written)
    throw std::runtime_error("cannot write " + path.string());
}

/// As an OFF file; a mesh with a property map "v:color" as a PLY file with its colours.
inline void write(const Mesh& mesh, const fs::path& folder, const std::string& name) {
  const bool is_coloured = mesh.property_map<Vertex, CGAL::IO::Color>("v:color").second;
  const fs::path path = folder / (name + (is_coloured ? ".ply" : ".off"));
  require_written(CGAL::IO::write_polygon_mesh(path.string(), mesh), path);
}
/// Anything with points and triangles, as an OFF file.
template <class TriangleSoup>
requires requires(const TriangleSoup& soup) {
  soup.points;
  soup.triangles;
}
void write(const TriangleSoup& soup, const fs::path& folder, const std::string& name) {
  const fs::path path = folder / (name + ".off");
  require_written(CGAL::IO::write_polygon_soup(path.string(), soup.points, soup.triangles), path);
}

} // namespace figures

#endif
