#ifndef QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H
#define QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H

#include <quadrille/concepts.h>
#include <quadrille/internal/call/arguments.h>
#include <quadrille/internal/call/meshes.h>
#include <quadrille/report.h>

#include <cstddef>
#include <type_traits>

/// What a compiler says of a call of `simplify` that is wrong. `simplify` takes arguments of any
/// type, so that it is told here, in a sentence and before all else, what is wrong with them; and
/// it is declared, but deleted, for surfaces that cannot be changed.

namespace quadrille::internal {

/// Does not compile, since an argument is of no kind, and says what it lacks to be of each.
template <class Cost, class UnknownArgument, class Call>
void refuse_argument() {
  static_assert(AllAreKnown<UnknownArgument>,
                "An argument of this call is no cost, placement, pairs, stop, order or filter: its "
                "position and its type are those of ArgumentIsNoPolicy<position, type>.");
  using Argument = typename UnknownArgument::type;
  if constexpr (std::is_arithmetic_v<Argument>) {
    static_assert(!std::is_arithmetic_v<Argument>,
                  "A number does not tell what it counts: write FaceCount{1000}, FaceRatio{0.1} or "
                  "ErrorLimit{0.01}.");
  } else if constexpr (LooksLikeCost<Argument>) {
    static_assert(CostPolicy<Argument>, "It is no cost.");
  } else if constexpr (LooksLikePlacement<Argument, Cost>) {
    static_assert(PlacementPolicy<Argument, Cost>, "It is no placement.");
  } else if constexpr (std::is_class_v<Argument>) {
    static_assert(PlacementPolicy<Argument, Cost>, "It is no placement.");
    static_assert(PairPolicy<Argument>, "It is no pair policy.");
    static_assert(StopPolicy<Argument>, "It is no stop policy.");
    static_assert(FilterPolicy<Argument, Cost>, "It is no filter.");
    static_assert(CostPolicy<Argument>, "It is no cost.");
  }
}

/// Does not compile, for arguments that are not Fitting. `position` is that of the first policy
/// among all arguments, counted from 1; each Call is refused anew.
template <std::size_t position, class Call, class Cost, class Placement, class... Arguments>
Report refuse() {
  using UsedCost = CostOf<Cost, Arguments...>;
  if constexpr (!CostPolicy<UsedCost>)
    static_assert(CostPolicy<UsedCost>,
                  "The cost of this call is no CostPolicy: see <quadrille/concepts.h>.");
  else if constexpr (!AllAreKnown<Unknown<position, Cost, Arguments...>>)
    refuse_argument<UsedCost, Unknown<position, Cost, Arguments...>, Call>();
  else
    static_assert(PlacementPolicy<PlacementOf<Cost, Placement, Arguments...>, UsedCost>,
                  "The placement of this call is no PlacementPolicy for its cost: see "
                  "<quadrille/concepts.h>.");
  return {};
}

} // namespace quadrille::internal

namespace quadrille {

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::ReadableGraph<Mesh>
void simplify(const Mesh&, // what is constant or temporary cannot be simplified
              const Arguments&...) = delete;

/// Does not compile, for a view of a mesh.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Graph,
          class... Arguments>
requires internal::ReadableGraph<Graph> &&
    (!internal::FaceGraph<Graph>)&&(!std::is_const_v<Graph>)Report
    simplify(Graph&, const Arguments&...) {
  static_assert(internal::FaceGraph<Graph>,
                "This graph can be read only, as a Face_filtered_graph: simplify the mesh that it "
                "is a view of, with quadrille::parameters::face_is_selected_map for its faces.");
  return {};
}

/// The same with nothing but defaults, lest it be taken by CGAL::simplify(x).
template <class Mesh>
requires internal::ReadableGraph<Mesh>
void simplify(const Mesh&) = delete; // what is constant or temporary cannot be simplified

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::PointContainer<Points> && internal::TriangleContainer<Triangles>
void simplify(const Points&, const Triangles&, // what is constant or temporary cannot be simplified
              const Arguments&...) = delete;

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::ConstantBuffers<Points, Triangles>
void simplify(const Points&, const Triangles&, // what is constant or temporary cannot be simplified
              const Arguments&...) = delete;

} // namespace quadrille

#endif // QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H
