#ifndef QUADRILLE_INTERNAL_FACE_GRAPH_ADAPTER_H
#define QUADRILLE_INTERNAL_FACE_GRAPH_ADAPTER_H

#include <quadrille/internal/surface.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/internal/umbrellas.h>
#include <quadrille/vector.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Reads a FaceGraph into flat arrays and rewrites it from the result, each in linear time.
///
/// Vertices and faces that are left keep their descriptors. So do edges: of the edges that
/// contractions made one, one is left, and each of its halfedges still points to what became of its
/// target.
template <class Mesh, class PointMap, class VertexIndexMap>
class FaceGraphAdapter {
public:
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<PointMap>::value_type;

  FaceGraphAdapter(Mesh& mesh, PointMap points, VertexIndexMap indices)
      : mesh_(mesh), points_(points), indices_(indices) {}

  /// Throws std::invalid_argument for a face that is not a triangle and a vertex that is not
  /// finite.
  template <std::size_t N>
  SurfaceInput<N> read() {
    SurfaceInput<N> surface;
    read_vertices(surface);
    read_faces(surface);
    return surface;
  }

  /// Rewrites the mesh. `surface` tells which faces are left, of which vertices, and where they
  /// lie.
  ///
  /// Everything that can throw (memory, the user's point map) comes before the first change of the
  /// connectivity, and is taken back if it does.
  template <class Surface>
  void write(const Surface& surface) {
    collect_faces(surface.complex());
    umbrellas_.build(sides_, surface.complex().vertex_capacity(), [this](Index i, Index j) {
      return opposite(halfedges_[i], mesh_) == halfedges_[j];
    });
    choose_halfedges();
    collect_doomed(surface.complex());
    write_points(surface);
    write_connectivity();
  }

private:
  template <std::size_t N>
  void read_vertices(SurfaceInput<N>& surface) {
    const auto range = vertices(mesh_);
    std::size_t index_end = 0;
    for (Vertex v : range) {
      vertices_.push_back(v);
      index_end = std::max(index_end, static_cast<std::size_t>(get(indices_, v)) + 1);
    }
    TriangleComplex::check_size(vertices_.size(), 0);
    dense_.assign(index_end, none);
    surface.positions.resize(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      dense_[get(indices_, vertices_[i])] = static_cast<Index>(i);
      const auto& p = get(points_, vertices_[i]);
      Vector<N>& position = surface.positions[i];
      position[0] = CGAL::to_double(p.x());
      position[1] = CGAL::to_double(p.y());
      position[2] = CGAL::to_double(p.z());
      if (!is_finite(position))
        throw std::invalid_argument("quadrille::simplify: vertex " + std::to_string(i) +
                                    " is not finite");
    }
  }

  template <std::size_t N>
  void read_faces(SurfaceInput<N>& surface) {
    for (Face f : faces(mesh_)) {
      const std::array<Halfedge, 3> h = halfedges_of(f);
      if (next(h[2], mesh_) != h[0])
        throw std::invalid_argument(
            "quadrille::simplify: face " + std::to_string(surface.triangles.size()) +
            " is not a triangle; CGAL::Polygon_mesh_processing::triangulate_faces makes it so");
      surface.triangles.push_back(
          {index(target(h[0], mesh_)), index(target(h[1], mesh_)), index(target(h[2], mesh_))});
    }
    TriangleComplex::check_size(0, surface.triangles.size());
  }

  // The halfedge to each corner of a face. In write(), corner i of a face is corner i of read().
  std::array<Halfedge, 3> halfedges_of(Face f) const {
    const Halfedge h = halfedge(f, mesh_);
    const Halfedge second = next(h, mesh_);
    return {h, second, next(second, mesh_)};
  }

  Index index(Vertex v) const { return dense_[get(indices_, v)]; }

  void collect_faces(const TriangleComplex& complex) {
    Index i = 0;
    for (Face f : faces(mesh_)) {
      const Index face = i++;
      if (complex.is_dead(face)) {
        doomed_faces_.push_back(f);
        continue;
      }
      faces_.push_back(f);
      const auto& corners = complex.vertices(face);
      const auto h = halfedges_of(f);
      for (std::size_t k = 0; k < 3; ++k) {
        sides_.push_back({corners[k == 0 ? 2 : k - 1], corners[k]});
        halfedges_.push_back(h[k]);
      }
    }
  }

  // Two sides that were not mates from the beginning come from two edges: the first one's is left.
  void choose_halfedges() {
    chosen_ = halfedges_;
    for (Index side = 0; side < sides_.size(); ++side) {
      const Index mate = umbrellas_.mate(side);
      if (mate != none && side < mate)
        chosen_[mate] = opposite(chosen_[side], mesh_);
    }
  }

