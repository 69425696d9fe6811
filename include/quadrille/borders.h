#ifndef QUADRILLE_BORDERS_H
#define QUADRILLE_BORDERS_H

#include <quadrille/internal/core/base/function_name.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/surface/thinned_line.h>
#include <quadrille/internal/planar/border_lines.h>
#include <quadrille/pairs.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace quadrille {

namespace internal {

/// Which vertices of the borders go, by their indices in the input. Filled in when pairs are
/// selected, and read by policies that share it.
class ThinnedBorders {
public:
  explicit ThinnedBorders(double tolerance) : tolerance_(tolerance) {}

  void select(const SurfaceView& surface, const EmitPair& emit) {
    goes_.assign(surface.points.size(), false);
    count_ = 0;
    const BorderLines borders(surface);
    for (const std::vector<Index>& line : borders.lines()) {
      const std::vector<bool> stays = ThinnedLine::of(surface.points, line, tolerance_);
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
  double tolerance_;
  std::vector<bool> goes_;
  std::size_t count_ = 0;
};

/// The edges of the border at which one end goes.
struct ThinnedBorderPairs {
  ThinnedBorders* borders;
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    borders->select(surface, emit);
  }
};

/// The end that stays; the cheaper one where both go.
struct ThinnedBorderPlacement {
  using ScaleFree = ThinnedBorderPlacement;
  static constexpr bool asks_for_indices = true;
  const ThinnedBorders* borders;

  auto operator()(const auto& cost, const auto& pair) const {
    const bool first_goes = borders->goes(pair.first_index);
    if (first_goes != borders->goes(pair.second_index))
      return first_goes ? pair.second : pair.first;
    return EndpointPlacement{}(cost, pair);
  }
};

/// Two that stay are not contracted.
struct ThinnedBorderFilter {
  using ScaleFree = ThinnedBorderFilter;
  static constexpr Rejection cause = Rejection::constraint;
  const ThinnedBorders* borders;

  bool allows(const auto& contraction) const {
    return borders->goes(contraction.first()) || borders->goes(contraction.second());
  }
};

/// Until all are gone that go. It is about borders, and no count of a surface that has no faces.
struct ThinnedBorderStop {
  const ThinnedBorders* borders;
  bool operator()(const Status& status) const {
    return status.faces > 0 && status.vertices + borders->count() <= status.initial_vertices;
  }
};

/// Calls run(policies...) with what thins out borders.
template <class Run>
Report thin_borders(double tolerance, Run run) {
  if (!(tolerance >= 0))
    throw std::invalid_argument("quadrille::simplify_borders: the tolerance " + text_of(tolerance) +
                                " is not a distance");
  ThinnedBorders borders(tolerance);
  return in_name_of("simplify_borders", [&] {
    return run(Quadric{}, ThinnedBorderPlacement{&borders}, ThinnedBorderPairs{&borders},
               ThinnedBorderStop{&borders}, ThinnedBorderFilter{&borders}, Topology::kept);
  });
}

} // namespace internal

inline namespace QUADRILLE_THREADING {

/// Thins out the open borders of a mesh, and changes nothing else: neighbours that have the same
/// border get the same one, to the bit, each simplified by itself and whatever it looks like
/// inside. So the tiles of a terrain, whose borders are constrained afterwards, fit without gaps
/// and need not keep all vertices of their borders.
///
/// The border is cut into lines at vertices that are constrained and at those that have not two
/// edges of the border; constrain those at which a third tile begins. Of a line the vertices stay
/// without which another one would be further from it than `tolerance`, in the mesh's units
/// (Douglas and Peucker); the others are contracted into their neighbours along the border. A loop
/// without constrained vertices keeps three at least. Inner vertices stay where they are, and so do
/// all that is left of the border.
///
/// The other arguments are those of simplify but for cost, placement, pairs, stop and topology,
/// which is kept: filters, channels, labels, an order and named parameters. StopReason::target_met
/// says that all are gone that had to go, so that the border depends on nothing but itself. Else a
/// filter or the topology holds some of them (Report::rejections counts): constrain these in all
/// tiles, or allow more.
///
/// Time O(n log n) as a rule. Throws std::invalid_argument for a tolerance that is negative or not
/// a number, and what simplify throws.
template <class Mesh, class... Arguments>
requires internal::FaceGraph<Mesh> Report simplify_borders(Mesh& mesh, double tolerance,
                                                           const Arguments&... arguments) {
  return internal::thin_borders(tolerance, [&](const auto&... policies) {
    return simplify(mesh, policies..., arguments...);
  });
}

/// The same of a polygon soup, as simplify takes one.
template <class Points, class Triangles, class... Arguments>
Report simplify_borders(Points&& points, Triangles&& triangles, double tolerance,
                        const Arguments&... arguments) {
  return internal::thin_borders(tolerance, [&](const auto&... policies) {
    return simplify(std::forward<Points>(points), std::forward<Triangles>(triangles), policies...,
                    arguments...);
  });
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_BORDERS_H
