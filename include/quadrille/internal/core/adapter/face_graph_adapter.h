#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_ADAPTER_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_ADAPTER_H

#include <quadrille/internal/core/adapter/attributes.h>
#include <quadrille/internal/core/adapter/face_graph_writer.h>
#include <quadrille/internal/core/adapter/named_edges.h>
#include <quadrille/internal/core/adapter/no_channel_maps.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace quadrille::internal {

/// The vertices of a mesh, counted off in its order: the engine's numbers, whatever gaps the user's
/// have.
template <class Mesh, class VertexIndexMap>
class VertexNumbers {
public:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

  explicit VertexNumbers(VertexIndexMap indices, Arena* arena = nullptr)
      : indices_(indices), vertices_(arena), places_(arena) {}

  void read(const Mesh& mesh) {
    vertices_.clear();
    places_.clear();
    vertices_.reserve(num_vertices(mesh));
    std::size_t index_end = 0;
    bool is_dense = true;
    for (Vertex v : vertices(mesh)) {
      const auto i = static_cast<std::size_t>(get(indices_, v));
      is_dense &= i == vertices_.size();
      index_end = (std::max)(index_end, i + 1);
      vertices_.push_back(v);
    }
    TriangleComplex::check_size(vertices_.size(), 0);
    if (is_dense)
      return;
    places_.assign(index_end, none);
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      places_[get(indices_, vertices_[i])] = static_cast<Index>(i);
  }
  /// Releases memory that read() can fill again.
  void release() {
    vertices_ = Array<Vertex>(vertices_.get_allocator());
    places_ = Array<Index>(places_.get_allocator());
  }

  /// One more, of which index() is not asked, and its number.
  Index add(Vertex v) {
    vertices_.push_back(v);
    return static_cast<Index>(vertices_.size() - 1);
  }

  std::size_t size() const { return vertices_.size(); }
  Vertex operator[](std::size_t number) const { return vertices_[number]; }
  Index index(Vertex v) const {
    const auto i = static_cast<std::size_t>(get(indices_, v));
    return places_.empty() ? static_cast<Index>(i) : places_[i];
  }

private:
  VertexIndexMap indices_;
  Array<Vertex> vertices_;
  Array<Index> places_; // by the user's numbers; empty if these are the same
};

/// Reads a FaceGraph into flat arrays and rewrites it from the result, each in linear time.
///
/// Vertices and faces that are left keep their descriptors. So do edges: of the edges that
/// contractions made one, one is left, and each of its halfedges still points to what became of its
/// target.
template <class Mesh, class PointMap, class VertexIndexMap, class Attributes = NoAttributes,
          class Maps = std::tuple<>>
class FaceGraphAdapter {
public:
  static constexpr std::size_t dimension = 3 + Attributes::size;
  using Input = InputOf<dimension, has_channels_in<Maps>>;
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;

  FaceGraphAdapter(Mesh& mesh, PointMap points, VertexIndexMap indices, Attributes attributes,
                   Arena& arena, Maps channels = {})
      : arena_(&arena), mesh_(mesh), points_(points), vertices_(indices, &arena),
        attributes_(attributes), channels_(std::move(channels)) {}

  /// Throws std::invalid_argument for a face that is not a triangle and a vertex that is not
  /// finite.
  Input read() {
    Input surface(arena_);
    vertices_.read(mesh_);
    surface.reserve(vertices_.size(), num_faces(mesh_));
    read_vertices(surface);
    read_faces(surface);
    if constexpr (Attributes::size > 0)
      attributes_.limit(surface);
    if constexpr (has_channels_in<Maps>)
      channels_.read(mesh_, vertices_, *arena_, surface);
    return surface;
  }
  /// Releases memory that write() can fill again.
  void release() { vertices_.release(); }

  /// Calls visit(v, value, i) for the value that a map has of the i-th vertex of the user's, which
  /// is the vertex v of the surface.
  template <class Map, class Visit>
  void for_each_value(Map map, Visit visit) const {
    for (Index v = 0; v < vertices_.size(); ++v)
      visit(v, get(map, vertices_[v]), v);
  }

  /// Fixes the ends of the edges of which get(map, edge) is true, and has these edges left by
  /// write().
  template <class Map>
  void fix_edges(Map map, SurfaceInput<dimension>& surface) {
    for_each_edge_in(map, [&](Edge e, Index v, Index w) {
      surface.fix(v);
      surface.fix(w);
      named_edges_.add(v, w, e, true);
    });
    named_edges_.sort();
  }

  /// Makes creases of the edges of which get(map, edge) is true.
  template <class Map>
  void name_creases(Map map, SurfaceInput<dimension>& surface) const {
    for_each_edge_in(map, [&](Edge, Index v, Index w) { surface.creases.push_back({v, w}); });
  }

  /// Rewrites the mesh. `result` gives the remaining faces, their vertices, and the positions of
  /// these.
  ///
  /// Everything that can throw (memory, the user's maps) comes before the first change of the
  /// connectivity, and is undone if it does. It calls `reporter` as described for Reporter. Returns
  /// how many vertices it had to duplicate.
  template <class Result, class AnyReporter>
  std::size_t write(const Result& result, AnyReporter reporter) {
    vertices_.read(mesh_);
    return FaceGraphWriter(mesh_, points_, vertices_, attributes_, channels_, named_edges_, arena_)
        .write(result, reporter);
  }

private:
  template <class Map, class Visit>
  void for_each_edge_in(Map map, Visit visit) const {
    for (Edge e : edges(mesh_))
      if (get(map, e))
        visit(e, vertices_.index(source(e, mesh_)), vertices_.index(target(e, mesh_)));
  }

  void read_vertices(SurfaceInput<dimension>& surface) {
    surface.positions.resize(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      surface.positions[i] = read_position(vertices_[i]);
      require_finite(surface.positions[i], i);
    }
  }

  Vector<dimension> read_position(Vertex v) {
    const Vector<3> position = position_of(get(points_, v));
    if constexpr (Attributes::size > 0)
      return join(position, attributes_.read(v));
    else
      return position;
  }

  void read_faces(SurfaceInput<dimension>& surface) {
    for (Face f : faces(mesh_))
      surface.triangles.push_back(read_face("quadrille::simplify", mesh_, f,
                                            surface.triangles.size(),
                                            [this](Vertex v) { return vertices_.index(v); }));
    TriangleComplex::check_size(0, surface.triangles.size());
  }

  Arena* arena_;
  Mesh& mesh_;
  PointMap points_;
  VertexNumbers<Mesh, VertexIndexMap> vertices_;
  QUADRILLE_NO_UNIQUE_ADDRESS Attributes attributes_;
  FaceGraphChannels<Mesh, Maps> channels_;
  NamedEdges<Edge> named_edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_FACE_GRAPH_ADAPTER_H
