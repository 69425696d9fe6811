#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_LINKER_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_LINKER_H

#include <quadrille/internal/core/adapter/umbrellas.h>
#include <quadrille/internal/core/memory/array.h>

#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace quadrille::internal {

/// Links the faces that are left of a mesh with the halfedges that are left. It takes no memory and
/// calls nothing of the user's but the mesh.
template <class Mesh>
class FaceLinker {
public:
  using Traits = boost::graph_traits<Mesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;

  /// `halfedges`: of the three sides of each face, as the umbrellas have them.
  FaceLinker(Mesh& mesh, const Umbrellas& umbrellas, const Array<Face>& faces,
             const Array<Halfedge>& halfedges)
      : mesh_(mesh), umbrellas_(umbrellas), faces_(faces), halfedges_(halfedges) {}

  /// vertex_at(corner) is the vertex of a corner. `others` becomes a list of the edges that no face
  /// has any more; it is as long as the mesh has edges.
  template <class VertexAt>
  void link(VertexAt vertex_at, Array<Edge>& others) {
    const Face no_face = Traits::null_face();
    for (Edge e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_);
      set_face(h, no_face, mesh_);
      set_face(opposite(h, mesh_), no_face, mesh_);
    }
    for (std::size_t i = 0; i < faces_.size(); ++i)
      link_face(static_cast<Index>(i), vertex_at);
    for (const auto& [in, out] : umbrellas_.boundary_links())
      set_next(opposite(halfedges_[in], mesh_), opposite(halfedges_[out], mesh_), mesh_);
    std::size_t found = 0;
    for (Edge e : edges(mesh_)) { // without a branch, which would be hard to predict
      const Halfedge h = halfedge(e, mesh_);
      const bool has_left = face(h, mesh_) != no_face;
      const bool has_right = face(opposite(h, mesh_), mesh_) != no_face;
      others[found] = e;
      found += !(has_left | has_right);
    }
    others.resize(found);
  }

private:
  // Closes the loop of a face. The other halves of its open sides have no face: they are the
  // boundary.
  template <class VertexAt>
  void link_face(Index face, VertexAt vertex_at) {
    const Face f = faces_[face];
    for (Index k = 0; k < 3; ++k) {
      const Index side = 3 * face + k;
      const Halfedge h = halfedges_[side];
      set_face(h, f, mesh_);
      set_next(h, halfedges_[3 * face + (k == 2 ? 0 : k + 1)], mesh_);
      set_target(h, vertex_at(side), mesh_);
      if (!umbrellas_.is_on_boundary(umbrellas_.vertex(side)))
        set_halfedge(vertex_at(side), h, mesh_);
      if (umbrellas_.mate(side) != none)
        continue;
      const auto source = vertex_at(3 * face + (k == 0 ? 2 : k - 1));
      set_target(opposite(h, mesh_), source, mesh_);
      set_halfedge(source, opposite(h, mesh_), mesh_);
    }
    set_halfedge(f, halfedges_[3 * face], mesh_);
  }

  Mesh& mesh_;
  const Umbrellas& umbrellas_;
  const Array<Face>& faces_;
  const Array<Halfedge>& halfedges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_LINKER_H