  void collect_doomed(const TriangleComplex& complex) {
    for (Index v = 0; v < vertices_.size(); ++v)
      if (!complex.has_faces(v))
        doomed_vertices_.push_back(vertices_[v]);
    doomed_edges_.reserve(num_edges(mesh_));
  }

  template <class Surface>
  void write_points(const Surface& surface) {
    std::vector<std::pair<Vertex, Point>> old_points;
    std::vector<Vertex> added;
    added.reserve(umbrellas_.duplicates().size());
    vertices_.reserve(vertices_.size() + umbrellas_.duplicates().size());
    try {
      for (Index v = 0; v < vertices_.size(); ++v) {
        if (!surface.complex().has_faces(v) || !surface.is_moved(v))
          continue;
        old_points.emplace_back(vertices_[v], get(points_, vertices_[v]));
        put(points_, vertices_[v], point(surface.position(v)));
      }
      for (Index original : umbrellas_.duplicates()) {
        added.push_back(add_vertex(mesh_));
        vertices_.push_back(added.back());
        put(points_, added.back(), Point(get(points_, vertices_[original])));
      }
    } catch (...) {
      for (Vertex v : added)
        remove_vertex(v, mesh_);
      for (const auto& [v, p] : old_points)
        put(points_, v, p);
      throw;
    }
  }

  static Point point(const Vector<3>& p) {
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    return Point(FT(p[0]), FT(p[1]), FT(p[2]));
  }

  void write_connectivity() {
    const Face no_face = Traits::null_face();
    for (Face f : doomed_faces_)
      for (Halfedge h : halfedges_of(f))
        set_face(h, no_face, mesh_);
    for (Halfedge h : halfedges_)
      set_face(h, no_face, mesh_);
    for (std::size_t i = 0; i < faces_.size(); ++i)
      link_face(static_cast<Index>(i));
    for (const auto& [in, out] : umbrellas_.border_links())
      set_next(opposite(chosen_[in], mesh_), opposite(chosen_[out], mesh_), mesh_);
    for (Edge e : edges(mesh_))
      if (face(halfedge(e, mesh_), mesh_) == no_face &&
          face(opposite(halfedge(e, mesh_), mesh_), mesh_) == no_face)
        doomed_edges_.push_back(e);
    for (Face f : doomed_faces_)
      remove_face(f, mesh_);
    for (Edge e : doomed_edges_)
      remove_edge(e, mesh_);
    for (Vertex v : doomed_vertices_)
      remove_vertex(v, mesh_);
  }

  // Closes the loop of a face, and makes border halfedges of the other halves of its open sides.
  void link_face(Index face) {
    const Face f = faces_[face];
    for (Index k = 0; k < 3; ++k) {
      const Index side = 3 * face + k;
      const Halfedge h = chosen_[side];
      set_face(h, f, mesh_);
      set_next(h, chosen_[3 * face + (k == 2 ? 0 : k + 1)], mesh_);
      set_target(h, vertices_[umbrellas_.vertex(side)], mesh_);
      if (!umbrellas_.is_on_border(umbrellas_.vertex(side)))
        set_halfedge(vertices_[umbrellas_.vertex(side)], h, mesh_);
      if (umbrellas_.mate(side) != none)
        continue;
      const Vertex source = vertices_[umbrellas_.vertex(3 * face + (k == 0 ? 2 : k - 1))];
      set_face(opposite(h, mesh_), Traits::null_face(), mesh_);
      set_target(opposite(h, mesh_), source, mesh_);
      set_halfedge(source, opposite(h, mesh_), mesh_);
    }
    set_halfedge(f, chosen_[3 * face], mesh_);
  }

  Mesh& mesh_;
  PointMap points_;
  VertexIndexMap indices_;
  std::vector<Vertex> vertices_;    // by the engine's index; behind them those that write() adds
  std::vector<Index> dense_;        // the engine's index by the user's, which may have gaps
  std::vector<Face> faces_;         // the faces that are left
  std::vector<Side> sides_;         // three a face: side k leads to corner k
  std::vector<Halfedge> halfedges_; // of each side before
  std::vector<Halfedge> chosen_;    // and after
  Umbrellas umbrellas_;
  std::vector<Face> doomed_faces_;
  std::vector<Edge> doomed_edges_;
  std::vector<Vertex> doomed_vertices_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FACE_GRAPH_ADAPTER_H
