#ifndef QUADRILLE_INTERNAL_ADAPTER_VERTEX_NUMBERS_H
#define QUADRILLE_INTERNAL_ADAPTER_VERTEX_NUMBERS_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// The vertices of a mesh, counted off in its order: the engine's numbers, whatever gaps the user's
/// have.
template <class Mesh, class VertexIndexMap>
class VertexNumbers {
public:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

  explicit VertexNumbers(VertexIndexMap indices, Workspace* workspace = nullptr)
      : indices_(indices), vertices_(workspace), places_(workspace) {}

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
  /// Gives memory back that read() can fill anew.
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

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ADAPTER_VERTEX_NUMBERS_H
