#ifndef QUADRILLE_INTERNAL_COST_INITIAL_MEMORIES_H
#define QUADRILLE_INTERNAL_COST_INITIAL_MEMORIES_H

#include <quadrille/internal/base/ranges.h>
#include <quadrille/internal/complex/edge_star.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/surface/shared_vertices.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <vector>

namespace quadrille::internal {

/// What each vertex remembers at the beginning: its faces, itself, its boundary edges, its creases.
template <class Cost>
class InitialMemories {
public:
  using Memory = typename Cost::Memory;
  using Position = Vector<Cost::dimension>;
  using Edge = std::array<Index, 2>;

  /// is_interior(v) tells of vertices that have no boundary edge for certain.
  template <class IsInterior>
  static void compute(UninitializedArray<Memory>& result, const Cost& cost,
                      const Array<Position>& positions, TriangleComplex& complex,
                      VertexLabels& labels, const std::vector<Edge>& creases,
                      const SharedVertices& shared, IsInterior is_interior, Threads threads) {
    result.resize(positions.size());
    InitialMemories memories(cost, positions, complex, result);
    for_each_range(threads, positions.size(), [&](const auto& range, std::size_t) {
      std::fill(result.begin() + range.begin, result.begin() + range.end, Memory{});
      memories.add_faces(range);
      memories.add_vertices(range);
    });
    if constexpr (has_boundaries || has_creases)
      memories.add_edges(labels, shared, is_interior);
    add_creases(result, cost, positions, complex, creases);
  }

  /// Adds what creases leave, for a cost that knows them.
  static void add_creases(UninitializedArray<Memory>& result, const Cost& cost,
                          const Array<Position>& positions, TriangleComplex& complex,
                          const std::vector<Edge>& creases) {
    InitialMemories memories(cost, positions, complex, result);
    if constexpr (has_creases)
      for (const auto& [v, w] : creases)
        memories.add_crease(v, w);
  }

private:
  static constexpr bool has_boundaries = requires(const Cost c, Position p) {
    c.boundary(p, p, p);
  };
  static constexpr bool has_creases = requires(const Cost c, Position p) {
    c.crease(p, p, p);
    c.crease_degrees;
  };
  static constexpr bool may_have_vertex_terms = requires(const Cost c, const Memory m) {
    c.vertex(m, Vector<3>{});
    { c.has_vertex_terms() } -> std::convertible_to<bool>;
  };

  InitialMemories(const Cost& cost, const Array<Position>& positions, TriangleComplex& complex,
                  UninitializedArray<Memory>& memories)
      : cost_(cost), positions_(positions), complex_(complex), memories_(memories) {}

  // To the vertices of a range.
  template <class R>
  void add_faces(const R& range) {
    complex_.for_each_face_at(
        range, [&](const TriangleComplex::Triangle& corners) { this->add_face(corners, range); });
  }

  template <class R>
  void add_face(const TriangleComplex::Triangle& corners, const R& range) {
    const auto [p, q, r] = corners;
    if constexpr (requires { requires Cost::face_is_alike_at_corners; }) {
      const Memory memory = cost_.face(positions_[p], positions_[q], positions_[r]);
      for (Index v : corners)
        if (range.contains(v))
          memories_[v] += memory;
    } else {
      if (range.contains(p))
        memories_[p] += cost_.face(positions_[p], positions_[q], positions_[r]);
      if (range.contains(q))
        memories_[q] += cost_.face(positions_[q], positions_[r], positions_[p]);
      if (range.contains(r))
        memories_[r] += cost_.face(positions_[r], positions_[p], positions_[q]);
    }
  }

  // What vertices of a range leave themselves.
  template <class R>
  void add_vertices([[maybe_unused]] const R& range) {
    if constexpr (may_have_vertex_terms) {
      if (!cost_.has_vertex_terms())
        return;
      std::vector<Vector<3>> normals(range.end - range.begin);
      complex_.for_each_face_at(range, [&](const TriangleComplex::Triangle& corners) {
        const auto at = [&](std::size_t i) { return space(positions_[corners[i]]); };
        const Vector<3> normal = normal_vector(at(0), at(1), at(2));
        for (Index v : corners)
          if (range.contains(v))
            normals[v - range.begin] += normal;
      });
      for (Index v = range.begin; v < range.end; ++v)
        memories_[v] += cost_.vertex(memories_[v], normals[v - range.begin]);
    }
  }

  // Each end of a boundary edge meets it once; of a crease, the lower end takes care.
  template <class IsInterior>
  void add_edges(VertexLabels& labels, const SharedVertices& shared, IsInterior is_interior) {
    EdgeStar star;
    for (Index v = 0; v < positions_.size(); ++v) {
      if (!finds_creases() && is_interior(v))
        continue;
      for (const EdgeAt& edge : star.gather(complex_, v, labels)) {
        if constexpr (has_boundaries)
          if (edge.faces == 1 && !shared.is_seam(v, edge.other))
            memories_[v] +=
                cost_.boundary(positions_[v], positions_[edge.other], positions_[edge.opposite[0]]);
        if constexpr (has_creases)
          if (edge.faces == 2 && v < edge.other && is_crease(v, edge))
            add_crease(v, edge.other);
      }
    }
  }

  bool finds_creases() const {
    if constexpr (has_creases)
      return cost_.crease_degrees < 180;
    else
      return false;
  }

  bool is_crease(Index v, const EdgeAt& edge) const {
    if (!finds_creases())
      return false;
    const Vector<3> p = space(positions_[v]), q = space(positions_[edge.other]);
    const Vector<3> m = double_area_vector(p, q, space(positions_[edge.opposite[0]]));
    const Vector<3> n = double_area_vector(q, p, space(positions_[edge.opposite[1]]));
    const double lengths = std::sqrt(squared_length(m) * squared_length(n));
    return dot(m, n) < std::cos(cost_.crease_degrees * std::numbers::pi / 180) * lengths;
  }

  // Each face of a crease leaves a plane, at both of its ends.
  void add_crease(Index v, Index w) {
    complex_.prune_corners(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex_, face, i);
      if (!f.has(w))
        return;
      const Index opposite = f.other_than(w);
      memories_[v] += cost_.crease(positions_[v], positions_[w], positions_[opposite]);
      memories_[w] += cost_.crease(positions_[w], positions_[v], positions_[opposite]);
    });
  }

  const Cost& cost_;
  const Array<Position>& positions_;
  TriangleComplex& complex_;
  UninitializedArray<Memory>& memories_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COST_INITIAL_MEMORIES_H
