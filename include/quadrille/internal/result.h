#ifndef QUADRILLE_INTERNAL_RESULT_H
#define QUADRILLE_INTERNAL_RESULT_H

#include <quadrille/internal/pair_contraction.h>
#include <quadrille/internal/spatial_order.h>
#include <quadrille/internal/triangle_complex.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>

namespace quadrille::internal {

/// What became of a surface, asked in the numbers in which an adapter has read it.
template <class Policies>
class Result {
public:
  Result(const PairContraction<Policies>& surface, const SpatialOrder& order)
      : surface_(surface), order_(order) {}

  std::size_t vertex_count() const { return surface_.vertex_capacity(); }
  std::size_t face_count() const { return surface_.complex().face_capacity(); }

  /// Those that are left.
  std::size_t count_faces() const { return surface_.complex().live_faces(); }
  bool has_face(Index face) const { return !surface_.complex().is_dead(order_.face_rank(face)); }
  /// Each as image() tells it.
  const TriangleComplex::Triangle& corners(Index face) const {
    return surface_.complex().vertices(order_.face_rank(face));
  }

  bool has_vertex(Index v) const { return surface_.complex().has_faces(order_.vertex_rank(v)); }
  bool is_closed() const { return surface_.is_closed(); }
  /// The engine's number, below vertex_count(), of what a vertex has become part of.
  Index image(Index v) const { return surface_.image(order_.vertex_rank(v)); }
  bool is_moved(Index v) const { return surface_.is_moved(order_.vertex_rank(v)); }
  /// With attributes, in the units of the mesh.
  auto position(Index v) const { return surface_.position(order_.vertex_rank(v)); }

  /// As vertex_quadric_map tells it.
  auto mean_quadric(Index v) const {
    using Cost = typename Policies::Cost;
    static_assert(std::same_as<typename Cost::Memory, QuadricForm<Cost::dimension>>,
                  "vertex_quadric_map needs a cost that remembers a QuadricForm: use Quadric or an "
                  "AttributeQuadric.");
    return surface_.mean_quadric(order_.vertex_rank(v));
  }

private:
  const PairContraction<Policies>& surface_;
  const SpatialOrder& order_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_RESULT_H
