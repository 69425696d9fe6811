#ifndef QUADRILLE_INTERNAL_CORE_CALL_DIAGNOSTICS_H
#define QUADRILLE_INTERNAL_CORE_CALL_DIAGNOSTICS_H

#include <quadrille/concepts.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/arguments.h>
#include <quadrille/internal/core/call/meshes.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>

/// Compiler messages for wrong calls of `simplify`. `simplify` takes arguments of any type, so that
/// a sentence here, before any other message, reports what is wrong with them; and it exists, but
/// does not compile, for surfaces that cannot be changed and for objects that are no surfaces.

namespace quadrille {
class Levels;
}

namespace quadrille::internal {

/// A filter or a stop policy but for a const that it lacks.
template <class Argument, class Cost>
concept FilterThatChanges = requires(
    Argument filter, const typename SeenByFilter<Argument, Cost>::Contraction contraction) {
  { filter.allows(contraction) } -> std::convertible_to<bool>;
};
template <class Argument>
concept StopThatChanges = requires(Argument stop, const Status status) {
  { stop(status) } -> std::convertible_to<bool>;
};

/// A stop predicate of CGAL::Surface_mesh_simplification.
template <class Argument>
concept StopOfCgal = requires(const Argument stop, double cost, std::size_t edges) {
  { stop(cost, 0, edges, edges) } -> std::convertible_to<bool>;
};

/// Is an argument of a kind but for one thing, or what goes into another one?
template <class Argument, class Cost>
concept NearlyKnown = IsOptional<Argument> || std::same_as<Argument, Levels> ||
    StopOfCgal<Argument> || FilterThatChanges<Argument, Cost> || StopThatChanges<Argument>;

/// Does not compile, for an argument that is NearlyKnown, and says what is missing.
template <class Argument, class Call>
void reject_nearly_known() {
  constexpr bool is_levels = std::same_as<Argument, Levels>;
  constexpr bool is_stop_of_cgal = StopOfCgal<Argument>;
  constexpr bool is_optional = IsOptional<Argument>;
  static_assert(!is_optional,
                "This std::optional contains no policy that may be chosen at run time. Costs, "
                "placements, channels and SplitVertices are chosen at compile time: pass them "
                "without std::optional.");
  static_assert(!is_levels, "Levels are not a policy: write record_into(levels).");
  static_assert(!is_stop_of_cgal,
                "A stop predicate of CGAL is not a stop policy: write CgalStop(predicate), or "
                "EdgeCount{n}, EdgeRatio{r}.");
  static_assert(
      is_optional || is_levels || is_stop_of_cgal,
      "A filter or stop policy is called as a constant: declare its member function const, "
      "and do not declare a lambda mutable.");
}

/// Does not compile, since an argument is of no kind, and says what it lacks to be of each.
template <class Cost, class UnknownArgument, class Call>
void reject_argument() {
  static_assert(
      AllAreKnown<UnknownArgument>,
      "An argument of this call is not a policy (cost, placement, pairs, stop, order, "
      "filter or guard): see ArgumentIsNoPolicy<position, type> for its position and type.");
  using Argument = typename UnknownArgument::type;
  if constexpr (std::is_arithmetic_v<Argument>) {
    static_assert(!std::is_arithmetic_v<Argument>,
                  "A number does not say what it counts: write FaceCount{1000}, FaceRatio{0.1} or "
                  "DistanceLimit{0.01}.");
  } else if constexpr (LooksLikeCost<Argument>) {
    static_assert(CostPolicy<Argument>, "The argument does not model CostPolicy.");
  } else if constexpr (LooksLikePlacement<Argument, Cost>) {
    static_assert(PlacementPolicy<Argument, Cost>,
                  "The argument does not model PlacementPolicy for the cost of this call.");
  } else if constexpr (std::is_class_v<Argument>) {
    static_assert(PlacementPolicy<Argument, Cost>,
                  "The argument does not model PlacementPolicy for the cost of this call.");
    static_assert(PairPolicy<Argument>, "The argument does not model PairPolicy.");
    static_assert(StopPolicy<Argument>, "The argument does not model StopPolicy.");
    static_assert(FilterPolicy<Argument, Cost>,
                  "The argument does not model FilterPolicy for the cost of this call.");
    static_assert(is_guard<Argument>,
                  "The argument does not model GuardPolicy, which has a member begin(const "
                  "GuardedSurface&) const.");
    static_assert(CostPolicy<Argument>, "The argument does not model CostPolicy.");
  }
}

/// Does not compile, for a surface that cannot be changed; each Call is rejected again. If a
/// function were deleted instead, a compiler would list all others of its name.
template <class... Call>
Report reject_constant() {
  static_assert(
      sizeof...(Call) == 0,
      "simplify cannot change a constant or temporary surface: pass a variable that is not "
      "const, or use simplified, which returns a new surface.");
  return {};
}

/// A container, but none of triangles, nor of their numbers one after the other.
template <class Triangles, class Points>
concept NoTriangles = std::ranges::random_access_range<Triangles> &&
    (!TriangleContainer<std::remove_const_t<Triangles>>)&&(!BufferedSoup<Points, Triangles>)&&(
        !ConstantBuffers<Points, Triangles>);

/// Is the first argument no range, as triangles would be?
template <class... Arguments>
inline constexpr bool has_no_range_first = true;
template <class First, class... Others>
inline constexpr bool has_no_range_first<First, Others...> = !std::ranges::range<First>;

/// Does not compile, for arguments that are not Fitting. `position` is that of the first policy
/// among all arguments, counted from 1; each Call is rejected again.
template <std::size_t position, class Call, class Cost, class Placement, class... Arguments>
Report reject() {
  using UsedCost = CostOf<Cost, Arguments...>;
  using UnknownArgument = Unknown<position, Cost, Arguments...>;
  if constexpr (!CostPolicy<UsedCost>) {
    static_assert(CostPolicy<UsedCost>,
                  "The cost of this call does not model CostPolicy: see <quadrille/concepts.h>.");
  } else if constexpr (!AllAreKnown<UnknownArgument>) {
    if constexpr (NearlyKnown<typename UnknownArgument::type, UsedCost>)
      reject_nearly_known<typename UnknownArgument::type, Call>();
    else
      reject_argument<UsedCost, UnknownArgument, Call>();
  } else {
    static_assert(PlacementPolicy<PlacementOf<Cost, Placement, Arguments...>, UsedCost>,
                  "The placement of this call does not model PlacementPolicy for its cost: see "
                  "<quadrille/concepts.h>.");
  }
  return {};
}

} // namespace quadrille::internal

