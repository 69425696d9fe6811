#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_6_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_6_H

#include "generate.h"
#include "measures.h"
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/distance.h>
#include <quadrille/simplify.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace figures {

using Texture = std::array<double, 2>;
using TextureMap = Mesh::Property_map<Vertex, Texture>;

inline TextureMap texture(Mesh& mesh) {
  return mesh.add_property_map<Vertex, Texture>("v:texture").first;
}

/// A terrain of 3,872 faces. Its texture lies on it as a cloth would: u and v grow with the way
/// that one has to walk over hill and dale, from 0 to 1 on each row and on each column.
inline Mesh terrain() {
  constexpr std::size_t squares = 44, row = squares + 1;
  Mesh mesh;
  const auto vertices = add_grid(mesh, squares, squares, [](double s, double t) {
    const auto hill = [&](double x, double y, double width) {
      return std::exp(-(std::pow(s - x, 2) + std::pow(t - y, 2)) / (width * width));
    };
    return Point(s, t,
                 0.35 * hill(0.3, 0.35, 0.16) + 0.25 * hill(0.7, 0.65, 0.2) -
                     0.12 * hill(0.65, 0.2, 0.15) + 0.1 * hill(0.2, 0.8, 0.1));
  });
  const TextureMap map = texture(mesh);
  const auto walk = [&](std::size_t first, std::size_t step, std::size_t axis) {
    double way = 0;
    for (std::size_t i = 0; i <= squares; ++i) {
      const Vertex v = vertices[first + i * step];
      if (i > 0)
        way += std::sqrt(
            CGAL::squared_distance(mesh.point(vertices[first + (i - 1) * step]), mesh.point(v)));
      map[v][axis] = way;
    }
    for (std::size_t i = 0; i <= squares; ++i)
      map[vertices[first + i * step]][axis] /= way;
  };
  for (std::size_t i = 0; i <= squares; ++i) {
    walk(i * row, 1, 0);
    walk(i, row, 1);
  }
  return mesh;
}

/// The terrain, 3,872 → 53 faces: texture coordinates in the quadric against interpolated ones.
struct Figure6 {
  struct Result {
    Mesh mesh;
    double texture_rms;
    double rms; ///< of the distance to the original, of its diagonal
  };
  Mesh original;
  Result by_quadric, by_texture_quadric;

  explicit Figure6(const fs::path& /*models*/) : original(terrain()) {
    using namespace quadrille;
    const Field<2> field(original, texture(original));
    const auto measured = [&](Mesh& mesh) -> Result {
      mesh.collect_garbage();
      const double texture_rms = rms_difference(field, Field<2>(mesh, texture(mesh)));
      const double rms = surface_distance(original, mesh).rms / bounding_box_diagonal(original);
      return {std::move(mesh), texture_rms, rms};
    };
    Mesh mesh = original;
    simplify<Quadric, OptimalPlacement>(mesh, FaceCount{faces});
    transfer(field, mesh, texture(mesh));
    by_quadric = measured(mesh);
    mesh = original;
    simplify<TextureQuadric, OptimalPlacement>(mesh, FaceCount{faces},
                                               CGAL::parameters::vertex_texture_map(texture(mesh)));
    by_texture_quadric = measured(mesh);
  }

  void print() const {
    std::printf("                   faces    RMS of texture coordinates    RMS, %% of diagonal\n");
    print_row("Quadric", by_quadric);
    print_row("TextureQuadric", by_texture_quadric);
  }

  void write(const fs::path& folder) const {
    figures::write(original, folder, "6_terrain");
    figures::write(by_quadric.mesh, folder, "6_terrain_53_quadric");
    figures::write(by_texture_quadric.mesh, folder, "6_terrain_53_texture_quadric");
  }

private:
  static constexpr std::size_t faces = 53;

  static void print_row(const char* cost, const Result& result) {
    std::printf("%-16s %7u %20.5f %28.4f\n", cost, result.mesh.number_of_faces(),
                result.texture_rms, 100 * result.rms);
  }
};

} // namespace figures

#endif
