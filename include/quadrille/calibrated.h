#ifndef QUADRILLE_CALIBRATED_H
#define QUADRILLE_CALIBRATED_H

#include <quadrille/distance.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_distance.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/report.h>
#include <quadrille/simplified.h>
#include <quadrille/stop.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// Simplifies as far as a measured distance allows.

namespace quadrille {

/// The result of `calibrated` for a mesh.
template <class Mesh>
struct Calibrated {
  Mesh mesh;         ///< the simplified copy
  Report report;     ///< the report of its run; Report::hausdorff_bound is the proven bound
  double factor = 1; ///< the multiple of the limit with which it ran
};

/// The result of `calibrated` for a soup.
template <class Points, class Triangles>
struct CalibratedSoup {
  Points points;       ///< the points of the simplified copy
  Triangles triangles; ///< the triangles of the simplified copy
  Report report;       ///< the report of its run; Report::hausdorff_bound is the proven bound
  double factor = 1;   ///< the multiple of the limit with which it ran
};

/// Options of the search in calibrated().
struct Calibration {
  double largest_factor = 64; ///< the largest multiple of the limit that is tried, at least 1
  int refinements = 2;        ///< bisections between the last two powers of two
  double error = 0.05;        ///< error of the measurement as a fraction of the limit, in (0, 1)

  /// Throws std::invalid_argument if a member is out of its range.
  void validate() const {
    if (!(largest_factor >= 1 && std::isfinite(largest_factor) && refinements >= 0 && error > 0 &&
          error < 1))
      throw std::invalid_argument(
          "quadrille::Calibration: the largest factor is less than 1, the number of "
          "refinements is negative, or the error is not in (0, 1)");
  }
};

namespace internal {

/// Returns a bound on the distance of the two surfaces that is at most `error` too large, if both
/// are proven to be within `distance` of each other; otherwise infinity. Samples reject surfaces
/// that are clearly further apart.
inline double proved_distance(const SurfaceView& a, const SurfaceView& b, double distance,
                              double error) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (b.triangles.empty() ||
      surface_distance(a.points, a.triangles, b.points, b.triangles, {.samples = 20'000})
              .hausdorff > distance)
    return infinity;
  CheckProgress progress({}, 1);
  const CheckedDistance apart(a, {}, b, progress);
  const double bound =
      (std::max)(apart.of_input(error).distance, apart.of_result(error).distance) + error;
  return bound <= distance ? bound : infinity;
}

/// Returns the coarsest result of run(factor), with its report and factor, for which measuring
/// proves that surface_of(result) is within the limit itself. run(factor) simplifies the input with
/// a multiple of the limit.
template <class Run, class SurfaceOf>
auto calibrate(const SurfaceView& input, double distance, const Calibration& calibration, Run run,
               SurfaceOf surface_of) {
  auto best = run(1.0);
  if (!(distance > 0) || best.report.stop != StopReason::target_met)
    return best;
  const auto try_with = [&](double factor) {
    auto next = run(factor);
    if (next.report.faces_after >= best.report.faces_after)
      return false;
    const double bound =
        proved_distance(input, surface_of(next), distance, calibration.error * distance);
    if (!(bound <= distance))
      return false;
    next.report.distance_bound = next.report.hausdorff_bound = bound;
    best = std::move(next);
    return true;
  };
  double factor = 2;
  while (factor <= calibration.largest_factor && try_with(factor))
    factor *= 2;
  if (factor > calibration.largest_factor)
    return best;
  double step = factor / 4; // the smallest factor known to be too large
  for (int i = 0; i < calibration.refinements; ++i, step /= 2)
    if (!try_with(factor - step))
      factor -= step;
  return best;
}

/// Returns the distance that a limit allows for a surface.
inline double allowed_distance(const HausdorffLimit& limit, const SurfaceView& surface) {
  return limit.distance(surface.triangles.empty() ? 0 : diagonal(box_of(surface)));
}

} // namespace internal

/// Returns a simplified copy of a mesh that is within a limit in both directions, with about as few
/// faces as possible. Measuring proves the limit; the bound is not accumulated.
///
/// The bound of a HausdorffLimit accumulates the displacement of each contraction and is several
/// times the measured distance. So this function runs with 2, 4, 8, … times the limit as long as
/// the measured result is within the limit itself (Calibration::error is the error of the
/// measurement), then bisects between the last two factors. It returns the coarsest result within
/// the limit. The run with the limit itself needs no measurement. The arguments are those of
/// `simplified`; maps that `simplify` writes to, and visitors, see each run.
///
/// Complexity: up to log₂ of the largest factor + refinements + 1 runs, and as many measurements,
/// which take longer. Throws whatever `simplified` throws, and std::invalid_argument for a surface
/// that cannot be measured: see verify().
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh,
          class... Arguments>
requires internal::FaceGraph<Mesh> Calibrated<Mesh> calibrated(const Mesh& mesh,
                                                               HausdorffLimit limit,
                                                               const Calibration& calibration,
                                                               const Arguments&... arguments) {
  limit.validate();
  calibration.validate();
  const auto surface_of = [](const Mesh& of) {
    return internal::checked_surface("quadrille::calibrated", of);
  };
  const TriangleSoup<> input = surface_of(mesh);
  return internal::calibrate(
      input, internal::allowed_distance(limit, input), calibration,
      [&](double factor) {
        auto [coarse, report] =
            simplified<Cost, Placement>(mesh, limit.times(factor), arguments...);
        return Calibrated<Mesh>{std::move(coarse), report, factor};
      },
      [&](const Calibrated<Mesh>& coarse) { return surface_of(coarse.mesh); });
}

/// Runs with the default calibration.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Mesh>
requires internal::FaceGraph<Mesh> Calibrated<Mesh> calibrated(const Mesh& mesh,
                                                               HausdorffLimit limit) {
  return calibrated<Cost, Placement>(mesh, limit, Calibration{});
}

/// Calibrates a soup, which may be non-manifold: points with x(), y() and z(), or three numbers by
/// index, and triples of indices. Pass no maps or vectors of channels and labels: each run would
/// write to them.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles, class... Arguments>
requires internal::ReadableSoup<Points, Triangles> CalibratedSoup<Points, Triangles>
calibrated(const Points& points, const Triangles& triangles, HausdorffLimit limit,
           const Calibration& calibration, const Arguments&... arguments) {
  limit.validate();
  calibration.validate();
  const auto surface_of = [](const Points& of_points, const Triangles& of_triangles) {
    return internal::checked_surface("quadrille::calibrated", of_points, of_triangles);
  };
  const TriangleSoup<> input = surface_of(points, triangles);
  using Coarse = CalibratedSoup<Points, Triangles>;
  return internal::calibrate(
      input, internal::allowed_distance(limit, input), calibration,
      [&](double factor) {
        auto [p, t, report] =
            simplified<Cost, Placement>(points, triangles, limit.times(factor), arguments...);
        return Coarse{std::move(p), std::move(t), report, factor};
      },
      [&](const Coarse& coarse) { return surface_of(coarse.points, coarse.triangles); });
}

/// Runs on a soup with the default calibration.
template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Points,
          class Triangles>
requires internal::ReadableSoup<Points, Triangles> CalibratedSoup<Points, Triangles>
calibrated(const Points& points, const Triangles& triangles, HausdorffLimit limit) {
  return calibrated<Cost, Placement>(points, triangles, limit, Calibration{});
}

} // namespace quadrille

#endif // QUADRILLE_CALIBRATED_H
