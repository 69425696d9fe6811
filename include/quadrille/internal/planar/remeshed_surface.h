#ifndef QUADRILLE_INTERNAL_PLANAR_REMESHED_SURFACE_H
#define QUADRILLE_INTERNAL_PLANAR_REMESHED_SURFACE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// A face of a result, which consists of corners and sides of the input; side 3f + k leads to
/// corner k of face f.
struct RemeshedFace {
  Index input;                  ///< the face from which it has its label and properties
  std::array<Index, 3> corners; ///< the original of each corner: its vertex, and its values in
                                ///< channels
  std::array<Index, 3> sides;   ///< the original of the side to each corner; each side occurs once
};

/// The remaining surface of an input, as adapters write it: the vertices of some faces, at their
/// original positions.
class RemeshedSurface {
public:
  RemeshedSurface(InputWithChannels input, Array<RemeshedFace> faces)
      : input_(std::move(input)), faces_(std::move(faces)) {
    Array<unsigned char> is_left(input_.positions.size(), 0);
    for (const RemeshedFace& face : faces_)
      for (Index corner : face.corners)
        is_left[vertex_at(corner)] = 1;
    vertices_ = indices_of(is_left, [](unsigned char is) { return is != 0; });
    numbers_ = places(vertices_, input_.positions.size());
  }

  std::size_t face_count() const { return faces_.size(); }

  std::size_t input_vertex_count() const { return input_.positions.size(); }
  std::size_t input_face_count() const { return input_.triangles.size(); }
  const Array<Index>& input_vertices() const { return vertices_; }
  Array<Index> input_faces() const {
    Array<Index> inputs;
    for (const RemeshedFace& face : faces_)
      inputs.push_back(face.input);
    return inputs;
  }
  /// The vertex that a vertex of the input has become: itself, if it is left.
  Index merged_vertex(Index input) const { return input; }

  TriangleComplex::Triangle corners(Index face) const {
    const auto number = [&](std::size_t i) { return numbers_[vertex_at(faces_[face].corners[i])]; };
    return {number(0), number(1), number(2)};
  }
  /// The side of the input that leads to the original of a corner, and the original of the side to
  /// that corner.
  Index input_corner(Index face, std::size_t corner) const { return faces_[face].corners[corner]; }
  Index input_side(Index face, std::size_t corner) const { return faces_[face].sides[corner]; }

  /// No boundary has to be searched for: boundary sides come from the boundary of the input.
  bool is_closed() const { return true; }
  bool is_moved(Index) const { return false; }
  const Vector<3>& position(Index v) const { return input_.positions[vertices_[v]]; }

  /// The wedges of a channel have the numbers of its values.
  Index wedge(std::size_t c, Index face, std::size_t corner) const {
    const Index side = faces_[face].corners[corner];
    return input_.channels[c].value_at(side / 3, side % 3, vertex_at(side));
  }
  Index first_wedge(Index v) const { return vertices_[v]; }
  std::size_t wedge_count(std::size_t c) const { return input_.channels[c].size(); }
  std::size_t components(std::size_t c) const { return input_.channels[c].components; }
  double value(std::size_t c, Index wedge, std::size_t component) const {
    return input_.channels[c].value(wedge, component);
  }
  Index origin(std::size_t, Index wedge) const { return wedge; }

private:
  Index vertex_at(Index side) const { return input_.triangles[side / 3][side % 3]; }

  InputWithChannels input_;
  Array<RemeshedFace> faces_;
  Array<Index> vertices_; // the remaining vertices by their input indices, ascending
  Array<Index> numbers_;  // for each input vertex, its index in vertices_
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_REMESHED_SURFACE_H
