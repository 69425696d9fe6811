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
/// The policies of `simplify` and what each of them has to answer. A policy is a plain value: it is
/// copied, and called as const.
///
/// All of them speak the units of the mesh and of its attributes, whatever these are. The engine
/// itself works on a surface of a fixed size, a power of two times the mesh's. Where a cost, a
/// placement or a filter does as well in any unit of length, since it only compares, it may say so:
/// `using ScaleFree = MyCost;` in the class MyCost. It is then handed positions as the engine has
/// them (attributes times their weights), which saves the conversion. That holds for this class
/// alone: one that is derived from it says it anew, or speaks the mesh's units. A cost that does
/// not say it keeps the engine to the mesh's unit, in which products of lengths may under- or
/// overflow.
///
/// Whether there is a pair, stop or filter policy may be told at run time: std::optional of it is
/// an argument of `simplify`, and where it holds nothing it is as if it had not been passed.
///
/// An argument of `simplify` is taken for a cost if it has a member `dimension`, or `State` and
/// `face`, else for what it models first of a filter, a stop, a placement and pairs.

namespace quadrille {

/// **Cost**: what does a vertex remember of the surface, and what does a target position cost?
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
/// - `C::State`: what a vertex remembers, a semiregular type with `+=`.
/// - `cost.face(p, q, r)`: the state that a face of the input leaves at its corner p.
/// - `cost(pair, x)`: what it costs to contract a pair to x, a number. `pair.first` and
///   `pair.second` are the positions of its ends, `pair.state` is the sum of what both remember.
/// - Not checked: a cost is at least 0 and depends on nothing but its arguments.
///
/// **Used where there**, each by itself:
///
/// - `state.move_origin(d)`: what is remembered is kept about its vertex; `pair.state` is then
///   about `pair.first`.
/// - `C::State::sum_about_first(first, second, d)`: the sum of what two vertices remember, about
///   the first, where that is quicker than to move the second by −d and to add.
/// - `cost.minimizer(pair)`: an optional position of least cost, which OptimalPlacement needs.
/// - `C::asks_for_indices`, true: `pair.first_index` and `pair.second_index` tell which vertices of
///   the input the ends are: see FilterPolicy. A cost that does not say it pays nothing for them.
/// - `cost.input_vertex(index)`: the state that a vertex leaves of which the cost knows something
///   by its index in the input. A vertex remembers that of all that have become part of it, so that
///   `pair.state` tells of all that the ends stand for.
/// - `cost.boundary(p, q, r)`: the state that the boundary edge pq of the face pqr leaves at p.
/// - `cost.crease(p, q, r)` with `cost.crease_degrees`: the same for a crease, an edge whose
///   normals differ by more than that, or that `edge_is_crease_map` names.
/// - `cost.vertex(state, normal)` with `cost.has_vertex_terms()`: what a vertex leaves beside its
///   faces, where there is any such thing, from what these leave and the sum of their doubled area
///   vectors, a Vector<3>.
/// - `cost.convert_lengths(convert)`, for a scale-free cost with members that are lengths in the
///   mesh's unit: puts `convert(length)` in the place of each. It is called for a copy of the cost,
///   of which faces, vertices and edges are then asked what they leave.
/// - `cost.crease_weight`, a member that can be written to: how much such edges count. Edges at
///   which labels differ, and chart ends of textures, are counted by `crease` with weights of their
///   own.
/// - `cost.squared_error(pair, value)`: a cost as the square of a distance, for Status and Report;
///   without it that is the cost itself.
/// - `cost.tie_break(pair, x)`: what is added to a cost in the order of pairs only, to tell those
///   of equal costs apart, far below any cost that matters. It is on the scale of one cost's
///   values: a class that is derived from Quadric or its kin and has a call of its own does not
///   inherit it (Weighted brings it along); `using TieBreak = MyCost;` says the same of a cost of
///   yours.
/// - `cost.validate()`: throws if the policy makes no sense.
/// - `C::ScaleFree`: the cost does as well in any unit of length, see concepts.h.
/// - `C::TwoLanes`: pairs may be costed two at a time where vertices go to the position of least
///   cost, which is the fast path of Quadric and its kin. `using TwoLanes = MyCost;` in the class
///   MyCost, for this class alone, says that it is scale-free and has values, tie break and
///   minimizer as they have: those of Quadric for `pair.state`, a `QuadricForm<3>`; or of
///   MemorylessQuadric for what its `join` makes of its `Current`, and with `loss(growth, trace)`
///   and `State::planes` of ThinFeatureQuadric as well. What faces, vertices and edges leave or
///   say is its own. Keys are then the same to the rounding of a float.
/// - `cost.degree()`: of a ScaleFree cost, by which power of lengths its values grow, so that stop
///   policies can be told what contractions cost in the mesh's units; a multiple of 1/2. A class
///   that is derived from one with another degree says its own.
/// - `C::face_is_alike_at_corners`: true if face(p, q, r) leaves the same at q and r.
/// - `cost.attribute_weights(low, high, diagonal)`, for costs with attributes: by what these are
///   multiplied before anything sees them, from their least and greatest values and the diagonal
///   of the box of the surface.
/// - `C::State` is `QuadricForm<3>`, or `pair.current.quadric` is one that others can be added to:
///   channels (channels.h) then count in the cost; beside other costs they are carried along.
/// - `C::channel_weight(area)`: how much a face counts for channels; without it its area.
///
/// **Local terms**, for a cost that looks at the surface as it is now, as MemorylessQuadric does:
///
/// - `C::Current`: what the faces around a vertex say now, a semiregular type with `+=` and `-=`.
/// - `cost.current_face(p, q, r)`: what a face says at each of its corners, about that corner.
/// - `cost.current_boundary(p, q, r)`: what the boundary edge pq of the face pqr says at both ends.
/// - `C::PairCurrent` and `cost.join(first, second, shared, d)`: of a pair, about its first end,
///   from what both ends say and the faces that they share; d leads from the first to the second
///   end. The pair then has it as `pair.current`.
/// - `C::tolerated_rise`: a pair whose cost has risen by no more than this factor while it waited
///   is contracted all the same; without it 1.
/// - `cost.unevenness(current)` with `C::tolerated_fall`: where that number falls by more than this
///   factor, the pairs of the vertex are costed anew.
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

/// **Placement**: where does the contracted vertex go?
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** OptimalPlacement, EndpointPlacement, MidpointPlacement, VolumeKeeping, OuterHull,
/// InnerHull.
///
/// **Requirements**, for a constant `placement`:
///
/// - `placement(cost, pair)`: a position, a Vector of the cost's dimension. `pair.first` and
///   `pair.second` are the ends, `pair.squared_reach` is how far their farthest neighbour is,
///   squared; `cost(pair, x)` tells what a position costs and, where the cost has one,
///   `cost.minimizer(pair)` an optional position of least cost; `pair.state` is there if the cost
///   is not ScaleFree, or the placement itself is.
/// - Not checked: the position is finite. One that is not is refused, as Rejection::position.
///
/// **Used where there**:
///
/// - `placement.any_equal(cost, pair, x, predicate)`: tries other positions that cost what x does,
///   where filters refuse x: see OptimalPlacement.
/// - `P::asks_for_indices`, true: `pair.first_index` and `pair.second_index` tell which vertices of
///   the input the ends are: see FilterPolicy.
/// - `P::asks_for_volume`, true: Report::volume_before and volume_after are told.
/// - `P::needs_closed_surface`, true: a surface is refused of which an edge has not as many faces
///   on one side as on the other.
/// - `placement.is_optimal()`, for a choice at run time that may be OptimalPlacement: does this one
///   take the position of least cost? It may then be computed for two pairs at once.
/// - `placement.validate()`: throws if the policy makes no sense.
/// - `P::ScaleFree`: the placement does as well in any unit of length, see concepts.h.
///
/// **Also used**, in a scale-free placement that says `static constexpr bool looks_at_star = true`:
///
/// - `placement.settle(cost, pair, star)`: an optional position once the faces around the pair are
///   known, all of them: `star.for_each_face(visit)` calls visit(p, q, r) with the corners of each.
/// - `placement.admits(pair, star, x)`: the last word on each position that is tried.
/// - `P::cause`: the Rejection that counts where it says no, or where there is no position.
/// - `placement.any_further(cost, pair, star, predicate)`: tries others then.
/// - `P::Guess`: a placement by which pairs are ordered until their turn, and `P::rise_of_guess`,
///   what to multiply its costs with. The call itself, `placement(cost, pair)`, is that guess.
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

/// **Pairs**: which pairs of vertices may ever be contracted?
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** EdgePairs, ThresholdPairs.
///
/// **Requirements**, for a constant `pairs`:
///
/// - `pairs(surface, emit)`: selects pairs by calls `emit(i, j)`, and returns nothing. `surface` is
///   a SurfaceView, `emit` an EmitPair.
/// - Not checked: i and j are indices of points of the view. Others make std::out_of_range.
///
/// **Used where there**:
///
/// - `static constexpr bool includes_edges = true`: every edge is a pair as well, now and later.
///   Without it only the emitted pairs and what becomes of them are.
/// - `static constexpr bool ignores_indices = true`: the points of a large surface may come in
///   another order than the user's.
/// - `pairs.validate()`: throws if the policy makes no sense.
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

/// **Stop**: is this enough? Asked before each contraction.
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
/// - `S::needs`, a constant Needs: which numbers of the Status those of its type may look at that
///   are found out only for those that need them. `static constexpr Needs needs = {.cost = true};`
/// - `stop.needs_now()`, beside it: the Needs of this one, a part of those. One type then serves
///   with a limit and without, which pays for no distances. Without it all of the type need all.
/// - A pair that only Status::next_distance, next_distance_back or next_tolerance makes it stop at
///   is refused, and the search goes on. Where it stops at a next_cost it has to stop at all
///   greater ones.
/// - `stop.is_passed(status)`: is a surface of this status beyond the target and not just at it?
///   The engine then looks for a pair that meets the target exactly.
/// - `stop.validate()`: throws if the policy makes no sense.
///
/// **The least model** is a lambda: `[](const Status& status) { return status.faces < 1000; }`
template <class S>
concept StopPolicy = std::copy_constructible<S> && requires(const S stop, const Status status) {
  { stop(status) } -> std::convertible_to<bool>;
};

/// **Filter**: may this contraction be done? Asked just before it; any number of filters work
/// together.
///
/// **Refines** `std::copy_constructible`.
///
/// **Has models** NormalFlip, SmallestAngle, LongestEdge, HighestDegree and
/// HeightField. NoSelfIntersection and NormalDeviation are none: they have to follow contractions,
/// which a filter does not see: see GuardPolicy in <quadrille/guard.h>.
///
/// **Requirements**, for a constant `filter`:
///
/// - `filter.allows(contraction)`: a bool. `contraction.faces()` are the faces that change, each
///   with its moving corner `before` and `after` and its others, `second` and `third`; at a vertex
///   of more than 128 faces that stays in its place, of its own only those beside the others;
///   `contraction.target()` is the new position; `contraction.highest_degree()` is that of the
///   pair's ends, in faces; `contraction.makes_fold()` tells whether a face would come to lie over
///   a neighbour.
/// - What it is about, by indices in the input: the pair's ends are `contraction.first()` and
///   `contraction.second()`, `face.index` is that of a face that changes, and
///   `contraction.removed_faces()` has those of the faces that go;
///   `contraction.for_each_gone(visit)` calls visit(f) for each of these, with its `f.corners`
///   before the contraction and `f.index`. Corners are in the order of the face: (before, second,
///   third) of one that stays. A soup's are its own; vertices and faces of a mesh are counted from
///   0 in the order of `vertices(mesh)` and `faces(mesh)`; of points that SplitVertices joins, the
///   places are, in the order of the first one at each. A vertex that others have become part of
///   has the index of one of them. They cost nothing where they are not asked for.
///
/// **Used where there**:
///
/// - `F::cause`: the Rejection that counts where it says no; Rejection::filter without it.
/// - `filter.validate()`: throws if the policy makes no sense.
/// - `F::ScaleFree`: the filter does as well in any unit of length, see concepts.h.
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
