#ifndef QUADRILLE_TEST_TEXTURED_MESHES_H
#define QUADRILLE_TEST_TEXTURED_MESHES_H

#include "meshes.h"
#include "textured.h"

#include <quadrille/quadric_form.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <map>

/// \file
/// Textured surfaces as meshes, with maps over halfedges and faces that look at no handle.

namespace test {

/// Calls visit(corner of the face's triangle, halfedge) for the three halfedges of a face, each of
/// which stands for the corner that it points to.
template <class M, class Visit>
void for_each_corner(const M& mesh, typename boost::graph_traits<M>::face_descriptor face,
                     Visit visit) {
  auto h = halfedge(face, mesh);
  for (std::size_t i = 0; i < 3; ++i, h = next(h, mesh))
    visit(i, h);
}

template <class M>
struct TexturedMesh {
  using Halfedge = typename boost::graph_traits<M>::halfedge_descriptor;
  using Face = typename boost::graph_traits<M>::face_descriptor;

  M mesh;
  std::map<Halfedge, TexturePlace> texture; ///< at halfedges without a face it is not a number
  std::map<Face, int> labels;

  /// Vertex i is point i, face i is triangle i.
  explicit TexturedMesh(const Textured& surface) : mesh(make_mesh<M>(surface.soup)) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    for (const auto h : halfedges(mesh))
      texture[h] = {{nothing, nothing}};
    std::map<typename boost::graph_traits<M>::vertex_descriptor, std::uint32_t> number;
    for (const auto v : vertices(mesh))
      number.emplace(v, static_cast<std::uint32_t>(number.size()));
    std::size_t t = 0;
    for (const auto f : faces(mesh)) {
      for_each_corner(mesh, f, [&](std::size_t, Halfedge h) {
        const Triangle& corners = surface.soup.triangles[t];
        for (std::size_t i = 0; i < 3; ++i)
          if (corners[i] == number.at(target(h, mesh)))
            texture[h] = surface.texture[t][i];
      });
      labels[f] = surface.labels[t++];
    }
  }
  TexturedMesh(const TexturedMesh&) = delete; // the maps would speak of the other mesh
  TexturedMesh& operator=(const TexturedMesh&) = delete;

  Textured surface() const {
    Textured result{to_soup(mesh), {}, {}};
    for (const auto f : faces(mesh)) {
      std::array<TexturePlace, 3>& places = result.texture.emplace_back();
      for_each_corner(mesh, f, [&](std::size_t i, Halfedge h) { places[i] = texture.at(h); });
      result.labels.push_back(labels.at(f));
    }
    return result;
  }

  auto texture_map() { return boost::make_assoc_property_map(texture); }
  auto label_map() { return boost::make_assoc_property_map(labels); }
};

} // namespace test

#endif // QUADRILLE_TEST_TEXTURED_MESHES_H
