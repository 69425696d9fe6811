#ifndef QUADRILLE_INTERNAL_CORE_COST_VERTEX_STATES_H
#define QUADRILLE_INTERNAL_CORE_COST_VERTEX_STATES_H

#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/edge_star.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/shared_vertices.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Computes the initial state of each vertex, from its faces, itself, its boundary edges and its
/// creases.
template <class Cost>
class InitialStates {
public:
  using State = typename Cost::State;
  using Position = Vector<Cost::dimension>;
  using Edge = std::array<Index, 2>;

  /// is_interior(v) is true only for vertices that certainly have no boundary edge.
  template <class IsInterior>
  static void compute(UninitializedArray<State>& result, const Cost& cost,
                      const Array<Position>& positions, TriangleComplex& complex,
                      VertexLabels& labels, const std::vector<Edge>& creases,
                      const SharedVertices& shared, IsInterior is_interior, Threads threads) {
    result.resize(positions.size());
    InitialStates states(cost, positions, complex, result);
    for_each_range(threads, positions.size(), [&](const auto& range, std::size_t) {
      std::fill(result.begin() + range.begin, result.begin() + range.end, State{});
      states.add_faces(range);
      states.add_vertices(range);
    });
    if constexpr (has_boundaries || has_creases)
      states.add_edges(labels, shared, is_interior);
    add_creases(result, cost, positions, complex, creases);
  }

  /// Adds what creases leave, for a cost that knows them.
  static void add_creases(UninitializedArray<State>& result, const Cost& cost,
                          const Array<Position>& positions, TriangleComplex& complex,
                          const std::vector<Edge>& creases) {
    InitialStates states(cost, positions, complex, result);
    if constexpr (has_creases)
      for (const auto& [v, w] : creases)
        states.add_crease(v, w);
  }

private:
  static constexpr bool has_boundaries = requires(const Cost c, Position p) {
    c.boundary(p, p, p);
  };
  static constexpr bool has_creases = requires(const Cost c, Position p) {
    c.crease(p, p, p);
    c.crease_degrees;
  };
  static constexpr bool may_have_vertex_terms = requires(const Cost c, const State m) {
    c.vertex(m, Vector<3>{});
    { c.has_vertex_terms() } -> std::convertible_to<bool>;
  };

  InitialStates(const Cost& cost, const Array<Position>& positions, TriangleComplex& complex,
                UninitializedArray<State>& states)
      : cost_(cost), positions_(positions), complex_(complex), states_(states) {}

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
      const State state = cost_.face(positions_[p], positions_[q], positions_[r]);
      for (Index v : corners)
        if (range.contains(v))
          states_[v] += state;
    } else {
      if (range.contains(p))
        states_[p] += cost_.face(positions_[p], positions_[q], positions_[r]);
      if (range.contains(q))
        states_[q] += cost_.face(positions_[q], positions_[r], positions_[p]);
      if (range.contains(r))
        states_[r] += cost_.face(positions_[r], positions_[p], positions_[q]);
    }
  }

  // Adds the terms of the vertices of a range themselves.
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
        states_[v] += cost_.vertex(states_[v], normals[v - range.begin]);
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
            states_[v] +=
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
      states_[v] += cost_.crease(positions_[v], positions_[w], positions_[opposite]);
      states_[w] += cost_.crease(positions_[w], positions_[v], positions_[opposite]);
    });
  }

  const Cost& cost_;
  const Array<Position>& positions_;
  TriangleComplex& complex_;
  UninitializedArray<State>& states_;
};

/// Initial states by input indices, used instead of those that faces would give: in the engine's
/// units, about the vertex.
template <class State>
struct GivenStates {
  std::vector<State> states;
  std::vector<bool> is_given; ///< has a value for each; empty: all are given

  bool has(std::size_t vertex) const {
    return !states.empty() && (is_given.empty() || is_given[vertex]);
  }
};

/// The state of each vertex: for a quadric, the sum over its planes.
template <class Cost>
class VertexStates {
public:
  using State = typename Cost::State;
  using Positions = Array<Vector<Cost::dimension>>;

  explicit VertexStates(Arena* arena) : states_(arena) {}

  const State& operator[](Index v) const { return states_[v]; }
  State& operator[](Index v) { return states_[v]; }

  /// Accumulates the current surface. is_interior(v) is true only for vertices that certainly have
  /// no boundary edge.
  template <class IsInterior>
  void accumulate(const Cost& cost, const Positions& positions, TriangleComplex& complex,
                  VertexLabels& labels, const std::vector<std::array<Index, 2>>& creases,
                  const SharedVertices& shared, IsInterior is_interior, Threads threads) {
    InitialStates<Cost>::compute(states_, cost, positions, complex, labels, creases, shared,
                                 is_interior, threads);
  }

  /// Adds what vertices of the input leave that the cost knows by their indices, for a cost that
  /// does: of all that a vertex stands for.
  void accumulate_input([[maybe_unused]] const Cost& cost,
                        [[maybe_unused]] const Numbering& numbering) {
    if constexpr (AccumulatesByIndex<Cost>) {
      const InputIndices numbers = numbering.vertices.inverse();
      for (Index input = 0; input < numbering.vertices.input_count(); ++input)
        if (const Index v = numbers[numbering.merged_vertex(input)]; v != none)
          states_[v] += cost.input_vertex(input);
    }
  }

  /// Adds what further creases leave, with a weight of their own.
  void accumulate_creases(Cost cost, double weight, const Positions& positions,
                          TriangleComplex& complex,
                          const std::vector<std::array<Index, 2>>& creases) {
    if constexpr (requires { cost.crease_weight; })
      cost.crease_weight = weight;
    InitialStates<Cost>::add_creases(states_, cost, positions, complex, creases);
  }

  /// Replaces the states of those vertices to which states are given.
  void take_given(const GivenStates<State>& given, const InputIndices& input_vertices) {
    for (Index v = 0; v < states_.size(); ++v)
      if (const Index input = input_vertices[v]; given.has(input))
        states_[v] = given.states[input];
  }

  static auto vertex_arrays(auto& self) { return std::tie(self.states_); }

  /// Gives the vertex that a contraction has left the sum of both states.
  template <class Event>
  void contract(const Event& event) {
    const auto& pair = event.contraction.pair();
    State& state = states_[event.kept];
    state = pair.state;
    move_origin(state, event.contraction.target() - pair.first);
  }

  /// All of it, which is no longer here then.
  UninitializedArray<State> take() { return std::move(states_); }

private:
  UninitializedArray<State> states_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COST_VERTEX_STATES_H
