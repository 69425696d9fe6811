#ifndef QUADRILLE_INTERNAL_RESULT_H
#define QUADRILLE_INTERNAL_RESULT_H

#include <quadrille/internal/numbering.h>
#include <quadrille/internal/pair_contraction.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What became of a surface, asked and told in the numbers in which an adapter has read it.
template <class Policies>
class Result {
public:
  explicit Result(const PairContraction<Policies>& surface)
      : surface_(surface), vertices_(surface.numbering().vertices.inverse()),
        faces_(surface.numbering().faces.inverse()) {}

  std::size_t vertex_count() const { return vertices_.size(); }
  std::size_t face_count() const { return faces_.size(); }

  /// Those that are left.
  std::size_t count_faces() const { return complex().live_faces(); }
  bool has_face(Index face) const {
    return faces_[face] != none && !complex().is_dead(faces_[face]);
  }
  /// Each as image() tells it.
  TriangleComplex::Triangle corners(Index face) const {
    const auto [a, b, c] = complex().vertices(faces_[face]);
    const Origins& origins = surface_.numbering().vertices;
    return {origins[a], origins[b], origins[c]};
  }

  bool has_vertex(Index v) const {
    return vertices_[v] != none && complex().has_faces(vertices_[v]);
  }
  bool is_closed() const { return surface_.is_closed(); }
  /// What a vertex has become part of.
  Index image(Index v) const { return surface_.numbering().image(v); }
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
  std::vector<Index> vertices_, faces_; // the engine's numbers; none of what has been left out
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_RESULT_H
