#ifndef QUADRILLE_INTERNAL_CONTRACTION_RESULT_H
#define QUADRILLE_INTERNAL_CONTRACTION_RESULT_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/finished_surface.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// The vertices and faces of a finished surface that are left, counted off in the engine's order,
/// in which neighbours lie near each other. Input indices are those under which an adapter has read
/// them.
template <class Cost>
class Result {
public:
  explicit Result(FinishedSurface<Cost> surface)
      : surface_(with_less_memory(std::move(surface))), vertices_(complex().left_vertices()),
        faces_(complex().left_faces()), numbers_(places(vertices_, complex().vertex_capacity())) {}

  /// How many an adapter has read.
  std::size_t input_vertex_count() const { return surface_.numbering.vertices.input_count(); }
  std::size_t input_face_count() const { return surface_.numbering.faces.input_count(); }

  /// The input indices of those that are left.
  Array<Index> input_vertices() const { return surface_.numbering.vertices.of(vertices_); }
  Array<Index> input_faces() const { return surface_.numbering.faces.of(faces_); }
  /// The input index of what a vertex of the input has become part of.
  Index image(Index input) const { return surface_.numbering.image(input); }

  TriangleComplex::Triangle corners(Index face) const {
    const auto [a, b, c] = complex().vertices(faces_[face]);
    return {numbers_[a], numbers_[b], numbers_[c]};
  }
  bool is_closed() const { return surface_.is_closed; }
  bool is_moved(Index v) const { return surface_.is_moved[vertices_[v]] != 0; }
  /// With attributes, in the units of the mesh.
  auto position(Index v) const {
    return surface_.scale.position_of_mesh(surface_.positions[vertices_[v]]);
  }

  const Channel& channel(std::size_t c) const { return surface_.channels[c]; }
  /// Of a corner of a face, in a channel.
  Index wedge(std::size_t c, Index face, std::size_t corner) const {
    const Index f = faces_[face];
    return channel(c).wedge(complex(), f, complex().vertices(f)[corner]);
  }
  /// The first one of a vertex, in any channel.
  Index first_wedge(Index v) const { return vertices_[v]; }
  /// How many numbers of wedges a channel may use.
  std::size_t wedge_count(std::size_t c) const {
    return channel(c).wedge_count(complex().vertex_capacity());
  }

  /// As vertex_quadric_map tells it.
  auto mean_quadric(Index v) const {
    static_assert(std::same_as<typename Cost::Memory, QuadricForm<Cost::dimension>>,
                  "vertex_quadric_map needs a cost that remembers a QuadricForm: use Quadric or an "
                  "AttributeQuadric.");
    return surface_.scale.mean_of_mesh(surface_.memories[vertices_[v]]);
  }

private:
  // Gives back what only contractions needed.
  static FinishedSurface<Cost> with_less_memory(FinishedSurface<Cost> surface) {
    surface.complex.release();
    surface.positions.shrink_to_fit();
    surface.numbering.use_input_indices();
    surface.numbering.vertices.shrink_to_fit();
    return surface;
  }

  const TriangleComplex& complex() const { return surface_.complex; }

  FinishedSurface<Cost> surface_;
  Array<Index> vertices_, faces_; // in the engine's numbers
  Array<Index> numbers_;          // of each vertex of the engine, as it is counted off here
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_RESULT_H
