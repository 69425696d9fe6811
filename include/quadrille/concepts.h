#ifndef QUADRILLE_CONCEPTS_H
#define QUADRILLE_CONCEPTS_H

#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>

/// \file
/// The concepts of the policies of `simplify`. A policy is a plain value: it is copied, and called
/// as const.
///
/// All policies use the units of the mesh and of its attributes. The engine itself works on a
/// surface of a fixed size, which is the mesh scaled by a power of two. A cost, placement or filter
/// that only compares lengths, and so gives the same result in any unit, may declare this: `using
/// ScaleFree = MyCost;` in the class MyCost. It then receives positions in the engine's unit
/// (attributes times their weights), which saves the conversion. This applies to this class alone:
/// a derived class must declare it again, or it receives the mesh's units. A cost without this
/// declaration makes the engine use the mesh's unit, in which products of lengths may under- or
/// overflow.
///
/// A pair, stop or filter policy may be chosen at run time: `simplify` accepts a std::optional of
/// it, and an empty one is the same as none.
///
/// An argument of `simplify` is taken for a cost if it has a member `dimension`, or `State` and
/// `face`, else for what it models first of a filter, a stop, a placement and pairs.

namespace quadrille {

/// **Cost**: defines the state of a vertex, and the cost of a target position.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** Quadric, MemorylessQuadric, ThinFeatureQuadric, AttributeQuadric, EdgeLength,
/// Weighted.
///
/// **Requirements**, for a constant `cost` of the type `C`:
///
/// - `C::dimension`: 3 plus the number of attributes, which are of the kind `C::attribute`, or
///   Attribute::any without it.
/// - `C::State`: the state of a vertex, a semiregular type with `+=`.
/// - `cost.face(p, q, r)`: the state that a face of the input contributes at its corner p.
/// - `cost(pair, x)`: the cost of contracting a pair to x, a number. `pair.first` and `pair.second`
///   are the positions of its ends, and `pair.state` is the sum of their states.
/// - Not checked: a cost is at least 0 and depends on its arguments only.
///
/// **Used where there**, each by itself:
///
/// - `state.move_origin(d)`: the state is stored relative to its vertex; `pair.state` is then
///   relative to `pair.first`.
/// - `C::State::sum_about_first(first, second, d)`: the sum of the states of two vertices, relative
///   to the first, if this is faster than moving the second by −d and adding.
/// - `cost.minimizer(pair)`: an optional position of least cost, which OptimalPlacement needs.
/// - `C::asks_for_indices`, true: `pair.first_index` and `pair.second_index` are the indices of the
///   ends in the input: see FilterPolicy. A cost without it pays nothing for them.
/// - `cost.input_vertex(index)`: the initial State of an input vertex, for costs with data per
///   vertex. It is accumulated in contractions, so that `pair.state` includes all input vertices
///   that the ends stand for.
/// - `cost.boundary(p, q, r)`: the state that the boundary edge pq of the face pqr contributes at
///   p.
/// - `cost.crease(p, q, r)` with `cost.crease_degrees`: the contribution of a crease, an edge whose
///   normals differ by more than this angle, or that `edge_is_crease_map` names.
/// - `cost.vertex(state, normal)` with `cost.has_vertex_terms()`: the contribution of a vertex in
///   addition to its faces, if there is one, from the sum of the faces' contributions and the sum
///   of their doubled area vectors, a Vector<3>.
/// - `cost.convert_lengths(convert)`, for a scale-free cost with members that are lengths in the
///   mesh's unit: replaces each of them by `convert(length)`. It is called for a copy of the cost,
///   which then computes the contributions of faces, vertices and edges.
/// - `cost.crease_weight`, a writable member: the weight of such edges. Region boundaries of labels
///   and chart boundaries of textures also use `crease`, with their own weights.
/// - `cost.squared_error(pair, value)`: a cost as the square of a distance, for Status and Report;
///   without it the cost itself is used.
/// - `cost.tie_break(pair, x)`: a number that is added to a cost in the order of pairs only, to
///   order pairs of equal cost; it is far below any significant cost. Its scale is that of one
///   class's values: a class that is derived from Quadric or a similar cost and has its own call
///   operator does not inherit it (Weighted passes it on); `using TieBreak = MyCost;` declares it
///   for a user's cost.
/// - `cost.validate()`: throws if the policy is invalid.
/// - `C::ScaleFree`: the cost gives the same result in any unit of length, see above.
/// - `C::TwoLanes`: pairs may be costed two at a time if vertices move to the position of least
///   cost; this is the fast path of Quadric and similar costs. `using TwoLanes = MyCost;` in the
///   class MyCost, for this class alone, declares that it is scale-free and has the same values,
///   tie break and minimizer as one of them: as Quadric for `pair.state`, a `QuadricForm<3>`; or as
///   MemorylessQuadric for the result of `join` on its `Current`, or, with `loss(growth, trace)`
///   and `State::planes`, as ThinFeatureQuadric. The contributions of faces, vertices and edges may
///   be its own. Keys then agree up to the rounding of a float.
/// - `cost.degree()`: for a ScaleFree cost, the power of lengths with which its values grow, a
///   multiple of 1/2. It converts costs to the mesh's units for stop policies. A derived class with
///   another degree must define its own.
/// - `C::face_is_alike_at_corners`: true if face(p, q, r) makes the same contribution at q and r.
/// - `cost.attribute_weights(low, high, diagonal)`, for costs with attributes: the factors by which
///   the engine multiplies them at the start, from their least and greatest values and the diagonal
///   of the surface's bounding box.
/// - `C::State` is `QuadricForm<3>`, or `pair.current.quadric` is one to which others can be added:
///   channels (channels.h) then count in the cost; with other costs they are only carried along.
/// - `C::channel_weight(area)`: the weight of a face for channels; without it its area.
///
/// **Local terms**, for a cost that depends on the current surface, as MemorylessQuadric does:
///
/// - `C::Current`: the contribution of the current faces around a vertex, a semiregular type with
///   `+=` and `-=`.
/// - `cost.current_face(p, q, r)`: the contribution of a face at each of its corners, relative to
///   the corner.
/// - `cost.current_boundary(p, q, r)`: the contribution of the boundary edge pq of the face pqr at
///   both ends.
/// - `C::PairCurrent` and `cost.join(first, second, shared, d)`: the local terms of a pair,
///   relative to its first end, from the contributions of both ends and of the faces that they
///   share; d is the vector from the first to the second end. The pair then has them as
///   `pair.current`.
/// - `C::tolerated_rise`: a pair whose cost has risen by at most this factor in the queue is
///   contracted anyway; without it 1.
/// - `cost.unevenness(current)` with `C::tolerated_fall`: if that number falls by more than this
///   factor, the pairs of the vertex are costed again.
///
/// **The least model**:
/// ```cpp
/// struct Distance {  // how far the two ends have to go
///   static constexpr std::size_t dimension = 3;
///   struct State { State& operator+=(const State&) { return *this; } };
///   State face(auto&&, auto&&, auto&&) const { return {}; }
///   double operator()(const auto& pair, const auto& x) const {
///     return squared_distance(pair.first, x) + squared_distance(pair.second, x);
///   }
/// };
/// ```
template <class C>
concept CostPolicy = std::copy_constructible<C> && requires {
  requires C::dimension >= 3;
  typename C::State;
} && std::semiregular<typename C::State> &&
    requires(const C cost, typename C::State state, const Vector<C::dimension> p,
             const internal::PairOf<C> pair) {
  state += state;
  { cost.face(p, p, p) } -> std::convertible_to<typename C::State>;
  { cost(pair, p) } -> std::convertible_to<double>;
};

/// **Placement**: chooses the position of the contracted vertex.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** OptimalPlacement, EndpointPlacement, MidpointPlacement, VolumeKeeping, OuterHull,
/// InnerHull.
///
/// **Requirements**, for a constant `placement`:
///
/// - `placement(cost, pair)`: a position, a Vector of the cost's dimension. `pair.first` and
///   `pair.second` are the ends, `pair.squared_ring_radius` is the squared distance of their
///   farthest neighbour; `cost(pair, x)` is the cost of a position and, if the cost has one,
///   `cost.minimizer(pair)` an optional position of least cost. `pair.state` is available if the
///   cost is not ScaleFree, or if the placement is.
/// - Not checked: the position is finite. Otherwise the pair is rejected as Rejection::position.
///
/// **Used where there**:
///
/// - `placement.any_equal(cost, pair, x, predicate)`: tries other positions with the same cost as x
///   if filters reject x: see OptimalPlacement.
/// - `P::asks_for_indices`, true: `pair.first_index` and `pair.second_index` are the indices of the
///   ends in the input: see FilterPolicy.
/// - `P::asks_for_volume`, true: Report::volume_before and volume_after are computed.
/// - `P::needs_closed_surface`, true: a surface is rejected unless each edge has as many faces on
///   one side as on the other.
/// - `placement.is_optimal()`, for a run-time choice that may be OptimalPlacement: returns whether
///   this placement takes the position of least cost. It may then be computed for two pairs at
///   once.
/// - `placement.validate()`: throws if the policy is invalid.
/// - `P::ScaleFree`: the placement gives the same result in any unit of length, see above.
///
/// **Also used**, in a scale-free placement that declares `static constexpr bool looks_at_star =
/// true`:
///
/// - `placement.resolve(cost, pair, star)`: an optional position once all faces around the pair are
///   known: `star.for_each_face(visit)` calls visit(p, q, r) with the corners of each.
/// - `placement.admits(pair, star, x)`: the final test of each position that is tried.
/// - `P::cause`: the Rejection that counts positions that it rejects, and pairs without a position.
/// - `placement.any_further(cost, pair, star, predicate)`: tries other positions after a rejection.
/// - `P::Guess`: a placement that estimates the costs by which pairs are ordered until their turn,
///   and `P::rise_of_estimate`, the factor for its costs. The call itself, `placement(cost, pair)`,
///   returns this estimate.
///
/// **The least model**:
/// ```cpp
/// struct First {
///   auto operator()(const auto& /*cost*/, const auto& pair) const { return pair.first; }
/// };
/// ```
template <class P, class Cost>
concept PlacementPolicy = std::copy_constructible<P> &&
    requires(const P placement, const typename internal::SeenByPlacement<P, Cost>::Costs cost,
             const typename internal::SeenByPlacement<P, Cost>::Pair pair) {
  { placement(cost, pair) } -> std::convertible_to<Vector<Cost::dimension>>;
};

/// **Pairs**: selects the pairs of vertices that may be contracted.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** EdgePairs, ThresholdPairs.
///
/// **Requirements**, for a constant `pairs`:
///
/// - `pairs(surface, emit)`: selects pairs by calls `emit(i, j)`, and returns nothing. `surface` is
///   a SurfaceView, `emit` an EmitPair.
/// - Not checked: i and j are indices of points of the view. Other indices cause std::out_of_range.
///
/// **Used where there**:
///
/// - `static constexpr bool includes_edges = true`: every edge is a pair as well, including edges
///   that arise later. Without it the pairs are the emitted ones and those that they become by
///   contractions.
/// - `static constexpr bool ignores_indices = true`: the points of a large surface may come in
///   another order than the user's.
/// - `pairs.validate()`: throws if the policy is invalid.
///
/// **The least model**:
/// ```cpp
/// struct None {
///   void operator()(const SurfaceView&, auto&&) const {}
/// };
/// ```
template <class P>
concept PairPolicy = std::copy_constructible<P> &&
    requires(const P pairs, const SurfaceView surface, const EmitPair emit) {
  { pairs(surface, emit) } -> std::same_as<void>;
};

/// **Stop**: decides before each contraction whether to stop.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** FaceCount, FaceRatio, VertexCount, EdgeCount, EdgeRatio, DistanceLimit,
/// HausdorffLimit, ToleranceLimit, CostLimit, ShortestEdge, TimeBudget, AnyOf, AllOf.
///
/// **Requirements**, for a constant `stop`:
///
/// - `stop(status)`: a bool; `status` is a Status.
/// - Not checked: once it is true it stays so.
///
/// **Used where there**:
///
/// - `S::needs`, a constant Needs: the optional numbers of the Status that any object of this type
///   may read. `static constexpr Needs needs = {.cost = true};`
/// - `stop.needs_now()`, in addition: the Needs of this object, a subset of those. So one type can
///   serve with a limit and without one, where no distances are computed. Without it every object
///   needs all of them.
/// - If it stops at a pair only because of Status::next_distance, next_reverse_distance or
///   next_tolerance, the pair is rejected and the search goes on. If it stops at a next_cost, it
///   must stop at all greater ones.
/// - `stop.is_passed(status)`: returns whether a surface of this status is beyond the target, not
///   just at it. The engine then looks for a pair that meets the target exactly.
/// - `stop.validate()`: throws if the policy is invalid.
///
/// **The least model** is a lambda: `[](const Status& status) { return status.faces < 1000; }`
template <class S>
concept StopPolicy = std::copy_constructible<S> && requires(const S stop, const Status status) {
  { stop(status) } -> std::convertible_to<bool>;
};

/// **Filter**: decides just before a contraction whether it may be done. Any number of filters can
/// be combined.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** NormalFlip, SmallestAngle, LongestEdge, HighestDegree and HeightField.
/// NoSelfIntersection and NormalDeviation are not filters: they must follow contractions, which a
/// filter does not see. See GuardPolicy in <quadrille/guard.h>.
///
/// **Requirements**, for a constant `filter`:
///
/// - `filter.allows(contraction)`: a bool. `contraction.faces()` are the faces that change, each
///   with its moving corner `before` and `after` and its others, `second` and `third`; at a vertex
///   of more than 128 faces, which does not move, only those of its own faces that are adjacent to
///   the other end's; `contraction.target()` is the new position; `contraction.highest_degree()` is
///   the higher degree of the pair's ends, in faces; `contraction.makes_fold_over()` returns
///   whether a face would fold over a neighbour.
/// - The elements are identified by indices in the input: the pair's ends are `contraction.first()`
///   and `contraction.second()`, `face.index` is that of a face that changes, and
///   `contraction.removed_faces()` has those of the removed faces;
///   `contraction.for_each_gone(visit)` calls visit(f) for each of these, with its `f.corners`
///   before the contraction and `f.index`. Corners are in the order of the face: (before, second,
///   third) of one that stays. Indices of a soup are its own; vertices and faces of a mesh are
///   numbered from 0 in the order of `vertices(mesh)` and `faces(mesh)`; with SplitVertices the
///   distinct positions are numbered, in the order of the first point at each. A merged vertex has
///   the index of one of its vertices. Indices cost nothing if they are not used.
///
/// **Used where there**:
///
/// - `F::cause`: the Rejection that counts its rejections; without it Rejection::filter.
/// - `filter.validate()`: throws if the policy is invalid.
/// - `F::ScaleFree`: the filter gives the same result in any unit of length, see above.
///
/// **The least model**:
/// ```cpp
/// struct All {
///   bool allows(const auto&) const { return true; }
/// };
/// ```
template <class F, class Cost>
concept FilterPolicy = std::copy_constructible<F> &&
    requires(const F filter,
             const typename internal::SeenByFilter<F, Cost>::Contraction contraction) {
  { filter.allows(contraction) } -> std::convertible_to<bool>;
};

} // namespace quadrille

#endif // QUADRILLE_CONCEPTS_H