namespace quadrille {

/// Does not compile, for a mesh that is constant or temporary.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::ReadableGraph<Mesh> Report simplify(const Mesh&, const Arguments&...) {
  return internal::reject_constant<Cost, Placement, Mesh, Arguments...>();
}

/// Does not compile, for a view of a mesh.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Graph,
          class... Arguments>
requires internal::ReadableGraph<Graph> &&
    (!internal::FaceGraph<Graph>)&&(!std::is_const_v<Graph>)Report
    simplify(Graph&, const Arguments&...) {
  static_assert(
      internal::FaceGraph<Graph>,
      "This graph is read-only, like a Face_filtered_graph: simplify the underlying mesh, "
      "with quadrille::parameters::face_is_selected_map for its faces.");
  return {};
}

/// Does not compile, for points without triangles.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class... Arguments>
requires internal::PointContainer<Points> && internal::has_no_range_first<Arguments...>
    Report simplify(Points&, const Arguments&...) {
  static_assert(!internal::PointContainer<Points>,
                "A soup has triangles as well as points: simplify(points, triangles, ...).");
  return {};
}

/// Does not compile, for matrices of other numbers than those of points and of triangles.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::MatrixLike<Points> && internal::MatrixLike<Triangles> &&
    (!internal::BufferedSoup<Points, Triangles>)Report
    simplify(const Points&, const Triangles&, const Arguments&...) {
  static_assert(internal::BufferedSoup<Points, Triangles>,
                "These matrices are not a soup: points consist of float or double, triangles of "
                "integers, and the points come first.");
  return {};
}

/// Does not compile, for points with a container of something else than triangles.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::PointContainer<Points> && internal::NoTriangles<Triangles, Points>
    Report simplify(Points&, Triangles&, const Arguments&...) {
  static_assert(internal::TriangleContainer<Triangles>,
                "Each triangle of a soup has to have three integers by index, such as "
                "std::array<int, 3>: the elements of this container do not.");
  return {};
}

/// Does not compile, for a mesh with arguments, so that CGAL::simplify(x) is not chosen for it.
template <class Mesh>
requires internal::ReadableGraph<Mesh> Report simplify(const Mesh&) {
  return internal::reject_constant<Mesh>();
}

/// Does not compile, for a soup that is constant or temporary.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::PointContainer<Points> && internal::TriangleContainer<Triangles>
    Report simplify(const Points&, const Triangles&, const Arguments&...) {
  return internal::reject_constant<Cost, Placement, Points, Triangles, Arguments...>();
}

/// Does not compile, for buffers.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::ConstantBuffers<Points, Triangles>
    Report simplify(const Points&, const Triangles&, const Arguments&...) {
  return internal::reject_constant<Cost, Placement, Points, Triangles, Arguments...>();
}

} // namespace quadrille

#endif // QUADRILLE_INTERNAL_CORE_CALL_DIAGNOSTICS_H
