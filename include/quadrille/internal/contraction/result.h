#ifndef QUADRILLE_INTERNAL_CONTRACTION_RESULT_H
#define QUADRILLE_INTERNAL_CONTRACTION_RESULT_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/pair_contraction.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/memory/packing.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// What became of a surface: the vertices and faces that are left, counted off in the engine's
/// order, in which neighbours lie near each other. The numbers in which an adapter has read them
/// are their origins.
template <class Policies>
class Result {
public:
  Result(const PairContraction<Policies>& surface, Numbering numbering)
      : surface_(surface), numbering_(std::move(numbering)), vertices_(complex().left_vertices()),
        faces_(complex().left_faces()), numbers_(places(vertices_, complex().vertex_capacity())) {}

  /// How many an adapter has read.
  std::size_t first_vertex_count() const { return numbering_.vertices.first_count(); }
  std::size_t first_face_count() const { return numbering_.faces.first_count(); }

  /// The origins of those that are left.
  Array<Index> vertex_origins() const { return numbering_.vertices.of(vertices_); }
  Array<Index> face_origins() const { return numbering_.faces.of(faces_); }
  /// The origin of what the vertex of an origin has become part of.
  Index image(Index origin) const { return numbering_.image(origin); }

  TriangleComplex::Triangle corners(Index face) const {
    const auto [a, b, c] = complex().vertices(faces_[face]);
    return {numbers_[a], numbers_[b], numbers_[c]};
  }
  bool is_closed() const { return surface_.is_closed(); }
  bool is_moved(Index v) const { return surface_.is_moved(vertices_[v]); }
  /// With attributes, in the units of the mesh.
  auto position(Index v) const { return surface_.position(vertices_[v]); }

  /// As vertex_quadric_map tells it.
  auto mean_quadric(Index v) const {
    using Cost = typename Policies::Cost;
    static_assert(std::same_as<typename Cost::Memory, QuadricForm<Cost::dimension>>,
                  "vertex_quadric_map needs a cost that remembers a QuadricForm: use Quadric or an "
                  "AttributeQuadric.");
    return surface_.mean_quadric(vertices_[v]);
  }

private:
  const TriangleComplex& complex() const { return surface_.complex(); }

  const PairContraction<Policies>& surface_;
  Numbering numbering_;
  Array<Index> vertices_, faces_; // in the engine's numbers
  Array<Index> numbers_;          // of each vertex of the engine, as it is counted off here
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_RESULT_H
