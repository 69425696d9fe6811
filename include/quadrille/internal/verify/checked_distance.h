#ifndef QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H
#define QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H

#include <quadrille/internal/verify/allowed_faces.h>
#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/greatest_excess.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

/// Measures how far an input and its result are apart, in both directions, beyond the tolerances of
/// the input's vertices. A face has the least tolerance of its corners.
class CheckedDistance {
public:
  /// Without tolerances, they are 0. Both surfaces must have faces. Throws std::invalid_argument if
  /// the number of tolerances is not the number of input vertices, or if a tolerance is not a
  /// distance.
  CheckedDistance(const SurfaceView& input, const std::vector<double>& tolerances,
                  const SurfaceView& result, CheckProgress& progress)
      : frame_(box_of(input) + box_of(result)), diagonal_(diagonal(box_of(input) + box_of(result))),
        progress_(progress) {
    if (!tolerances.empty())
      require_tolerances(input, tolerances);
    for (const Corners& corners : input.triangles) {
      const double tolerance = tolerance_of(corners, tolerances);
      input_.push_back({triangle(input, corners), frame_.to(tolerance)});
      least_ = (std::min)(least_, tolerance);
    }
    for (const Corners& corners : result.triangles)
      result_.push_back({triangle(result, corners), 0});
  }

  double diagonal_of_both() const { return diagonal_; }
  double least_tolerance() const { return least_; }

  struct Measured {
    double distance;
    Vector<3> place; ///< the point at which it was found
  };

  /// Returns the greatest distance of a point of an input face to the result, beyond the face's
  /// tolerance. The value is at most the true one and less than it by at most `error`; it is 0 if
  /// no point is beyond its tolerance.
  Measured of_input(double error) const { return excess(input_, result_, error); }

  /// Returns by how much, at most, a point of the result is beyond the tolerances of all faces of
  /// the input. The error is as in of_input().
  Measured of_result(double error) const { return excess(result_, input_, error); }

private:
  using Faces = std::vector<AllowedFaces::Face>;

  static void require_tolerances(const SurfaceView& input, const std::vector<double>& tolerances) {
    if (tolerances.size() != input.points.size())
      throw std::invalid_argument(
          "quadrille::verify: the number of tolerances is not the number of vertices of the "
          "input");
    if (std::any_of(tolerances.begin(), tolerances.end(), [](double t) { return !(t >= 0); }))
      throw std::invalid_argument("quadrille::verify: a tolerance is negative or not a number");
  }
  static double tolerance_of(const Corners& corners, const std::vector<double>& of_vertex) {
    if (of_vertex.empty())
      return 0;
    return (std::min)({of_vertex[corners[0]], of_vertex[corners[1]], of_vertex[corners[2]]});
  }

  DistanceTriangle triangle(const SurfaceView& surface, const Corners& corners) const {
    const auto point = [&](std::size_t v) { return frame_.to(distance_point(surface.points[v])); };
    return {point(corners[0]), point(corners[1]), point(corners[2])};
  }

  /// Only one of the two surfaces allows more than 0: the input.
  Measured excess(const Faces& from, const Faces& to, double error) const {
    const AllowedFaces near(to, progress_);
    GreatestExcess greatest(near, (std::max)(frame_.to(error), 0x1p-40), progress_);
    for (const AllowedFaces::Face& face : from)
      greatest.look_at_corners(face.triangle, face.allowance);
    for (std::size_t i = 0; i < from.size(); ++i) {
      progress_.at(static_cast<double>(i) / static_cast<double>(from.size()));
      greatest.look_at(from[i].triangle, from[i].allowance);
    }
    const DistancePoint place = frame_.from(greatest.place());
    return {frame_.from(greatest.greatest()), {{place.x(), place.y(), place.z()}}};
  }

  DistanceFrame frame_;
  double diagonal_, least_ = std::numeric_limits<double>::infinity();
  CheckProgress& progress_;
  Faces input_, result_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECKED_DISTANCE_H
