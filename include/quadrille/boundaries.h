#ifndef QUADRILLE_BOUNDARIES_H
#define QUADRILLE_BOUNDARIES_H

#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/base/function_name.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/thinned_line.h>
#include <quadrille/internal/planar/boundary_lines.h>
#include <quadrille/pairs.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille {

namespace internal {

/// Lists the boundary vertices that are to be removed, by their indices in the input. It is filled
/// when pairs are selected, and the policies that share it read it.
class ThinnedBoundaries {
public:
  explicit ThinnedBoundaries(const DistanceLimit& limit) : limit_(limit) {}

  void select(const SurfaceView& surface, const EmitPair& emit) {
    goes_.assign(surface.points.size(), false);
    count_ = 0;
    const double tolerance = limit_.distance(Box<3>(surface.points).diagonal());
    const BoundaryLines boundaries(surface);
    for (const std::vector<Index>& line : boundaries.lines()) {
      const std::vector<bool> stays = ThinnedLine::of(surface.points, line, tolerance);
      for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        if (stays[i])
          continue;
        goes_[line[i]] = true;
        ++count_;
        emit(line[i - 1], line[i]);
        emit(line[i], line[i + 1]);
      }
    }
  }
  bool goes(std::size_t vertex) const { return goes_[vertex]; }
  std::size_t count() const { return count_; }

private:
  DistanceLimit limit_;
  std::vector<bool> goes_;
  std::size_t count_ = 0;
};

/// Selects the boundary edges of which at least one end is to be removed.
struct ThinnedBoundaryPairs {
  ThinnedBoundaries* boundaries;
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    boundaries->select(surface, emit);
  }
};

/// Returns the end that stays; where both are to be removed, the cheaper one.
struct ThinnedBoundaryPlacement {
  using ScaleFree = ThinnedBoundaryPlacement;
  static constexpr bool asks_for_indices = true;
  const ThinnedBoundaries* boundaries;

  auto operator()(const auto& cost, const auto& pair) const {
    const bool first_goes = boundaries->goes(pair.first_index);
    if (first_goes != boundaries->goes(pair.second_index))
      return first_goes ? pair.second : pair.first;
    return EndpointPlacement{}(cost, pair);
  }
};

/// Rejects a contraction of two vertices that both stay.
struct ThinnedBoundaryFilter {
  using ScaleFree = ThinnedBoundaryFilter;
  static constexpr Rejection cause = Rejection::constraint;
  const ThinnedBoundaries* boundaries;

  bool allows(const auto& contraction) const {
    return boundaries->goes(contraction.first()) || boundaries->goes(contraction.second());
  }
};

/// Stops once all vertices that are to be removed are gone. It concerns the boundary only: it does
/// not count the faces of a surface.
struct ThinnedBoundaryStop {
  const ThinnedBoundaries* boundaries;
  bool operator()(const Status& status) const {
    return status.faces > 0 && status.vertices + boundaries->count() <= status.initial_vertices;
  }
};

/// Calls run(policies...) with the policies that simplify the boundary.
template <class Run>
Report thin_boundaries(const DistanceLimit& limit, Run run) {
  limit.validate();
  ThinnedBoundaries boundaries(limit);
  return in_name_of("simplify_boundaries", [&] {
    return run(Quadric{}, ThinnedBoundaryPlacement{&boundaries}, ThinnedBoundaryPairs{&boundaries},
               ThinnedBoundaryStop{&boundaries}, ThinnedBoundaryFilter{&boundaries},
               Topology::kept);
  });
}

} // namespace internal

inline namespace QUADRILLE_THREADING {

/// Simplifies the open boundary of a mesh, and changes nothing else. Two meshes with the same
/// boundary get bit-identical new boundaries, although each is simplified by itself and whatever
/// its interior is. So adjacent tiles of a terrain fit without gaps once their boundaries are
/// constrained, and need not keep all boundary vertices.
///
/// The boundary is cut into lines at constrained vertices and at vertices that do not have exactly
/// two boundary edges; constrain the vertices at which a third tile begins. A line keeps the
/// vertices that are needed so that no removed vertex is further from it than `limit` (Douglas and
/// Peucker). A relative limit is a fraction of the diagonal of this surface: adjacent tiles need
/// the same distance. The other vertices are contracted into their neighbours along the boundary. A
/// loop without constrained vertices keeps at least three. Inner vertices and the boundary vertices
/// that are left do not move.
///
/// The other arguments are those of simplify except cost, placement, pairs, stop and topology:
/// filters, channels, labels, an order and named parameters. The topology is kept.
/// StopReason::target_met means that every vertex that was to be removed is gone, so that the new
/// boundary depends on the old boundary only. Otherwise a filter or the topology rejected some
/// contractions (Report::rejections counts them): constrain these vertices in all tiles, or relax
/// the filters.
///
/// The expected time is O(n log n). Throws std::invalid_argument for a limit that is negative or
/// not a number, and whatever simplify throws.
template <class Mesh, class... Arguments>
requires internal::FaceGraph<Mesh> Report simplify_boundaries(Mesh& mesh,
                                                              const DistanceLimit& limit,
                                                              const Arguments&... arguments) {
  return internal::thin_boundaries(
      limit, [&](const auto&... policies) { return simplify(mesh, policies..., arguments...); });
}

/// Simplifies the open boundary of a polygon soup, which it takes as simplify does.
template <class Points, class Triangles, class... Arguments>
Report simplify_boundaries(Points&& points, Triangles&& triangles, const DistanceLimit& limit,
                           const Arguments&... arguments) {
  return internal::thin_boundaries(limit, [&](const auto&... policies) {
    return simplify(std::forward<Points>(points), std::forward<Triangles>(triangles), policies...,
                    arguments...);
  });
}

/// Rejects, at compile time, a number in the place of the limit.
template <class... Arguments>
requires(std::is_arithmetic_v<std::remove_cvref_t<Arguments>> || ...) Report
    simplify_boundaries(Arguments&&...) {
  static_assert(sizeof...(Arguments) == 0,
                "A number does not say what it limits: write DistanceLimit{0.1} or "
                "DistanceLimit::relative(0.001).");
  return {};
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_BOUNDARIES_H
