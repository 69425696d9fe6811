#ifndef QUADRILLE_INTERNAL_RESULT_H
#define QUADRILLE_INTERNAL_RESULT_H

#include <quadrille/internal/numbering.h>
#include <quadrille/internal/pair_contraction.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// What became of a surface, asked and told in the numbers in which an adapter has read it.
template <class Policies>
class Result {
public:
  Result(const PairContraction<Policies>& surface, Numbering numbering)
      : surface_(surface), numbering_(std::move(numbering)),
        vertices_(numbering_.vertices.inverse()),
        faces_(std::exchange(numbering_.faces, Origins(0, {})).inverse()) {}

  std::size_t vertex_count() const { return vertices_.first_count(); }
  std::size_t face_count() const { return faces_.first_count(); }

  /// Those that are left.
  std::size_t count_faces() const { return complex().live_faces(); }
  bool has_face(Index face) const {
    return faces_[face] != none && !complex().is_dead(faces_[face]);
  }
  /// Each as image() tells it.
  TriangleComplex::Triangle corners(Index face) const {
    const auto [a, b, c] = complex().vertices(faces_[face]);
    const Origins& origins = numbering_.vertices;
    return {origins[a], origins[b], origins[c]};
  }

  bool has_vertex(Index v) const {
    return vertices_[v] != none && complex().has_faces(vertices_[v]);
  }
  bool is_closed() const { return surface_.is_closed(); }
  /// What a vertex has become part of.
  Index image(Index v) const { return numbering_.image(v); }
  /// Of a vertex that is left.
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
  Origins vertices_, faces_; // the other way round: the engine's numbers
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_RESULT_H
